// This builds the Level 0 nodes of one segment (docs/solver.md, "Nodes"), and puts nodes of the segments of a block
// into a stroke, whoever has built them.
#pragma once

#include "render/nodes/level1.h"
#include "render/nodes/node_builder.h"

#include <algorithm>
#include <span>

namespace suffuse {

/// Where paint is made paler, the samples of a pixel lie this many times closer than elsewhere. They need not lie as
/// close as where it is lifted, since no style makes an edge of what they tell (docs/solver.md, "Supersampling").
inline constexpr double fadeFineness = 2;

/// Describes the Level 0 nodes of one segment before blocks are put together.
struct SegmentNodes {
    std::size_t begin = 0; ///< the range of its nodes among those of the block
    std::size_t end = 0;
    NodeValues values;
    SegmentReach reach;
    double epsilon = 0; ///< the error budget relative to the peak
    double peak = 0;
    double spread = 0;     ///< s, the smaller axis where anisotropic
    double length = 0;     ///< that of the control polygon, in spreads
    double gain = 0;       ///< weight of a node for each length of arc
    double tolerance = 0;  ///< what its panels may be off by, relative to the peak
    double weightGain = 1; ///< makes up for the cut; negative if the segment takes paint away
    float radius = 0;      ///< R
    bool clipped = false;  ///< whether it is clipped to the view
    bool isotropic = true;
    bool mergeable = false; ///< whether it is isotropic, dry, not clipped, and its budget not too small
};

/// Tells whether the segment is there at T, and can be seen at a scale in pixels per unit.
bool isSeen(const Segment &segment, Microseconds T, double scale);

/// Describes the segment but for its nodes. Returns false if the segment is not seen.
bool describeSegment(const Stroke &stroke, const Segment &segment, const NodeContext &context, double scale,
                     SegmentNodes &out);

/// Appends the nodes of the segment, whose weights are still to be multiplied by `weightGain`, and describes them.
/// Returns false if the segment is not seen.
bool buildSegment(const Stroke &stroke, const Segment &segment, const NodeContext &context, double scale,
                  UnsetVector<Node> &nodes, SegmentNodes &out);

/// Calls use(from, to) for the runs [from, to) of a block's segments, in order. Where all segments are mergeable, those
/// of one spread and style are a run, which is merged if there are several; otherwise each is one by itself.
template <class Use>
void forEachRun(std::span<const SegmentNodes> segments, Use use)
{
    const bool merge = std::ranges::all_of(segments, &SegmentNodes::mergeable);
    const auto together = [](const SegmentNodes &a, const SegmentNodes &b) {
        return a.spread == b.spread && a.values.style == b.values.style && a.values.lift == b.values.lift &&
               a.values.fade == b.values.fade;
    };
    for (std::size_t i = 0; i < segments.size();) {
        std::size_t end = i + 1;
        while (merge && end < segments.size() && together(segments[i], segments[end]))
            ++end;
        use(i, end);
        i = end;
    }
}

/// Makes one segment a group of its own. Its nodes are the last ones of `out`, from `begin` on.
void appendGroup(const SegmentNodes &segment, std::size_t begin, StrokeNodes &out);

/// Appends what a run has been merged to, a group for each window. The segments' nodes are counted from anywhere.
void appendWindows(std::span<const SegmentNodes> run, const MergedSpan &merged, StrokeNodes &out);

/// Gives back the room that is not needed, since nodes are kept for as long as a stroke stays as it is.
void giveBackSpareRoom(StrokeNodes &nodes);

} // namespace suffuse
