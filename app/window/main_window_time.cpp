// What the Time menu does.
#include "app/canvas/canvas_widget.h"
#include "app/dialogs/timelapse_dialog.h"
#include "app/session/playback.h"
#include "app/widgets/at_next_change.h"
#include "app/window/main_window.h"
#include "undo/time_edits.h"

#include <QInputDialog>
#include <QStatusBar>

namespace suffuse {

namespace {

constexpr int messageMs = 5000;

} // namespace

void MainWindow::connectTimeActions()
{
    const auto on = [this](Command command, auto function) {
        connect(&action(command), &QAction::triggered, this, function);
    };
    on(Command::FreezeNow, [this] {
        m_playback->pause();
        Edit edit = freeze(m_editor.document(), m_editor.clock().time());
        if (edit.isEmpty())
            sayUntilChange(*statusBar(), m_editor.document(), tr("Nothing is wet at this moment."), messageMs);
        m_editor.push(std::move(edit), tr("Freeze wet paint"));
    });
    on(Command::Rewet, [this] { rewetSelected(); });
    on(Command::ExportTimelapse, [this] {
        m_playback->pause();
        TimelapseDialog(m_editor, shownArea(m_canvas->view()), this).exec();
    });
    connect(m_playback, &Playback::stateChanged, m_actions, &Actions::update);
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
        sayUntilChange(*statusBar(), m_editor.document(), tr("Nothing that is selected is painted yet at this moment."),
                       messageMs);
    m_editor.push(std::move(edit), tr("Re-wet"));
}

} // namespace suffuse
