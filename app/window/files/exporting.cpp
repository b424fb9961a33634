#include "app/window/files/exporting.h"

#include "app/canvas/canvas_widget.h"
#include "app/dialogs/export/drawing_dialog.h"
#include "app/dialogs/export/export_dialog.h"
#include "app/dialogs/export/timelapse_dialog.h"
#include "app/dialogs/print/print_dialog.h"
#include "app/session/commands/session_rows.h"
#include "app/widgets/asking/messages.h"

#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLineEdit>
#include <QMainWindow>
#include <QStatusBar>

namespace suffuse {

Exporting::Exporting(const Workplace &place, QObject *parent)
    : QObject(parent), m_place(place), m_job(new ExportJob(this))
{
    addRows();
    connect(&place.open.editor, &Editor::opened, this, &Exporting::takeLast);
    connect(m_job, &ExportJob::finished, this, &Exporting::showOutcome);
    takeLast();
}

Exporting::~Exporting() = default;

void Exporting::addRows()
{
    using enum Command;
    Commands &table = m_place.commands;
    table.add(Export, "export", Commands::tr("&Export…"), "export", {QKeySequence(Commands::tr("Ctrl+Shift+E"))})
        .runs([this] { exportPicture(); });
    table
        .add(ExportAgain, "exportAgain", Commands::tr("Export A&gain"), "", {QKeySequence(Commands::tr("Ctrl+E"))},
             Commands::tr("To the same file, with the same settings"))
        .when([this] { return !m_job->isRunning(); }, Commands::tr("An export is still under way."))
        .runs([this] { exportAgain(); });
    table
        .add(ExportDrawing, "exportDrawing", Commands::tr("Export &Drawing…"), "", {},
             Commands::tr("Exact outlines and bands of paint for Inkscape, plotters and browsers (SVG)"))
        .when(anyStrokes(m_place.open.editor))
        .runs([this] { exportDrawing(); });
    table
        .add(ExportTimelapse, "exportTimelapse", Commands::tr("Export Ti&melapse…"), "film",
             {QKeySequence(Commands::tr("Ctrl+Alt+E"))}, Commands::tr("Make a film of the painting being painted"))
        .when(anyStrokes(m_place.open.editor))
        .runs([this] { exportTimelapse(); });
    table
        .add(Print, "print", Commands::tr("Prin&t…"), "print", QKeySequence::keyBindings(QKeySequence::Print),
             Commands::tr("On paper, or as a page of a PDF file"))
        .runs([this] { print(false); });
    table
        .add(PrintPreview, "printPreview", Commands::tr("Print Previe&w…"), "", {},
             Commands::tr("See the page in large before it is printed"))
        .runs([this] { print(true); });
}

void Exporting::takeLast()
{
    const auto last = exports::lastOf(m_place.open.editor.filePath());
    m_last = last ? std::make_unique<ExportSettings>(*last) : nullptr;
}

void Exporting::showOutcome(bool written, const QString &error)
{
    m_place.commands.update(Command::ExportAgain);
    m_place.window.statusBar()->clearMessage();
    if (written)
        sayWritten(m_job->path());
    else if (!error.isEmpty())
        showError(&m_place.window, error);
}

void Exporting::sayWritten(const QString &path)
{
    m_place.window.statusBar()->showMessage(tr("Exported to %1").arg(QDir::toNativeSeparators(path)), 8'000);
}

void Exporting::exportTimelapse()
{
    m_place.canvas.settleTool();
    m_place.open.playback.pause();
    TimelapseDialog dialog(m_place.open.editor, shownArea(m_place.canvas.view()), &m_place.window);
    if (dialog.exec() == QDialog::Accepted)
        sayWritten(dialog.path()->text());
}

void Exporting::exportDrawing()
{
    m_place.canvas.settleTool();
    DrawingDialog dialog(m_place.open.editor, &m_place.window);
    if (dialog.exec() == QDialog::Accepted)
        sayWritten(dialog.path()->text());
}

void Exporting::print(bool inLarge)
{
    m_place.canvas.settleTool();
    PrintDialog dialog(m_place.open.editor, shownArea(m_place.canvas.view()), &m_place.window);
    if (inLarge)
        dialog.enlarge();
    if (dialog.exec() != QDialog::Accepted)
        return;
    if (dialog.printsToFile())
        m_place.window.statusBar()->showMessage(tr("Printed to %1").arg(QDir::toNativeSeparators(dialog.path()->text())),
                                                8'000);
    else
        m_place.window.statusBar()->showMessage(tr("Given to the printer %1").arg(dialog.printer()->currentText()),
                                                8'000);
}

void Exporting::exportPicture()
{
    m_place.canvas.settleTool();
    ExportDialog dialog(m_place.open.editor, shownArea(m_place.canvas.view()), &m_place.window);
    if (m_last)
        dialog.restore(*m_last);
    if (dialog.exec() != QDialog::Accepted)
        return;
    m_last = std::make_unique<ExportSettings>(dialog.settings());
    sayWritten(m_last->path);
}

void Exporting::exportAgain()
{
    if (!m_last) { // there is nothing to do again yet
        exportPicture();
        return;
    }
    m_place.canvas.settleTool();
    const Result<ExportOrder> order = exportOrder(*m_last, m_place.open.editor, shownArea(m_place.canvas.view()));
    if (!order) {
        showError(&m_place.window, order.error());
        return;
    }
    m_place.window.statusBar()->showMessage(tr("Exporting %1…").arg(QFileInfo(order->path).fileName()));
    m_job->start(*order);
    m_place.commands.update(Command::ExportAgain); // until this one is done
}

} // namespace suffuse
