#include "render/nodes/frozen_nodes.h"

#include "render/nodes/blocks.h"

#include <algorithm>

namespace suffuse {

namespace {

/// Tells whether the stroke has one style. If it has several, each segment's nodes depend on all segments, and none can
/// be frozen.
bool hasOneStyle(const Stroke &stroke)
{
    return std::ranges::all_of(stroke.segments,
                               [&](const Segment &s) { return s.takesPaint() || stroke.styleOf(s) == stroke.style; });
}

/// Finds the last firm border up to which all segments from `known` on are dry.
std::size_t drySegments(const Stroke &stroke, const StrokeBlocks &blocks, Microseconds T, std::size_t known)
{
    const auto &segments = stroke.segments;
    const auto firstWet = std::find_if(segments.begin() + std::ptrdiff_t(known), segments.end(),
                                       [T](const Segment &s) { return s.driesAt() > T; });
    const auto after = std::ranges::upper_bound(blocks.firm, std::size_t(firstWet - segments.begin()));
    return after == blocks.firm.begin() ? known : *(after - 1);
}

/// Tells whether the stroke still begins with what is frozen, in the same blocks, and looks the same.
bool holds(const FrozenNodes &frozen, const Stroke &stroke, Microseconds T, int octave)
{
    if (!frozen.stroke || frozen.octave != octave || frozen.segments > stroke.segments.size() ||
        frozen.stroke->origin != stroke.origin || frozen.stroke->style != stroke.style)
        return false;
    const auto end = stroke.segments.begin() + std::ptrdiff_t(frozen.segments);
    return isFirmBorder(stroke, frozen.segments) &&
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
    const std::size_t known = frozen.segments;
    const StrokeBlocks blocks = blocksOf(*stroke, known);
    const std::span<const std::size_t> borders(blocks.borders);
    const std::size_t dry = drySegments(*stroke, blocks, T, known);
    std::size_t built = 0; // how many blocks
    if (dry > known) {
        const auto count = std::size_t(std::ranges::lower_bound(borders, dry) - borders.begin());
        StrokeNodes more;
        appendNodes(*stroke, borders.first(count + 1), context, threads, more);
        if (!more.clipped) { // Clipped nodes depend on the view and are not kept.
            appendNodes(more, frozen.nodes);
            frozen.segments = dry;
            built = count;
        }
    }
    frozen.stroke = stroke;
    auto nodes = std::make_shared<StrokeNodes>(frozen.nodes);
    nodes->settledRows = std::uint32_t(nodes->rows.size());
    appendNodes(*stroke, borders.subspan(built), context, threads, *nodes);
    return nodes;
}

} // namespace suffuse
