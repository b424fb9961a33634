// This builds the Level 0 nodes of one segment (docs/solver.md, "Nodes").
#pragma once

#include "render/nodes/node_builder.h"

namespace suffuse {

/// Describes the Level 0 nodes of one segment before blocks are put together.
struct SegmentNodes {
    std::size_t begin = 0; ///< the range of its nodes among those of the block
    std::size_t end = 0;
    NodeValues values;
    SegmentReach reach;
    double epsilon = 0; ///< the error budget relative to the peak
    double peak = 0;
    double spread = 0;      ///< s, the smaller axis where anisotropic
    double weightGain = 1;  ///< makes up for the cut; negative if the segment takes paint away
    float radius = 0;       ///< R
    bool clipped = false;   ///< whether it is clipped to the view
    bool mergeable = false; ///< whether it is isotropic, dry, not clipped, and its budget not too small
};

/// Tells whether the segment is there at T, and can be seen at a scale in pixels per unit.
bool isSeen(const Segment &segment, Microseconds T, double scale);

/// Appends the nodes of the segment, whose weights are still to be multiplied by `weightGain`, and describes them.
/// Returns false if the segment is not seen.
bool buildSegment(const Stroke &stroke, const Segment &segment, const NodeContext &context, double scale,
                  UnsetVector<Node> &nodes, SegmentNodes &out);

} // namespace suffuse
