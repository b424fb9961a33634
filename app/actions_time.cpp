// Names, icons and keys of the Time menu.
#include "app/actions.h"

#include <QMenu>

namespace suffuse {

void Actions::addTime()
{
    using enum Command;
    add(Play, tr("&Play"), "play", {QKeySequence(Qt::Key_P)}, tr("Play the painting being painted, or pause"));
    add(ToStart, tr("To the &Start"), "to-start", {QKeySequence(tr("Shift+,"))}, tr("Go to where the painting begins"));
    add(PreviousStroke, tr("P&revious Stroke"), "step-back", {QKeySequence(tr(","))},
        tr("Go back to where a stroke begins"));
    add(NextStroke, tr("&Next Stroke"), "step-on", {QKeySequence(tr("."))}, tr("Go on to where a stroke begins"));
    add(ToEnd, tr("To the &End"), "to-end", {QKeySequence(tr("Shift+."))},
        tr("Go to the end, where all has dried: the present"));
    add(LoopPlaying, tr("&Loop"), "loop", {}, tr("Play again and again"));
    add(SkipPauses, tr("S&kip Pauses"), "skip-pauses", {},
        tr("Cut pauses in which nothing is painted or spreads to half a second"));
    add(FinalPreview, tr("Preview When &Dry"), "final-preview", {QKeySequence(tr("Shift+D"))},
        tr("Show wet paint as it will look when it has dried, while you paint too"));
    add(LetDry, tr("Let It Dr&y"), "dry", {QKeySequence(Qt::Key_D)}, tr("Go to the moment at which all has dried"));
    add(FreezeNow, tr("&Freeze Wet Paint"), "freeze", {QKeySequence(tr("Ctrl+Alt+F"))},
        tr("All that is wet stops spreading at this moment"));
    add(Rewet, tr("Re-&wet…"), "rewet", {QKeySequence(tr("Ctrl+Alt+W"))},
        tr("Let the selected paint spread on for a while from this moment"));
    add(RemoveRewetting, tr("Remove Re-we&tting"), "", {}, tr("The selected paint dries once and for all"));
    add(PaceEven, tr("&Even"), "", {}, tr("Selected strokes are drawn at an even pace"));
    add(PaceEaseIn, tr("Ease &In"), "", {}, tr("Selected strokes begin slowly"));
    add(PaceEaseOut, tr("Ease &Out"), "", {}, tr("Selected strokes end slowly"));
    add(PaceEaseInOut, tr("Ease In and O&ut"), "", {}, tr("Selected strokes begin and end slowly"));
    add(ExportTimelapse, tr("Export Ti&melapse…"), "film", {QKeySequence(tr("Ctrl+Alt+E"))},
        tr("Make a film of the painting being painted"));
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
