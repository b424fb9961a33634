// Rows of the Align and Distribute menus.
#include "app/session/commands/session_rows.h"

#include "app/session/commands/selection_commands.h"

namespace suffuse {

namespace {

std::size_t countSelected(OpenPainting &open)
{
    return open.editor.document().selection().strokes.size();
}

void sayIfAny(Commands &table, const QString &why)
{
    if (!why.isEmpty())
        emit table.said(why, 8000);
}

void align(Commands &table, OpenPainting &open, Align how)
{
    using enum Command;
    const auto is = [&](Command command) { return table[command].isChecked(); };
    const AlignTo to = is(AlignToCanvas)                     ? AlignTo::Canvas
                       : is(AlignToBiggest)                  ? AlignTo::Biggest
                       : is(AlignToLast) || is(AlignToFirst) ? AlignTo::Anchor
                                                             : AlignTo::Selection;
    const SelectionOrder &order = open.selectionOrder;
    sayIfAny(table, commands::alignSelected(open.editor, how, to, is(AlignToFirst) ? order.first() : order.last()));
}

QString needsTwo()
{
    return Commands::tr("Select two strokes or more; to the canvas one can be aligned, too.");
}

void addDistributeRows(Commands &table, OpenPainting &open)
{
    using enum Command;
    Editor &editor = open.editor;
    // Of two it says what it lacks, as aligning does of a single group.
    const auto canDistribute = [&open] { return countSelected(open) > 1; };
    table.add(DistributeGapsAcross, "distributeGapsAcross", Commands::tr("Even Gaps, &Horizontally"), "gaps-across", {})
        .when(canDistribute, needsTwo())
        .runs([&table, &editor] {
            sayIfAny(table, commands::distributeSelected(editor, Axis::Horizontal, Spacing::Gaps));
        });
    table.add(DistributeGapsDown, "distributeGapsDown", Commands::tr("Even Gaps, &Vertically"), "gaps-down", {})
        .when(canDistribute, needsTwo())
        .runs([&table, &editor] {
            sayIfAny(table, commands::distributeSelected(editor, Axis::Vertical, Spacing::Gaps));
        });
    table
        .add(DistributeCentresAcross, "distributeCentresAcross", Commands::tr("Even &Centres, Horizontally"),
             "centres-across", {})
        .when(canDistribute, needsTwo())
        .runs([&table, &editor] {
            sayIfAny(table, commands::distributeSelected(editor, Axis::Horizontal, Spacing::Centres));
        });
    table
        .add(DistributeCentresDown, "distributeCentresDown", Commands::tr("Even C&entres, Vertically"), "centres-down",
             {})
        .when(canDistribute, needsTwo())
        .runs([&table, &editor] {
            sayIfAny(table, commands::distributeSelected(editor, Axis::Vertical, Spacing::Centres));
        });
}

} // namespace

void addAlignRows(Commands &table, OpenPainting &open)
{
    using enum Command;
    // To the canvas one stroke can be aligned, too.
    const auto canAlign = [&table, &open] {
        return countSelected(open) > 1 || (countSelected(open) > 0 && table[AlignToCanvas].isChecked());
    };
    table.add(AlignLeft, "alignLeft", Commands::tr("&Left Edges"), "align-left", {})
        .when(canAlign, needsTwo())
        .runs([&open, &table] { align(table, open, Align::Left); });
    table.add(AlignCentre, "alignCentre", Commands::tr("&Centres, Horizontally"), "align-centre", {})
        .when(canAlign, needsTwo())
        .runs([&open, &table] { align(table, open, Align::Centre); });
    table.add(AlignRight, "alignRight", Commands::tr("&Right Edges"), "align-right", {})
        .when(canAlign, needsTwo())
        .runs([&open, &table] { align(table, open, Align::Right); });
    table.add(AlignTop, "alignTop", Commands::tr("&Top Edges"), "align-top", {}).when(canAlign, needsTwo()).runs([&open, &table] {
        align(table, open, Align::Top);
    });
    table.add(AlignMiddle, "alignMiddle", Commands::tr("&Middles, Vertically"), "align-middle", {})
        .when(canAlign, needsTwo())
        .runs([&open, &table] { align(table, open, Align::Middle); });
    table.add(AlignBottom, "alignBottom", Commands::tr("&Bottom Edges"), "align-bottom", {})
        .when(canAlign, needsTwo())
        .runs([&open, &table] { align(table, open, Align::Bottom); });
    table.add(AlignToSelection, "alignToSelection", Commands::tr("Relative to the &Selection"), "", {}).switches(true);
    table.add(AlignToLast, "alignToLast", Commands::tr("Relative to the Last Select&ed"), "", {}).switches();
    table.add(AlignToFirst, "alignToFirst", Commands::tr("Relative to the &First Selected"), "", {}).switches();
    table.add(AlignToBiggest, "alignToBiggest", Commands::tr("Relative to the Bi&ggest"), "", {}).switches();
    table.add(AlignToCanvas, "alignToCanvas", Commands::tr("Relative to the C&anvas"), "", {}).switches();
    table.makeExclusive({AlignToSelection, AlignToLast, AlignToFirst, AlignToBiggest, AlignToCanvas});
    addDistributeRows(table, open);
}

} // namespace suffuse
