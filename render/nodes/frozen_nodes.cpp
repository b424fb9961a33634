#include "render/nodes/frozen_nodes.h"

#include <algorithm>

namespace suffuse {

namespace {

/// Of several styles each segment's nodes would depend on all segments.
bool hasOneStyle(const Stroke &stroke)
{
    return std::ranges::all_of(stroke.segments,
                               [&](const Segment &s) { return s.lift || stroke.styleOf(s) == stroke.style; });
}

/// Where the whole blocks at the stroke's begin end, after `known` segments, that are dry.
std::size_t drySegments(const Stroke &stroke, Microseconds T, std::size_t known)
{
    const auto &segments = stroke.segments;
    const auto firstWet = std::find_if(segments.begin() + std::ptrdiff_t(known), segments.end(),
                                       [T](const Segment &s) { return s.driesAt() > T; });
    const auto wet = std::size_t(firstWet - segments.begin());
    const std::vector<std::size_t> borders = blockBorders(stroke);
    // The last block may grow: it is whole only where it cannot.
    std::size_t whole = 0;
    for (std::size_t i = 1; i < borders.size() && borders[i] <= wet; ++i)
        if (i + 1 < borders.size() || borders[i] - borders[i - 1] == mergeBlock)
            whole = borders[i];
    return whole;
}

/// The stroke still begins with what is frozen, in the same blocks, and looks the same.
bool holds(const FrozenNodes &frozen, const Stroke &stroke, Microseconds T, int octave)
{
    if (!frozen.stroke || frozen.octave != octave || frozen.segments > stroke.segments.size() ||
        frozen.stroke->origin != stroke.origin || frozen.stroke->style != stroke.style)
        return false;
    const auto end = stroke.segments.begin() + std::ptrdiff_t(frozen.segments);
    return std::ranges::binary_search(blockBorders(stroke), frozen.segments) &&
           std::equal(stroke.segments.begin(), end, frozen.stroke->segments.begin()) &&
           std::all_of(stroke.segments.begin(), end, [T](const Segment &s) { return s.driesAt() <= T; });
}

} // namespace

std::shared_ptr<const StrokeNodes> buildNodes(const StrokePtr &stroke, Microseconds T, int octave, const Rect &clip,
                                              FrozenNodes &frozen, Threads threads)
{
    if (!hasOneStyle(*stroke)) {
        frozen = {};
        return buildNodes(*stroke, T, octave, clip, threads);
    }
    if (!holds(frozen, *stroke, T, octave))
        frozen = {nullptr, octave, 0, {}};
    const NodeContext context{T, octave, clip, {stroke->style}};
    const std::size_t known = frozen.segments, dry = drySegments(*stroke, T, known);
    if (dry > known) {
        StrokeNodes more;
        appendNodes(*stroke, known, dry, context, threads, more);
        if (!more.clipped) { // or they would depend on the view
            appendNodes(more, frozen.nodes);
            frozen.segments = dry;
        }
    }
    frozen.stroke = stroke;
    auto nodes = std::make_shared<StrokeNodes>(frozen.nodes);
    nodes->settledRows = std::uint32_t(nodes->rows.size());
    appendNodes(*stroke, frozen.segments, stroke->segments.size(), context, threads, *nodes);
    return nodes;
}

} // namespace suffuse
