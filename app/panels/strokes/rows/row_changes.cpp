#include "app/panels/strokes/rows/row_changes.h"

#include "app/session/editor.h"
#include "undo/history/order_tree.h"

namespace suffuse {

void changeStroke(Editor &editor, StrokeId id, const std::function<void(Stroke &)> &change, const QString &text,
                  ValueEntry *entry)
{
    // A locked stroke can be renamed, hidden and unlocked, while `changeStrokes` would leave it alone.
    const StrokePtr old = editor.document().painting()->find(id);
    if (!old)
        return;
    Stroke stroke = *old;
    change(stroke);
    if (stroke == *old)
        return;
    Edit edit;
    edit.strokes.emplace(id, std::make_shared<const Stroke>(std::move(stroke)));
    editor.push(std::move(edit), text, entry);
}

void changeGroup(Editor &editor, GroupId id, const std::function<void(Group &)> &change, const QString &text,
                 ValueEntry *entry)
{
    std::vector<Group> groups = editor.document().painting()->groups;
    for (Group &group : groups)
        if (group.id == id)
            change(group);
    if (groups == editor.document().painting()->groups)
        return;
    Edit edit;
    edit.groups = std::move(groups);
    editor.push(std::move(edit), text, entry);
}

void changeWithin(Editor &editor, GroupId id, const std::function<void(Stroke &)> &changeStroke,
                  const std::function<void(Group &)> &changeGroup, const QString &text, ValueEntry *entry)
{
    const Painting &painting = *editor.document().painting();
    std::vector<Group> groups = painting.groups;
    const std::unordered_set<GroupId> within = withGroupsWithin(groups, {id});
    for (Group &group : groups)
        if (group.id != id && within.contains(group.id))
            changeGroup(group);
    Edit edit;
    if (groups != painting.groups)
        edit.groups = std::move(groups);
    for (const StrokePtr &old : painting.strokes) {
        if (!within.contains(old->group))
            continue;
        Stroke stroke = *old;
        changeStroke(stroke);
        if (stroke != *old)
            edit.strokes.emplace(old->id, std::make_shared<const Stroke>(std::move(stroke)));
    }
    if (edit.groups || !edit.strokes.empty())
        editor.push(std::move(edit), text, entry);
}

} // namespace suffuse
