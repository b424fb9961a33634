// A picture that is opened, or zoomed to another octave, needs the nodes of all strokes at once. A device builds them
// in a fraction of the time. What it gets, and how nodes are made of what it gives, is here; render/cuda/device_nodes
// asks it.
#pragma once

#include "render/math/node_records.h"
#include "render/nodes/segment_nodes.h"

#include <memory>
#include <span>
#include <vector>

namespace suffuse {

/// Builds the nodes of many strokes, to the same bits as buildNodes. So it makes no difference who builds which.
class BulkNodeBuilder {
public:
    virtual ~BulkNodeBuilder() = default;
    /// Returns the number of segments for each thread of the host from which on it is quicker than these.
    virtual std::size_t worthwhile() const = 0;
    /// Builds the nodes of strokes at a time and zoom octave. Those that it cannot build are null.
    virtual std::vector<std::shared_ptr<const StrokeNodes>> build(std::span<const StrokePtr> strokes, Microseconds T,
                                                                  int octave, const Rect &clip, Threads threads) = 0;
};

/// Holds a stroke whose nodes are to be built.
struct BulkStroke {
    /// Neighbours among `segments` that make a job, and whether they are merged.
    struct Run {
        std::uint32_t begin = 0, end = 0;
        bool merge = false;
    };
    std::vector<SegmentNodes> segments; ///< those that are seen, in order
    std::vector<const Segment *> sources;
    std::vector<Run> runs;
    /// About how many Level 0 nodes the segments have, rather more.
    double nodes = 0;
};

/// Plans a stroke, in `out`, which may be used again and again. Returns false if only the host can build its nodes,
/// since some segments are anisotropic, or clipped to the view.
bool planBulk(const Stroke &stroke, Microseconds T, int octave, const Rect &clip, BulkStroke &out);

/// Writes the records of a stroke's segments and jobs. `first` is the index of its first segment.
void writeRecords(const BulkStroke &stroke, std::uint32_t first, SegmentRecord *segments, NodeJob *jobs);

/// Holds what has been built.
struct BulkResults {
    const NodePlace *places = nullptr; ///< of all segments
    const PlainNode *plain = nullptr;
    const MergedWindow *windows = nullptr;
    const MergedNode *merged = nullptr;
    const std::uint32_t *windowAt = nullptr; ///< the index of the window that begins with a Level 0 node
};

/// Makes nodes of what was built of a stroke whose segments begin at `first`. Returns null if some of it was refused.
std::shared_ptr<const StrokeNodes> bulkNodes(const BulkStroke &stroke, std::uint32_t first, const BulkResults &results);

} // namespace suffuse
