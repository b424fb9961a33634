// This decides where a stroke is cut into blocks, the runs of segments within which nodes are merged (docs/solver.md,
// "Level 1").
#pragma once

#include "model/painting/stroke.h"

#include <vector>

namespace suffuse {

/// A block begins at each segment whose number (a hash of its first point) is the least among this many segments before
/// it and this many behind it.
inline constexpr std::size_t blockReach = 16;
/// No block has more segments than this.
inline constexpr std::size_t longestBlock = 4 * blockReach;
/// An edit moves no border of blocks that is farther from it than this, counted in segments.
inline constexpr std::size_t borderReach = longestBlock + blockReach;

struct StrokeBlocks {
    std::vector<std::size_t> borders; ///< the segments where blocks begin, in order, and the number of segments
    std::vector<std::size_t> firm; ///< those borders that stay whatever is appended, so that blocksOf may begin there
};

/// Finds the blocks of a stroke from segment `from` on, which must be 0 or a firm border of this stroke.
///
/// A chain begins a block, and so does each change between segments that lay paint, lift it or fade it. Between
/// these places the points decide: each segment's first point (as an offset from the stroke's origin) is hashed, and a
/// block begins at each hash that is the least within `blockReach` segments on both sides. No border depends on how
/// many segments lie before it. So an edit, a cut or a removed segment moves the borders near it and no others, and a
/// stroke that grows keeps those that it has. A run of more than `longestBlock` segments without such a hash is cut by
/// the same rule with half the reach, and so on.
StrokeBlocks blocksOf(const Stroke &stroke, std::size_t from = 0);

/// Tells whether a segment is a firm border. The answer is that of blocksOf, but only the segments around it are looked
/// at.
bool isFirmBorder(const Stroke &stroke, std::size_t segment);

} // namespace suffuse
