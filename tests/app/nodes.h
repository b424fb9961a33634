// A wave with the Segments tool in hand.
#pragma once

#include "app/tools/nodes/node_tool.h"
#include "tests/app/shapes.h"

namespace suffuse {

/// The nodes of the session's wave.
inline constexpr Point nodePlace[] = {{200, 300}, {300, 340}, {400, 300}, {500, 340}, {600, 300}};

/// A square of straight segments, from its upper left corner clockwise.
inline StrokePtr square(StrokeId id, Point corner, double side)
{
    Stroke stroke = *wave(id, 0, 0);
    const Point corners[] = {corner, corner + Point{side, 0}, corner + Point{side, side}, corner + Point{0, side}};
    for (std::size_t k = 0; k < 4; ++k) {
        const Point a = corners[k], b = corners[(k + 1) % 4];
        for (int i = 0; i < 4; ++i)
            stroke.segments[k].bezier[std::size_t(i)] = toOffset(a + (i / 3.0) * (b - a), {});
        stroke.segments[k].node = NodeKind::Corner;
    }
    return std::make_shared<const Stroke>(stroke);
}

struct NodeSession : WaveSession {
    NodeSession() { use(Command::Segments); }
    /// Adds a square of 200 units at (300, 400) and selects it.
    StrokeId addSquare()
    {
        const StrokeId added = editor().document().takeStrokeId();
        editor().push(addStrokes(editor().document(), {square(added, {300, 400}, 200)}, true), "square");
        editor().clock().setTime(painting().end());
        return added;
    }
    NodeTool &tool() { return *qobject_cast<NodeTool *>(canvas().tool()); }
    std::set<NodeRef> nodes(std::initializer_list<int> indices)
    {
        std::set<NodeRef> refs;
        for (int k : indices)
            refs.insert({id, k});
        return refs;
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&canvas(), key, modifiers); }
};

} // namespace suffuse
