// A path that is drawn node by node.
#pragma once

#include "model/geometry/geometry.h"

#include <vector>

namespace suffuse {

/// A node and its handles, as places. A handle that lies on the node is drawn in.
struct PathNode {
    Point at;
    Point in;  ///< of the curve that arrives
    Point out; ///< of the curve that leaves
};

/// A node without handles.
inline PathNode cornerAt(Point at)
{
    return {at, at, at};
}

/// The curves from node to node, and back to the first one where the path is closed. Where both handles are drawn in
/// they are straight lines. There is none for a single node, unless it is closed and has both handles.
std::vector<Cubic> curvesThrough(const std::vector<PathNode> &nodes, bool isClosed);

/// The place at the same distance from `origin` whose direction is a multiple of 15°.
Point inSteps(Point origin, Point place);

} // namespace suffuse
