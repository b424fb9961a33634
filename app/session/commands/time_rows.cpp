// Rows of the Time menu.
#include "app/session/commands/session_rows.h"

#include "undo/time_edits.h"

namespace suffuse {

namespace {

void pace(Editor &editor, Pace pace)
{
    editor.push(setPace(editor.document(), pace), Commands::tr("Drawing pace"));
}

void freezeNow(Commands &table, OpenPainting &open)
{
    constexpr int messageMs = 5000;
    open.playback.pause();
    Edit edit = freeze(open.editor.document(), open.editor.clock().time());
    if (edit.isEmpty())
        emit table.said(Commands::tr("Nothing is wet at this moment."), messageMs);
    open.editor.push(std::move(edit), Commands::tr("Freeze wet paint"));
}

void addPlayRows(Commands &table, OpenPainting &open)
{
    using enum Command;
    Playback &playback = open.playback;
    const auto strokes = anyStrokes(open.editor);
    table
        .add(Play, "play", Commands::tr("&Play"), "play", {QKeySequence(Qt::Key_P)},
             Commands::tr("Play the painting being painted, or pause"))
        .in(CommandScope::Timeline)
        .when(strokes)
        .named([&playback] { return playback.isPlaying() ? Commands::tr("&Pause") : Commands::tr("&Play"); })
        .pictured([&playback] { return playback.isPlaying() ? QStringLiteral("pause") : QStringLiteral("play"); })
        .runs([&playback] { playback.toggle(); });
    table
        .add(ToStart, "toStart", Commands::tr("To the &Start"), "to-start", {QKeySequence(Commands::tr("Shift+,"))},
             Commands::tr("Go to where the painting begins"))
        .in(CommandScope::Timeline)
        .when(strokes)
        .runs([&playback] { playback.seek(playback.begin()); });
    table
        .add(PreviousStroke, "previousStroke", Commands::tr("P&revious Stroke"), "step-back",
             {QKeySequence(Commands::tr(","))}, Commands::tr("Go back to where a stroke begins"))
        .in(CommandScope::Timeline)
        .when(strokes)
        .runs([&playback] { playback.toPreviousStroke(); });
    table
        .add(NextStroke, "nextStroke", Commands::tr("&Next Stroke"), "step-on", {QKeySequence(Commands::tr("."))},
             Commands::tr("Go on to where a stroke begins"))
        .in(CommandScope::Timeline)
        .when(strokes)
        .runs([&playback] { playback.toNextStroke(); });
    table
        .add(ToEnd, "toEnd", Commands::tr("To the &End"), "to-end", {QKeySequence(Commands::tr("Shift+."))},
             Commands::tr("Go to the end, where all has dried: the present"))
        .in(CommandScope::Timeline)
        .when(strokes)
        .runs([&playback] { playback.seek(playback.end()); });
    table.add(LoopPlaying, "loopPlaying", Commands::tr("&Loop"), "loop", {}, Commands::tr("Play again and again"))
        .checkedWhen([&playback] { return playback.loops(); })
        .toggles([&playback](bool on) { playback.setLoops(on); });
    table
        .add(SkipPauses, "skipPauses", Commands::tr("S&kip Pauses"), "skip-pauses", {},
             Commands::tr("Cut pauses in which nothing is painted or spreads to half a second"))
        .checkedWhen([&playback] { return playback.skipsPauses(); })
        .toggles([&playback](bool on) { playback.setSkipsPauses(on); });
}

void addWetRows(Commands &table, OpenPainting &open)
{
    using enum Command;
    Editor &editor = open.editor;
    Playback &playback = open.playback;
    const auto selected = anySelected(editor), strokes = anyStrokes(editor);
    table
        .add(FinalPreview, "finalPreview", Commands::tr("Preview When &Dry"), "final-preview",
             {QKeySequence(Commands::tr("Shift+D"))},
             Commands::tr("Show wet paint as it will look when it has dried, while you paint too"))
        .in(CommandScope::Timeline)
        .toggles([&editor](bool on) { editor.setFinalShown(on); });
    table
        .add(LetDry, "letDry", Commands::tr("Let It Dr&y"), "dry", {QKeySequence(Qt::Key_D)},
             Commands::tr("Go to the moment at which all has dried"))
        .in(CommandScope::Timeline)
        .when(strokes)
        .runs([&playback] { playback.seek(playback.end()); });
    table
        .add(FreezeNow, "freezeNow", Commands::tr("&Freeze Wet Paint"), "freeze",
             {QKeySequence(Commands::tr("Ctrl+Alt+F"))}, Commands::tr("All that is wet stops spreading at this moment"))
        .when(strokes)
        .runs([&table, &open] { freezeNow(table, open); });
    table
        .add(RemoveRewetting, "removeRewetting", Commands::tr("Remove Re-we&tting"), "", {},
             Commands::tr("The selected paint dries once and for all"))
        .when([&editor] { return canRemoveRewetting(editor.unsettled()); },
              Commands::tr("Select paint that was wetted again."))
        .runs([&editor] { editor.push(removeRewetting(editor.document()), Commands::tr("Remove re-wetting")); });
}

void addPaceRows(Commands &table, Editor &editor)
{
    using enum Command;
    const auto selected = anySelected(editor);
    table
        .add(PaceEven, "paceEven", Commands::tr("&Even"), "", {},
             Commands::tr("Selected strokes are drawn at an even pace"))
        .when(selected)
        .runs([&editor] { pace(editor, Pace::Even); });
    table.add(PaceEaseIn, "paceEaseIn", Commands::tr("Ease &In"), "", {}, Commands::tr("Selected strokes begin slowly"))
        .when(selected)
        .runs([&editor] { pace(editor, Pace::EaseIn); });
    table
        .add(PaceEaseOut, "paceEaseOut", Commands::tr("Ease &Out"), "", {}, Commands::tr("Selected strokes end slowly"))
        .when(selected)
        .runs([&editor] { pace(editor, Pace::EaseOut); });
    table
        .add(PaceEaseInOut, "paceEaseInOut", Commands::tr("Ease In and O&ut"), "", {},
             Commands::tr("Selected strokes begin and end slowly"))
        .when(selected)
        .runs([&editor] { pace(editor, Pace::EaseInOut); });
}

} // namespace

void addTimeRows(Commands &table, OpenPainting &open)
{
    addPlayRows(table, open);
    addWetRows(table, open);
    addPaceRows(table, open.editor);
}

} // namespace suffuse
