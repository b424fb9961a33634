// Rows that make areas of areas, and of lines.
#include "app/session/commands/reshaping.h"
#include "app/session/commands/session_rows.h"
#include "undo/area_edits.h"

#include <QCoreApplication>

namespace suffuse {

namespace {

/// Does an edit, or says why there is none.
void pushOrSay(Commands &table, Editor &editor, Edit edit, AreaProblem problem, const QString &name,
               const QString &tooFew)
{
    switch (problem) {
    case AreaProblem::None:
        editor.push(std::move(edit), name);
        return;
    case AreaProblem::TooFew:
        emit table.said(tooFew, 5000);
        return;
    case AreaProblem::Empty:
        emit table.said(Commands::tr("Not done: nothing would be left."), 5000);
        return;
    case AreaProblem::TooMuch:
        emit table.said(Commands::tr("Not done: the outlines meet so often that it would take minutes."), 8000);
        return;
    case AreaProblem::Uncertain:
        emit table.said(Commands::tr("Not done: the outlines lie on each other so closely that the result is uncertain."),
                        8000);
    }
}

} // namespace

void addAreaRows(Commands &table, OpenPainting &open)
{
    using enum Command;
    Editor &editor = open.editor;
    const auto addSet = [&](Command command, const char *id, const QString &text, const char *icon,
                            const QString &key, const QString &tip, AreaSet how) {
        table.add(command, QString::fromLatin1(id), text, icon, {QKeySequence(key)}, tip)
            .when([&editor] { return hasSelectedAreas(editor.unsettled(), 2); },
                  Commands::tr("Select two or more filled strokes."))
            .runs([&table, &editor, how, text] {
                AreaProblem problem = AreaProblem::None;
                Edit edit = combineAreas(editor.document(), how, &problem);
                pushOrSay(table, editor, std::move(edit), problem, plainTitle(text),
                          Commands::tr("Select two or more filled strokes."));
            });
    };
    addSet(UniteAreas, "union", Commands::tr("&Union"), "area-union", Commands::tr("Ctrl+Alt++"),
           Commands::tr("One fill of what the selected ones cover, with the values of the lowest"), AreaSet::Union);
    addSet(SubtractAreas, "difference", Commands::tr("&Difference"), "area-difference", Commands::tr("Ctrl+Alt+-"),
           Commands::tr("Leave of the lowest selected fill what the others do not cover"), AreaSet::Difference);
    addSet(IntersectAreas, "intersection", Commands::tr("&Intersection"), "area-intersection", Commands::tr("Ctrl+*"),
           Commands::tr("Leave of the lowest selected fill what all others cover"), AreaSet::Intersection);
    addSet(ExcludeAreas, "exclusion", Commands::tr("E&xclusion"), "area-exclusion", Commands::tr("Ctrl+^"),
           Commands::tr("One fill of what one of the selected ones covers, and not two"), AreaSet::Exclusion);
    addSet(DivideAreas, "division", Commands::tr("Di&vision"), "area-division", Commands::tr("Ctrl+/"),
           Commands::tr("Cut the lowest selected fill along the outlines of the others"), AreaSet::Division);
    const auto addOffset = [&](Command command, const char *id, const QString &text, const char *icon,
                               const QString &key, const QString &tip, double sign) {
        table.add(command, QString::fromLatin1(id), text, icon, {QKeySequence(key)}, tip)
            .when([&editor] { return hasSelectedAreas(editor.unsettled(), 1); },
                  Commands::tr("Select a filled stroke."))
            .runs([&table, &editor, sign, text] {
                AreaProblem problem = AreaProblem::None;
                const double by = sign * std::abs(ReshapeAmounts::stored().aside);
                Edit edit = offsetAreas(editor.document(), by, &problem);
                pushOrSay(table, editor, std::move(edit), problem, plainTitle(text),
                          Commands::tr("Select a filled stroke."));
            });
    };
    addOffset(InsetAreas, "inset", Commands::tr("I&nset"), "area-inset", Commands::tr("Ctrl+Alt+("),
              Commands::tr("Move the outlines of fills inwards, by the distance of Offset and More"), -1);
    addOffset(OutsetAreas, "outset", Commands::tr("&Outset"), "area-outset", Commands::tr("Ctrl+Alt+)"),
              Commands::tr("Move the outlines of fills outwards, by the distance of Offset and More"), 1);
    table
        .add(LinesToAreas, "strokeToOutline", Commands::tr("&Stroke to Outline"), "stroke-to-outline",
             {QKeySequence(Commands::tr("Ctrl+Alt+T"))},
             Commands::tr("Make fills of what is seen of the lines of the selected strokes"))
        .when(anySelected(editor))
        .runs([&table, &editor] {
            AreaProblem problem = AreaProblem::None;
            Edit edit = linesToAreas(editor.document(), &problem);
            pushOrSay(table, editor, std::move(edit), problem, Commands::tr("Stroke to outline"),
                      Commands::tr("Select a stroke of which a line is seen."));
        });
}

} // namespace suffuse
