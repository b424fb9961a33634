#include "app/session/commands/selection_commands.h"

#include "app/session/current_layer.h"
#include "app/session/selecting/pick.h"
#include "model/painting/decimal.h"
#include "undo/history/order_tree.h"
#include "undo/layers/emptied_groups.h"
#include "undo/node_edits.h"

#include <QCoreApplication>

#include <algorithm>

namespace suffuse::commands {

namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("Commands", text);
}

/// A layer that was deleted as a whole does not come again: another one is painted on.
void leaveDeletedLayer(Editor &editor, const Painting &before, const std::vector<GroupId> &deleted)
{
    CurrentLayer &layer = editor.layer();
    const Painting &after = *editor.document().painting();
    const std::vector<GroupId> around = groupsAround(before, layer.group());
    if (!after.findGroup(layer.group()) && std::ranges::find_first_of(around, deleted) != around.end())
        layer.chooseByStep(layerBeside(before, layer.group(), after));
}

/// What a single key has done to a selection that the tool in hand may not show.
QString doneTo(Editor &editor, const QString &what)
{
    return QCoreApplication::translate("Commands", "%1: %Ln stroke(s); Undo takes it back.", "",
                                       int(editor.document().selection().strokes.size()))
        .arg(what);
}

} // namespace

bool canDelete(const Editor &editor)
{
    return !editor.selection().strokes.empty() || isEmptyGroup(*editor.unsettled().painting(), editor.layer().group());
}

QString deleteSelected(Editor &editor)
{
    const PaintingPtr was = editor.document().painting();
    const GroupId layer = editor.layer().group();
    if (editor.selection().strokes.empty() && isEmptyGroup(*was, layer)) {
        editor.push(deleteEmptyGroup(editor.document(), layer),
                    QCoreApplication::translate("Commands", "Delete layer"));
        editor.layer().chooseByStep(layerBeside(*was, layer, *editor.document().painting()));
        return {};
    }
    const std::vector<GroupId> groups = selectedGroups(editor.document());
    const bool segments = !editor.document().selection().segments.empty();
    const auto count = [&] {
        const Painting &painting = *editor.document().painting();
        return int(segments ? painting.segmentCount() : painting.strokes.size());
    };
    const int before = count();
    editor.push(deleteSelection(editor.document(), Leaves::Chains),
                segments ? QCoreApplication::translate("Commands", "Delete segments")
                         : QCoreApplication::translate("Commands", "Delete strokes"));
    leaveDeletedLayer(editor, *was, groups);
    const int gone = before - count();
    if (gone <= 0)
        return {}; // what is locked stays
    return segments ? QCoreApplication::translate("Commands", "%Ln segment(s) deleted; Undo brings back.", "", gone)
                    : QCoreApplication::translate("Commands", "%Ln stroke(s) deleted; Undo brings back.", "", gone);
}

QString unseenSelection(const Editor &editor)
{
    const Selection &selection = editor.selection();
    return selection.segments.empty()
               ? QCoreApplication::translate("Commands", "%Ln stroke(s) selected. Delete once more deletes.", "",
                                             int(selection.strokes.size()))
               : QCoreApplication::translate("Commands", "%Ln segment(s) selected. Delete once more deletes.", "",
                                             int(selection.segments.size()));
}

QString duplicateSelected(Editor &editor)
{
    const PaintingPtr before = editor.document().painting();
    editor.push(duplicateSelection(editor.document(), {0, 0}), QCoreApplication::translate("Commands", "Duplicate"));
    const bool doublesErasures = !editor.selection().segments.empty() && editor.document().painting() != before;
    return doublesErasures
               ? QCoreApplication::translate("Commands",
                                             "The erasure is there twice now, and takes twice: drag the copy, or move "
                                             "it with the arrow keys.")
               : QString();
}

QString arrangeSelected(Editor &editor, Arrange how)
{
    const char *names[] = {QT_TRANSLATE_NOOP("Commands", "Raise"), QT_TRANSLATE_NOOP("Commands", "Lower"),
                           QT_TRANSLATE_NOOP("Commands", "Raise to top"),
                           QT_TRANSLATE_NOOP("Commands", "Lower to bottom")};
    Edit edit = arrangeSelection(editor.document(), how);
    if (edit.isEmpty())
        return QCoreApplication::translate("Commands", "Nothing changes.");
    editor.push(std::move(edit), tr(names[int(how)]));
    return doneTo(editor, tr(names[int(how)]));
}

void selectAll(Editor &editor)
{
    Selection selection;
    selection.strokes = selectableStrokes(*editor.layer().reached(), editor.clock().time());
    editor.document().setSelection(std::move(selection));
}

void deselect(Editor &editor)
{
    Selection selection = editor.document().selection();
    if (selection.segments.empty())
        selection.strokes.clear();
    selection.segments.clear();
    editor.document().setSelection(std::move(selection));
}

void moveStrokes(Editor &editor, const std::set<StrokeId> &strokes, Point by, ValueEntry *entry)
{
    const Document &document = editor.document();
    editor.push(
        changeStrokes(document, strokes,
                      [by](Stroke &stroke) {
                          stroke.origin = {decimalSum(stroke.origin.x, by.x), decimalSum(stroke.origin.y, by.y)};
                      }),
        QCoreApplication::translate("Commands", "Move"), entry);
}

void invertSelection(Editor &editor)
{
    Selection selection;
    for (const StrokeId id : selectableStrokes(*editor.layer().reached(), editor.clock().time()))
        if (!editor.document().selection().strokes.contains(id))
            selection.strokes.insert(id);
    editor.document().setSelection(std::move(selection));
}

void selectSameAs(Editor &editor, Same what)
{
    Selection same = selectSame(editor.document(), what);
    if (editor.layer().reachedGroup() != 0) {
        const std::set<StrokeId> reached = selectableStrokes(*editor.layer().reached(), editor.clock().time());
        const std::set<StrokeId> &before = editor.document().selection().strokes;
        std::erase_if(same.strokes, [&](StrokeId id) { return !reached.contains(id) && !before.contains(id); });
    }
    editor.document().setSelection(std::move(same));
}

QString flipSelected(Editor &editor, Axis axis, SpreadRule rule)
{
    const Rect box = selectionBox(*editor.document().painting(), editor.document().selection());
    if (box.isEmpty())
        return {};
    const bool across = axis == Axis::Horizontal;
    const Affine map = Affine::scaling(box.centre(), across ? -1 : 1, across ? 1 : -1);
    const QString text = across ? QCoreApplication::translate("Commands", "Flip horizontally")
                                : QCoreApplication::translate("Commands", "Flip vertically");
    editor.push(transformSelection(editor.document(), map, rule), text);
    return doneTo(editor, text);
}

void quarterTurnSelected(Editor &editor, int quarters, SpreadRule rule)
{
    const Rect box = selectionBox(*editor.document().painting(), editor.document().selection());
    if (box.isEmpty())
        return;
    const std::array<double, 4> sines{0, 1, 0, -1}; // so that quarters of a turn are exact
    const double s = sines[std::size_t(quarters & 3)], c = sines[std::size_t((quarters + 1) & 3)];
    editor.push(transformSelection(editor.document(), Affine::about(box.centre(), c, -s, s, c), rule),
                QCoreApplication::translate("Commands", "Rotate by 90°"));
}

QString alignSelected(Editor &editor, Align how, AlignTo to, StrokeId anchor)
{
    if (movedUnits(editor.document()) < (to == AlignTo::Canvas ? 1 : 2))
        return QCoreApplication::translate("Commands",
                                           "Aligning takes two strokes or groups that are not locked. A group "
                                           "counts as one; it can be aligned relative to the canvas.");
    editor.push(align(editor.document(), how, to, anchor), QCoreApplication::translate("Commands", "Align"));
    return {};
}

QString distributeSelected(Editor &editor, Axis axis, Spacing spacing)
{
    if (movedUnits(editor.document()) < 3)
        return QCoreApplication::translate(
            "Commands", "Distributing takes three strokes or groups that are not locked. A group counts as one.");
    editor.push(distribute(editor.document(), axis, spacing), QCoreApplication::translate("Commands", "Distribute"));
    return {};
}

void groupSelected(Editor &editor)
{
    editor.push(groupSelection(editor.document(), {}), QCoreApplication::translate("Commands", "Group"));
}

void ungroupSelected(Editor &editor)
{
    editor.push(ungroupSelection(editor.document()), QCoreApplication::translate("Commands", "Ungroup"));
}

void toggleSelectedRole(Editor &editor, GroupRole role)
{
    const Document &document = editor.document();
    const std::vector<GroupId> groups = selectedGroups(document);
    const bool on = !GroupRoles(*document.painting()).of(groups, role).all();
    const auto text = [&] {
        switch (role) {
        case GroupRole::Clipped:
            return on ? QCoreApplication::translate("Commands", "Clip group to what lies below")
                      : QCoreApplication::translate("Commands", "Clip group no more");
        case GroupRole::Mask:
            return on ? QCoreApplication::translate("Commands", "Use group as mask")
                      : QCoreApplication::translate("Commands", "Use group as mask no more");
        case GroupRole::Wash:
            return on ? QCoreApplication::translate("Commands", "Make group a wash")
                      : QCoreApplication::translate("Commands", "Make wash a plain group");
        case GroupRole::Draft:
            return on ? QCoreApplication::translate("Commands", "Make group a draft")
                      : QCoreApplication::translate("Commands", "Export draft again");
        }
        return QString();
    };
    editor.push(setGroupRole(document, groups, role, on), text());
}

QString combineSelected(Editor &editor)
{
    bool keepsFills = true;
    Edit edit = combineSelection(editor.document(), &keepsFills);
    if (!keepsFills)
        return QCoreApplication::translate("Commands",
                                           "Not combined: one stroke has one fill, and these differ, overlap, "
                                           "or are missing in some strokes.");
    editor.push(std::move(edit), QCoreApplication::translate("Commands", "Combine strokes"));
    return {};
}

QString breakSelectedApart(Editor &editor)
{
    editor.push(breakApart(editor.document()), QCoreApplication::translate("Commands", "Break apart"));
    return QCoreApplication::translate("Commands",
                                       "%Ln stroke(s) now. Where their paint meets it mixes, and no longer adds up.",
                                       nullptr, int(editor.document().selection().strokes.size()));
}

void removeSelectedErasures(Editor &editor)
{
    editor.push(removeErasures(editor.document()), QCoreApplication::translate("Commands", "Remove erasures"));
}

void lockSelected(Editor &editor)
{
    editor.push(lockSelection(editor.document()), QCoreApplication::translate("Commands", "Lock strokes"));
}

void hideSelected(Editor &editor)
{
    editor.push(hideSelection(editor.document()), QCoreApplication::translate("Commands", "Hide strokes"));
}

void deselectHidden(Editor &editor)
{
    const Painting &painting = *editor.document().painting();
    Selection selection = editor.document().selection();
    const Visibility isVisible(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (!isVisible(*stroke) && selection.strokes.erase(stroke->id) > 0)
            std::erase_if(selection.segments, [&](const SegmentRef &ref) { return ref.stroke == stroke->id; });
    if (selection != editor.document().selection())
        editor.document().setSelection(std::move(selection));
}

void unlockAllStrokes(Editor &editor)
{
    editor.push(unlockAll(editor.document()), QCoreApplication::translate("Commands", "Unlock all"));
}

void showAllStrokes(Editor &editor)
{
    editor.push(showAll(editor.document()), QCoreApplication::translate("Commands", "Show all"));
}

void renameSelected(Editor &editor, const QString &name)
{
    const Document &document = editor.document();
    if (const GroupId group = selectedGroup(document)) {
        editor.push(renameGroup(document, group, name), QCoreApplication::translate("Commands", "Rename group"));
        return;
    }
    editor.push(changeStrokes(document, document.selection().strokes, [&name](Stroke &s) { s.name = name; }),
                QCoreApplication::translate("Commands", "Rename strokes"));
}

} // namespace suffuse::commands
