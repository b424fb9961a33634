// The Level 0 nodes of one segment (docs/solver.md, "Nodes").
#pragma once

#include "render/nodes/node_builder.h"

namespace suffuse {

/// One segment's Level 0 nodes, before they are put together.
struct SegmentNodes {
    std::size_t begin = 0; ///< range of its nodes in the block's
    std::size_t end = 0;
    NodeValues values;
    SegmentReach reach;
    double epsilon = 0; ///< error budget relative to the peak
    double peak = 0;
    double spread = 0;      ///< s, the smaller axis where anisotropic
    double weightGain = 1;  ///< makes up for the cut; negative where it takes paint away
    float radius = 0;       ///< R
    bool clipped = false;   ///< to the view
    bool mergeable = false; ///< isotropic, dry, not clipped, and not too exact
};

/// Whether the segment is there at T and can be seen at a scale of so many pixels per unit.
bool isSeen(const Segment &segment, Microseconds T, double scale);

/// Appends the segment's nodes, whose weights are still to be multiplied by `weightGain`, and tells about them; false:
/// it is not seen.
bool buildSegment(const Stroke &stroke, const Segment &segment, const NodeContext &context, double scale,
                  UnsetVector<Node> &nodes, SegmentNodes &out);

} // namespace suffuse
