// Where a stroke is cut into blocks: the runs of segments within which nodes are merged (docs/solver.md, "Level 1").
#pragma once

#include "model/painting/stroke.h"

#include <vector>

namespace suffuse {

/// A block begins where a segment begins with the least number among so many segments before it and behind it.
inline constexpr std::size_t blockReach = 16;
/// No block has more segments.
inline constexpr std::size_t longestBlock = 4 * blockReach;
/// An edit moves no border of blocks that is farther from it than this, counted in segments.
inline constexpr std::size_t borderReach = longestBlock + blockReach;

struct StrokeBlocks {
    std::vector<std::size_t> borders; ///< the segments where blocks begin, in order, and the number of segments
    std::vector<std::size_t> firm;    ///< of these, borders that stay whatever is appended, and that blocksOf begins at
};

/// The blocks of a stroke from segment `from` on: 0, or a firm border of this stroke.
///
/// A chain begins a block, and so does each change between segments that lay paint and segments that lift it. What lies
/// between is cut where the points tell to: each segment's first point (as an offset from the stroke's origin) is
/// hashed, and a block begins at each hash that is the least within `blockReach` segments on both sides. No border
/// depends on how many segments lie before it, so that an edit, a cut or a removed segment moves the borders near it
/// and no others, and a stroke that grows keeps those that it has. A run of more than `longestBlock` segments without
/// such a hash is cut by the same rule with half the reach, and so on.
StrokeBlocks blocksOf(const Stroke &stroke, std::size_t from = 0);

/// Whether a segment is a firm border: as blocksOf would say, at the cost of the segments around it.
bool isFirmBorder(const Stroke &stroke, std::size_t segment);

} // namespace suffuse
