// Segments as plain records, and what becomes of them: the host writes the former and reads the latter where a device
// builds nodes (render/nodes/bulk_nodes, render/cuda/nodes). The header is C++17, since .cu files include it.
#pragma once

#include <cstdint>

namespace suffuse {

/// Holds a segment whose nodes are to be built: an isotropic one that is not clipped.
struct alignas(16) SegmentRecord {
    float x[4] = {}, y[4] = {}; ///< control points, offsets from the stroke's origin
    float values[5] = {};       ///< R, Y, B, opacity, ω
    float padding = 0;
    double inverse = 0;   ///< 1/s
    double gain = 0;      ///< weight of a node for each length of arc
    double tolerance = 0; ///< what its panels may be off by, relative to its peak
    double allowed = 0;   ///< the error of density that it allows
};

/// Asks for the nodes of neighbouring segments. If they are a run to be merged, there are 64 at most.
struct NodeJob {
    std::uint32_t first = 0, count = 0;
    std::uint32_t merge = 0;
};

/// Says where the Level 0 nodes of a segment are.
struct NodePlace {
    static constexpr std::uint16_t refused = 0xffff; ///< in `nodes` of a job's first segment: the host must do the job

    std::uint32_t first;
    std::uint16_t nodes;
    std::uint16_t pieces; ///< how many panels it is cut into
};

/// Holds a Level 0 node that is not merged, in canvas units.
struct PlainNode {
    double x, y, weight;
};

/// Holds a node of a run that was merged, in units of its spread.
struct MergedNode {
    double x, y, weight;
    float values[5];
    float padding;
};

/// Says that `count` merged nodes from `first` on stand for Level 0 nodes [begin, end).
struct MergedWindow {
    std::uint32_t begin, end;
    std::uint32_t first, count;
};

} // namespace suffuse
