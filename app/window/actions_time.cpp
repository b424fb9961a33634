// Names, icons and keys of the Time menu.
#include "app/window/actions.h"

#include "app/session/editor.h"
#include "app/session/playback.h"
#include "undo/time_edits.h"

#include <QMenu>

namespace suffuse {

namespace {

void pace(const CommandTarget &target, Pace pace)
{
    target.editor.push(setPace(target.editor.document(), pace), Actions::tr("Drawing pace"));
}

} // namespace

void Actions::addTime()
{
    using enum Command;
    add(Play, "play", tr("&Play"), "play", {QKeySequence(Qt::Key_P)}, tr("Play the painting being painted, or pause"))
        .when(anyStrokes)
        .named([](const CommandTarget &t) { return t.playback.isPlaying() ? tr("&Pause") : tr("&Play"); })
        .pictured([](const CommandTarget &t) {
            return t.playback.isPlaying() ? QStringLiteral("pause") : QStringLiteral("play");
        })
        .runs([](const CommandTarget &t) { t.playback.toggle(); });
    add(ToStart, "toStart", tr("To the &Start"), "to-start", {QKeySequence(tr("Shift+,"))},
        tr("Go to where the painting begins"))
        .when(anyStrokes)
        .runs([](const CommandTarget &t) { t.playback.seek(t.playback.begin()); });
    add(PreviousStroke, "previousStroke", tr("P&revious Stroke"), "step-back", {QKeySequence(tr(","))},
        tr("Go back to where a stroke begins"))
        .when(anyStrokes)
        .runs([](const CommandTarget &t) { t.playback.toPreviousStroke(); });
    add(NextStroke, "nextStroke", tr("&Next Stroke"), "step-on", {QKeySequence(tr("."))},
        tr("Go on to where a stroke begins"))
        .when(anyStrokes)
        .runs([](const CommandTarget &t) { t.playback.toNextStroke(); });
    add(ToEnd, "toEnd", tr("To the &End"), "to-end", {QKeySequence(tr("Shift+."))},
        tr("Go to the end, where all has dried: the present"))
        .when(anyStrokes)
        .runs([](const CommandTarget &t) { t.playback.seek(t.playback.end()); });
    add(LoopPlaying, "loopPlaying", tr("&Loop"), "loop", {}, tr("Play again and again"))
        .checkedWhen([](const CommandTarget &t) { return t.playback.loops(); })
        .toggles([](const CommandTarget &t, bool on) { t.playback.setLoops(on); });
    add(SkipPauses, "skipPauses", tr("S&kip Pauses"), "skip-pauses", {},
        tr("Cut pauses in which nothing is painted or spreads to half a second"))
        .checkedWhen([](const CommandTarget &t) { return t.playback.skipsPauses(); })
        .toggles([](const CommandTarget &t, bool on) { t.playback.setSkipsPauses(on); });
    add(FinalPreview, "finalPreview", tr("Preview When &Dry"), "final-preview", {QKeySequence(tr("Shift+D"))},
        tr("Show wet paint as it will look when it has dried, while you paint too"))
        .toggles([](const CommandTarget &t, bool on) { t.editor.setFinalShown(on); });
    add(LetDry, "letDry", tr("Let It Dr&y"), "dry", {QKeySequence(Qt::Key_D)},
        tr("Go to the moment at which all has dried"))
        .when(anyStrokes)
        .runs([](const CommandTarget &t) { t.playback.seek(t.playback.end()); });
    add(FreezeNow, "freezeNow", tr("&Freeze Wet Paint"), "freeze", {QKeySequence(tr("Ctrl+Alt+F"))},
        tr("All that is wet stops spreading at this moment"))
        .when(anyStrokes);
    add(Rewet, "rewet", tr("Re-&wet…"), "rewet", {QKeySequence(tr("Ctrl+Alt+W"))},
        tr("Let the selected paint spread on for a while from this moment"))
        .when(anySelected);
    add(RemoveRewetting, "removeRewetting", tr("Remove Re-we&tting"), "", {},
        tr("The selected paint dries once and for all"))
        .when(anySelected)
        .runs([](const CommandTarget &t) {
            t.editor.push(removeRewetting(t.editor.document()), tr("Remove re-wetting"));
        });
    add(PaceEven, "paceEven", tr("&Even"), "", {}, tr("Selected strokes are drawn at an even pace"))
        .when(anySelected)
        .runs([](const CommandTarget &t) { pace(t, Pace::Even); });
    add(PaceEaseIn, "paceEaseIn", tr("Ease &In"), "", {}, tr("Selected strokes begin slowly"))
        .when(anySelected)
        .runs([](const CommandTarget &t) { pace(t, Pace::EaseIn); });
    add(PaceEaseOut, "paceEaseOut", tr("Ease &Out"), "", {}, tr("Selected strokes end slowly"))
        .when(anySelected)
        .runs([](const CommandTarget &t) { pace(t, Pace::EaseOut); });
    add(PaceEaseInOut, "paceEaseInOut", tr("Ease In and O&ut"), "", {}, tr("Selected strokes begin and end slowly"))
        .when(anySelected)
        .runs([](const CommandTarget &t) { pace(t, Pace::EaseInOut); });
    add(ExportTimelapse, "exportTimelapse", tr("Export Ti&melapse…"), "film", {QKeySequence(tr("Ctrl+Alt+E"))},
        tr("Make a film of the painting being painted"))
        .when(anyStrokes);
    for (const Command command : {LoopPlaying, SkipPauses, FinalPreview})
        m_actions[command]->setCheckable(true);
}

void Actions::fillTimeMenu(QMenu &menu)
{
    using enum Command;
    const auto append = [this](QMenu &to, const QList<Command> &commands) {
        for (const Command command : commands)
            to.addAction(m_actions.at(command));
    };
    append(menu, {Play, ToStart, PreviousStroke, NextStroke, ToEnd});
    menu.addSeparator();
    append(menu, {LoopPlaying, SkipPauses});
    menu.addSeparator();
    append(menu, {FinalPreview, LetDry, FreezeNow, Rewet, RemoveRewetting});
    menu.addSeparator();
    append(*menu.addMenu(tr("Drawing Pa&ce")), {PaceEven, PaceEaseIn, PaceEaseOut, PaceEaseInOut});
}

} // namespace suffuse
