// Spans of dry segments get fewer nodes here: their Level 0 nodes are a discrete measure, and its Gauss rules replace
// them (docs/solver.md, "Level 1").
#pragma once

#include "render/nodes/span_rule.h"

#include <span>
#include <vector>

namespace suffuse {

/// Says that nodes [nodes, nodesEnd) of a merged span stand for fine nodes [begin, end).
struct SpanWindow {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t nodes = 0;
    std::size_t nodesEnd = 0;
};

struct MergedSpan {
    std::vector<SpanNode> nodes;
    std::vector<SpanWindow> windows; ///< in order along the span
};

/// Replaces `fine`, a run along a stroke in order, by the fewer nodes of `out`, which may be used again and again: windows of it get the Gauss rule with the fewest
/// nodes whose density, on a grid over all that they reach, differs by at most half the tolerance. A window that finds
/// none is halved. `segments` says where each segment begins in `fine`. The result is a pure function of both. A
/// window's nodes depend on its own fine nodes only, and its place in the run hardly depends on others.
void mergeSpan(std::span<const SpanNode> fine, std::span<const std::size_t> segments, MergedSpan &out);

} // namespace suffuse
