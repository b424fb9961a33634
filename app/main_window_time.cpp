// What the Time menu does.
#include "app/canvas/canvas_widget.h"
#include "app/dialogs/timelapse_dialog.h"
#include "app/icons.h"
#include "app/main_window.h"
#include "app/playback.h"
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
    on(Command::Play, [this] { m_playback->toggle(); });
    on(Command::ToStart, [this] { m_playback->seek(m_playback->begin()); });
    on(Command::PreviousStroke, [this] { m_playback->toPreviousStroke(); });
    on(Command::NextStroke, [this] { m_playback->toNextStroke(); });
    on(Command::ToEnd, [this] { m_playback->seek(m_playback->end()); });
    on(Command::LetDry, [this] { m_playback->seek(m_playback->end()); });
    on(Command::FreezeNow, [this] {
        m_playback->pause();
        Edit edit = freeze(m_editor.document(), m_editor.clock().time());
        if (edit.isEmpty())
            statusBar()->showMessage(tr("Nothing is wet at this moment."), messageMs);
        m_editor.push(std::move(edit), tr("Freeze wet paint"));
    });
    on(Command::Rewet, [this] { rewetSelected(); });
    on(Command::RemoveRewetting,
       [this] { m_editor.push(removeRewetting(m_editor.document()), tr("Remove re-wetting")); });
    on(Command::ExportTimelapse, [this] {
        m_playback->pause();
        TimelapseDialog(m_editor, shownArea(m_canvas->view()), this).exec();
    });
    const std::pair<Command, Pace> paces[] = {{Command::PaceEven, Pace::Even},
                                              {Command::PaceEaseIn, Pace::EaseIn},
                                              {Command::PaceEaseOut, Pace::EaseOut},
                                              {Command::PaceEaseInOut, Pace::EaseInOut}};
    for (const auto &[command, pace] : paces)
        on(command, [this, pace = pace] { m_editor.push(setPace(m_editor.document(), pace), tr("Drawing pace")); });
    connect(&action(Command::LoopPlaying), &QAction::toggled, m_playback, &Playback::setLoops);
    connect(&action(Command::SkipPauses), &QAction::toggled, m_playback, &Playback::setSkipsPauses);
    connect(&action(Command::FinalPreview), &QAction::toggled, &m_editor, &Editor::setFinalShown);
    connect(m_playback, &Playback::stateChanged, this, &MainWindow::updateTimeActions);
    connect(&m_editor.clock(), &PaintingClock::pastChanged, this, &MainWindow::showHint);
    updateTimeActions();
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
        statusBar()->showMessage(tr("Nothing that is selected is painted yet at this moment."), messageMs);
    m_editor.push(std::move(edit), tr("Re-wet"));
}

void MainWindow::updateTimeActions()
{
    const bool any = !m_editor.document().selection().isEmpty();
    for (const Command command : {Command::Rewet, Command::RemoveRewetting, Command::PaceEven, Command::PaceEaseIn,
                                  Command::PaceEaseOut, Command::PaceEaseInOut})
        action(command).setEnabled(any);
    const bool playing = m_playback->isPlaying(), empty = m_editor.document().painting()->strokes.empty();
    for (const Command command : {Command::Play, Command::ToStart, Command::PreviousStroke, Command::NextStroke,
                                  Command::ToEnd, Command::LetDry, Command::FreezeNow, Command::ExportTimelapse})
        action(command).setEnabled(!empty);
    action(Command::Play).setText(playing ? tr("&Pause") : tr("&Play"));
    action(Command::Play).setIcon(icon(playing ? QStringLiteral("pause") : QStringLiteral("play")));
    action(Command::LoopPlaying).setChecked(m_playback->loops());
    action(Command::SkipPauses).setChecked(m_playback->skipsPauses());
}

} // namespace suffuse
