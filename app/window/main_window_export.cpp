// Exporting the window's painting, by the dialog and once more without it.
#include "app/canvas/canvas_widget.h"
#include "app/dialogs/export_dialog.h"
#include "app/widgets/messages.h"
#include "app/window/main_window.h"

#include <QDir>
#include <QFileInfo>
#include <QStatusBar>

namespace suffuse {

void MainWindow::addExportRows()
{
    m_commands
        ->add(Command::Export, "export", Commands::tr("&Export…"), "export",
              {QKeySequence(Commands::tr("Ctrl+Shift+E"))})
        .runs([this] { exportPicture(); });
    m_commands
        ->add(Command::ExportAgain, "exportAgain", Commands::tr("Export A&gain"), "",
              {QKeySequence(Commands::tr("Ctrl+E"))}, Commands::tr("To the same file, with the same settings"))
        .when([this] { return !m_exportJob->isRunning(); })
        .runs([this] { exportAgain(); });
    connect(&m_editor, &Editor::opened, this, [this] {
        const auto last = exports::lastOf(m_editor.filePath());
        m_lastExport = last ? std::make_unique<ExportSettings>(*last) : nullptr;
    });
    m_exportJob = new ExportJob(this);
    connect(m_exportJob, &ExportJob::finished, this, [this](bool written, const QString &error) {
        m_commands->update(Command::ExportAgain);
        statusBar()->clearMessage();
        if (written)
            statusBar()->showMessage(tr("Exported to %1").arg(QDir::toNativeSeparators(m_exportJob->path())), 8'000);
        else if (!error.isEmpty())
            showError(this, error);
    });
}

void MainWindow::exportPicture()
{
    ExportDialog dialog(m_editor, shownArea(m_canvas->view()), this);
    if (m_lastExport)
        dialog.restore(*m_lastExport);
    if (dialog.exec() == QDialog::Accepted)
        m_lastExport = std::make_unique<ExportSettings>(dialog.settings());
}

void MainWindow::exportAgain()
{
    if (!m_lastExport) { // there is nothing to do again yet
        exportPicture();
        return;
    }
    const Result<ExportOrder> order = exportOrder(*m_lastExport, m_editor, shownArea(m_canvas->view()));
    if (!order) {
        showError(this, order.error());
        return;
    }
    statusBar()->showMessage(tr("Exporting %1…").arg(QFileInfo(order->path).fileName()));
    m_exportJob->start(*order);
    m_commands->update(Command::ExportAgain); // until this one is done
}

} // namespace suffuse
