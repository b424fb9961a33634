// What the Time menu does.
#include "app/canvas/canvas_widget.h"
#include "app/dialogs/timelapse_dialog.h"
#include "app/session/commands/session_rows.h"
#include "app/session/playback.h"
#include "app/window/main_window.h"
#include "undo/time_edits.h"

#include <QInputDialog>

namespace suffuse {

void MainWindow::addTimeRows()
{
    m_commands
        ->add(Command::Rewet, "rewet", Commands::tr("Re-&wet…"), "rewet", {QKeySequence(Commands::tr("Ctrl+Alt+W"))},
              Commands::tr("Let the selected paint spread on for a while from this moment"))
        .when(anySelected(m_editor))
        .runs([this] { rewetSelected(); });
    m_commands
        ->add(Command::ExportTimelapse, "exportTimelapse", Commands::tr("Export Ti&melapse…"), "film",
              {QKeySequence(Commands::tr("Ctrl+Alt+E"))}, Commands::tr("Make a film of the painting being painted"))
        .when(anyStrokes(m_editor))
        .runs([this] {
            m_playback->pause();
            TimelapseDialog(m_editor, shownArea(m_canvas->view()), this).exec();
        });
    connect(&m_editor.clock(), &PaintingClock::pastChanged, this, &MainWindow::showHint);
}

void MainWindow::rewetSelected()
{
    constexpr double usualSeconds = 1, mostSeconds = 1e6;
    const Microseconds now = m_editor.clock().time(); // the dialog takes its time
    bool ok = false;
    const double seconds = QInputDialog::getDouble(this, tr("Re-wet"), tr("Seconds that the paint spreads on"),
                                                   usualSeconds, 0.001, mostSeconds, 3, &ok);
    if (!ok)
        return;
    Edit edit = rewet(m_editor.document(), now, toMicroseconds(seconds));
    if (edit.isEmpty())
        emit m_commands->said(Commands::tr("Nothing that is selected is painted yet at this moment."), 5000);
    m_editor.push(std::move(edit), tr("Re-wet"));
}

} // namespace suffuse
