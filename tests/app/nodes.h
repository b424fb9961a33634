// A wave with the Segments tool in hand.
#pragma once

#include "app/tools/nodes/node_tool.h"
#include "tests/app/shapes.h"

namespace suffuse {

/// The nodes of the session's wave.
inline constexpr Point nodeAt[] = {{200, 300}, {300, 340}, {400, 300}, {500, 340}, {600, 300}};

struct NodeSession : WaveSession {
    NodeSession() { use(Command::Segments); }
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
