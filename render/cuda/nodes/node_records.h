// The memory of the programs that build nodes (node_program.h). The header is C++17, since .cu files include it.
#pragma once

#include "render/math/node_records.h"
#include "render/math/spans.h"

namespace suffuse::cuda {

/// Holds a Level 0 node of a run that is to be merged, in units of the run's spread.
struct FineNode {
    double x, y, weight;
    std::uint32_t segment;
    std::uint32_t padding;
};

/// Stands for Level 0 nodes [begin, end), which are one window, unless no rule will do.
struct SpanLeaf {
    std::uint32_t begin, end;
};

/// Holds everything that the programs of one call read and write. All pointers are the device's.
struct NodeWork {
    const SegmentRecord *segments = nullptr;
    const NodeJob *jobs = nullptr;
    std::uint32_t jobCount = 0;
    const panels::Tables *panels = nullptr;
    const spans::Tables *spans = nullptr;

    NodePlace *places = nullptr;     ///< one for each segment
    std::uint16_t *pieces = nullptr; ///< keptPieces for each: depth·16 + nodes of its panels
    PlainNode *plain = nullptr;
    std::uint32_t plainRoom = 0;
    FineNode *fine = nullptr;
    double *length =
        nullptr; ///< for each fine node, the distance from the one before; then the arc length in the window
    double *turning = nullptr; ///< likewise the turning; then the size of the window up to the node
    std::uint32_t fineRoom = 0;
    SpanLeaf *leaves = nullptr;      ///< with room for one a segment
    MergedWindow *windows = nullptr; ///< with room for one a segment, and one for every three fine nodes
    MergedNode *merged = nullptr;    ///< with room for as many as fine nodes
    float *planes = nullptr;         ///< with planeSize numbers for each of mergeWorkers
    std::uint32_t *status = nullptr; ///< see NodeStatus; the host clears them before each call
};

/// A segment of more panels is left to the host.
inline constexpr std::uint32_t keptPieces = 192;

/// Names the words of NodeWork::status. What was taken may be more than there was room for.
enum NodeStatus { plainTaken, fineTaken, leavesTaken, windowsTaken, mergedTaken, nextLeaf, nodeStatusWords };

/// Density, and density times each value, at the points of a grid.
inline constexpr int planeSize = (1 + spans::values) * spans::Grid::side * spans::Grid::side;
/// So many windows at most are merged at the same time.
inline constexpr int mergeWorkers = 640;

} // namespace suffuse::cuda
