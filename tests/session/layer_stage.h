// A painting with groups, as tests of layers work on it: by commands, without a window.
#pragma once

#include "app/session/commands/session_rows.h"
#include "app/session/current_layer.h"
#include "undo/edits.h"

namespace suffuse {

using Order = std::vector<StrokeId>;

inline StrokePtr lineStroke(StrokeId id, GroupId group = 0)
{
    Stroke stroke;
    stroke.id = id;
    stroke.group = group;
    Segment segment;
    segment.bezier = {Offset{0, 0}, {10, 0}, {20, 0}, {30, 0}};
    segment.born = Microseconds(1000 * id);
    stroke.segments = {segment};
    return std::make_shared<const Stroke>(std::move(stroke));
}

/// From bottom to top: 1, group 1 {2}, group 2 {3, group 3 {4}}, 5.
struct Stage {
    OpenPainting open;
    Commands table;
    Editor &editor = open.editor;
    CurrentLayer &layer = open.editor.layer();

    Stage()
    {
        auto painting = std::make_shared<Painting>();
        const GroupId groups[] = {0, 1, 2, 3, 0};
        for (int i = 1; i <= 5; ++i)
            painting->strokes.push_back(lineStroke(StrokeId(i), groups[i - 1]));
        for (const auto &[id, parent] : {std::pair(1, 0), {2, 0}, {3, 2}}) {
            Group group;
            group.id = GroupId(id);
            group.parent = GroupId(parent);
            group.name = QStringLiteral("group %1").arg(id);
            painting->groups.push_back(std::move(group));
        }
        addSessionRows(table, open);
        editor.document().reset(painting);
        editor.undoStack().clear();
        table.update();
    }
    const Painting &painting() { return *editor.document().painting(); }
    StrokeId paint()
    {
        const StrokePtr stroke = lineStroke(editor.document().takeStrokeId());
        editor.push(layer.take(addStrokes(editor.document(), {stroke}, false)), "paint");
        return stroke->id;
    }
    std::vector<StrokeId> order() { return orderOf(painting()); }
};

} // namespace suffuse
