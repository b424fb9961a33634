#include "app/window/files/importing.h"

#include "app/canvas/canvas_widget.h"
#include "app/dialogs/fit/fit_dialog.h"
#include "app/session/commands/commands.h"
#include "app/session/commands/underlay_commands.h"
#include "app/session/files/image_layer.h"
#include "app/session/open_painting.h"
#include "app/widgets/asking/choose_picture.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/habits/at_next_change.h"
#include "app/widgets/look/section.h"
#include "app/window/files/file_choice.h"
#include "app/window/files/save_place.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QStatusBar>

namespace suffuse {

Importing::Importing(const Workplace &place, QObject *parent) : QObject(parent), m_place(place)
{
    using enum Command;
    place.commands
        .add(ImportStrokes, "importStrokes", Commands::tr("&Import Strokes…"), "", {},
             Commands::tr("Drawings, recordings and the strokes of other paintings, into this one"))
        .runs([this] { chooseStrokes(); });
    place.commands
        .add(ImportUnderlay, "importUnderlay", Commands::tr("Import &Underlay…"), "", {},
             Commands::tr("A picture to paint over, which shows on the canvas only"))
        .runs([this] {
            if (const QString path = choosePicture(&m_place.window, tr("Import underlay")); !path.isEmpty())
                importUnderlay(path);
        });
    place.commands
        .add(ImportPicture, "importPicture", Commands::tr("Import &Picture as Layer…"), "", {},
             Commands::tr("A picture as a layer among the others: with opacity and mode, and in what is exported"))
        .runs([this] {
            if (const QString path = choosePicture(&m_place.window, tr("Import picture as layer")); !path.isEmpty())
                importPicture(path);
        });
    place.commands
        .add(PictureToStrokes, "pictureToStrokes", Commands::tr("Picture to Stro&kes…"), "", {},
             Commands::tr("Strokes that look like a picture, of a file or the underlay, as a layer"))
        .runs([this] { pictureToStrokes(); });
    connect(&place.canvas, &CanvasWidget::underlayFailed, this,
            [this](const QString &problem) { m_place.window.statusBar()->showMessage(problem, 15'000); });
}

void Importing::chooseStrokes()
{
    if (const Tool *tool = m_place.canvas.tool(); tool && tool->isBusy())
        return;
    const QString path = QFileDialog::getOpenFileName(&m_place.window, tr("Import Strokes"),
                                                      folderNear(m_place.open.editor), openFilter());
    if (!path.isEmpty())
        importStrokes(path);
}

void Importing::importStrokes(const QString &path)
{
    const View &view = m_place.canvas.view();
    const Point middle = view.toCanvas({0.5 * view.width, 0.5 * view.height});
    const Result<ImportReport> report = suffuse::importStrokes(m_place.open.editor, path, middle);
    if (!report) {
        showError(&m_place.window, report.error());
        return;
    }
    m_place.commands[Command::Select].setChecked(true); // it is to be put where it belongs
    if (!report->leftOut.isEmpty())
        sayUntilChange(*m_place.window.statusBar(), m_place.open.editor.document(), report->leftOut);
    if (!report->losses.empty())
        showNotice(&m_place.window,
                   tr("“%1” is damaged. What is whole of it was imported.").arg(QFileInfo(path).fileName()),
                   QStringList(report->losses.begin(), report->losses.end()).join('\n'));
}

void Importing::importUnderlay(const QString &path)
{
    if (const QString problem = underlay::importFile(m_place.open.editor, path); !problem.isEmpty())
        showError(&m_place.window, problem);
}

void Importing::importPicture(const QString &path)
{
    if (const QString problem = image_layer::importFile(m_place.open.editor, path); !problem.isEmpty()) {
        showError(&m_place.window, problem);
        return;
    }
    m_place.commands[Command::Select].setChecked(true); // it is to be put where it belongs
}

void Importing::pictureToStrokes()
{
    m_place.canvas.settleTool();
    m_place.open.playback.pause();
    Editor &editor = m_place.open.editor;
    const bool hasUnderlay = editor.document().painting()->underlay != nullptr;
    const QString path = hasUnderlay ? QString() : choosePictureToFit(&m_place.window, tr("Picture to Strokes"));
    if (!hasUnderlay && path.isEmpty())
        return;
    FitDialog dialog(editor, &m_place.window);
    if (!hasUnderlay && !dialog.takeFile(path)) {
        showError(&m_place.window, dialog.hint()->text());
        return;
    }
    if (dialog.exec() != QDialog::Accepted)
        return;
    m_place.commands[Command::Select].setChecked(true); // it is to be put where it belongs
    if (!dialog.said().isEmpty())
        sayUntilChange(*m_place.window.statusBar(), editor.document(), dialog.said());
}

void Importing::offer(const QStringList &pictures, const QPoint &place)
{
    auto *menu = new QMenu(&m_place.window);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    connect(menu->addAction(tr("Add as &Layer")), &QAction::triggered, this, [this, pictures] {
        for (const QString &picture : pictures)
            importPicture(picture);
    });
    connect(menu->addAction(tr("Use as &Underlay")), &QAction::triggered, this,
            [this, pictures] { importUnderlay(pictures.back()); });
    menu->addSeparator();
    menu->addAction(tr("Cancel"));
    menu->popup(place);
}

} // namespace suffuse
