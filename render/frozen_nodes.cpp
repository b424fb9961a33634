#include "render/frozen_nodes.h"

#include <algorithm>

namespace suffuse {

namespace {

/// Segments [from, to) as a stroke of their own.
Stroke partOf(const Stroke &stroke, std::size_t from, std::size_t to)
{
    Stroke part;
    part.style = stroke.style;
    part.origin = stroke.origin;
    part.segments.assign(stroke.segments.begin() + std::ptrdiff_t(from), stroke.segments.begin() + std::ptrdiff_t(to));
    return part;
}

template <class T>
void append(const std::vector<T> &from, std::vector<T> &to)
{
    to.insert(to.end(), from.begin(), from.end());
}

StrokeNodes joined(const StrokeNodes &first, const StrokeNodes &second)
{
    StrokeNodes out;
    out.nodes.reserve(first.nodes.size() + second.nodes.size());
    out.groups.reserve(first.groups.size() + second.groups.size());
    out.rows.reserve(first.rows.size() + second.rows.size());
    out.reaches.reserve(first.reaches.size() + second.reaches.size());
    for (const StrokeNodes *part : {&first, &second}) {
        const auto nodes = std::uint32_t(out.nodes.size()), rows = std::uint32_t(out.rows.size());
        const auto reaches = std::uint32_t(out.reaches.size());
        for (NodeGroup group : part->groups) {
            group.begin += nodes, group.end += nodes;
            group.row += rows;
            group.reachBegin += reaches, group.reachEnd += reaches;
            out.groups.push_back(group);
        }
        append(part->nodes, out.nodes);
        append(part->rows, out.rows);
        append(part->reaches, out.reaches);
        out.clipped |= part->clipped;
    }
    return out;
}

/// Of several styles each segment's nodes would depend on all segments.
bool hasOneStyle(const Stroke &stroke)
{
    return std::ranges::all_of(stroke.segments, [&](const Segment &s) { return stroke.styleOf(s) == stroke.style; });
}

/// Whole blocks at the stroke's begin, after `known` segments, that are dry.
std::size_t drySegments(const Stroke &stroke, Microseconds T, std::size_t known)
{
    const auto &segments = stroke.segments;
    const auto firstWet = std::find_if(segments.begin() + std::ptrdiff_t(known), segments.end(),
                                       [T](const Segment &s) { return s.driesAt() > T; });
    return std::size_t(firstWet - segments.begin()) / mergeBlock * mergeBlock;
}

/// The stroke still begins with what is frozen, and looks the same.
bool holds(const FrozenNodes &frozen, const Stroke &stroke, Microseconds T, int octave)
{
    if (!frozen.stroke || frozen.octave != octave || frozen.segments > stroke.segments.size() ||
        frozen.stroke->origin != stroke.origin || frozen.stroke->style != stroke.style)
        return false;
    const auto end = stroke.segments.begin() + std::ptrdiff_t(frozen.segments);
    return std::equal(stroke.segments.begin(), end, frozen.stroke->segments.begin()) &&
           std::all_of(stroke.segments.begin(), end, [T](const Segment &s) { return s.driesAt() <= T; });
}

} // namespace

std::shared_ptr<const StrokeNodes> buildNodes(const StrokePtr &stroke, Microseconds T, int octave, const Rect &clip,
                                              FrozenNodes &frozen)
{
    if (!hasOneStyle(*stroke)) {
        frozen = {};
        return buildNodes(*stroke, T, octave, clip);
    }
    if (!holds(frozen, *stroke, T, octave))
        frozen = {nullptr, octave, 0, std::make_shared<const StrokeNodes>()};
    const std::size_t known = frozen.segments, dry = drySegments(*stroke, T, known);
    if (dry > known) {
        const auto more = buildNodes(partOf(*stroke, known, dry), T, octave, clip);
        if (!more->clipped) { // or they would depend on the view
            frozen.nodes = std::make_shared<const StrokeNodes>(joined(*frozen.nodes, *more));
            frozen.segments = dry;
        }
    }
    frozen.stroke = stroke;
    const auto rest = buildNodes(partOf(*stroke, frozen.segments, stroke->segments.size()), T, octave, clip);
    return std::make_shared<const StrokeNodes>(joined(*frozen.nodes, *rest));
}

} // namespace suffuse
