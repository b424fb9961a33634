// Fewer nodes for spans of dry segments: Gauss rules of the measures that their Level 0 nodes already are.
#pragma once

#include "render/span_rule.h"

#include <vector>

namespace suffuse {

/// Nodes [nodes, nodesEnd) of a merged span stand for fine nodes [begin, end).
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

/// Replaces `fine`, a run along a stroke in order, by fewer nodes: windows of it get the Gauss rule with the fewest
/// nodes whose density, on a grid over all that they reach, differs by at most half the tolerance; a window that finds
/// none is halved. A pure function of `fine`.
MergedSpan mergeSpan(const std::vector<SpanNode> &fine);

} // namespace suffuse
