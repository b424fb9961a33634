#include "render/nodes/node_builder.h"

#include "render/nodes/blocks.h"
#include "render/nodes/segment_nodes.h"
#include "render/threads/parallel.h"

#include <span>

namespace suffuse {

const NodeValues *firstLaying(std::span<const NodeValues> rows)
{
    const auto it = std::ranges::find(rows, true, &NodeValues::laysPaint);
    return it == rows.end() ? nullptr : &*it;
}

int zoomOctave(double scale)
{
    int exponent = 0;
    const double mantissa = std::frexp(scale, &exponent); // scale = mantissa · 2^exponent, mantissa in [½, 1)
    return mantissa == 0.5 ? exponent - 1 : exponent;
}

NodeContext contextOf(const Stroke &stroke, Microseconds T, int octave, const Rect &clip)
{
    NodeContext context{T, octave, clip, {}};
    auto &styles = context.styles; // Every segment's density passes through all of them.
    for (const Segment &segment : stroke.segments)
        if (!segment.takesPaint() && std::find(styles.begin(), styles.end(), stroke.styleOf(segment)) == styles.end())
            styles.push_back(stroke.styleOf(segment));
    return context;
}

namespace {

/// Holds the segments of a block that can be seen, in order.
struct BuiltBlock {
    std::vector<SegmentNodes> segments;
    UnsetVector<Node> nodes;
    std::vector<SpanNode> fine;      ///< the nodes of a run to be merged; kept for its memory
    std::vector<std::size_t> begins; ///< where the segments of that run begin in `fine`
    MergedSpan merged;               ///< what that run becomes; kept for its memory
};

/// Appends one segment of a block as a group of its own.
void append(const BuiltBlock &block, const SegmentNodes &b, StrokeNodes &out)
{
    const std::size_t begin = out.nodes.size();
    out.nodes.insert(out.nodes.end(), block.nodes.begin() + std::ptrdiff_t(b.begin),
                     block.nodes.begin() + std::ptrdiff_t(b.end));
    appendGroup(b, begin, out);
}

/// Writes the nodes of a run of segments in units of its spread.
void toSpan(const BuiltBlock &block, std::span<const SegmentNodes> run, std::vector<SpanNode> &fine,
            std::vector<std::size_t> &begins)
{
    const double inverse = 1 / run[0].spread;
    fine.clear();
    begins.clear();
    for (const SegmentNodes &b : run) {
        begins.push_back(fine.size());
        const Colour &c = b.values.colour;
        for (std::size_t i = b.begin; i < b.end; ++i) {
            const Node &n = block.nodes[i];
            fine.push_back({n.x * inverse,
                            n.y * inverse,
                            n.weight,
                            b.epsilon * b.peak,
                            {c.red, c.yellow, c.blue, c.opacity, b.values.granulation}});
        }
    }
}

/// Appends a run of segments of one spread and style with fewer nodes, a group for each window.
void appendMerged(BuiltBlock &block, std::span<const SegmentNodes> run, StrokeNodes &out)
{
    toSpan(block, run, block.fine, block.begins);
    mergeSpan(block.fine, block.begins, block.merged);
    appendWindows(run, block.merged, out);
}

/// Appends a block's segments, merging runs of them if all are dry.
void appendBlock(BuiltBlock &block, StrokeNodes &out)
{
    const auto &segments = block.segments;
    forEachRun(segments, [&](std::size_t i, std::size_t end) {
        if (end - i > 1 && segments[end - 1].end > segments[i].begin)
            appendMerged(block, std::span(&segments[i], end - i), out);
        else
            append(block, segments[i], out);
    });
}

/// Makes room for so many more segments and nodes.
void reserve(std::size_t segments, std::size_t nodes, StrokeNodes &out)
{
    out.nodes.reserve(out.nodes.size() + nodes);
    out.groups.reserve(out.groups.size() + segments);
    out.rows.reserve(out.rows.size() + segments);
    out.reaches.reserve(out.reaches.size() + segments);
}

/// Tells whether a segment keeps its block from being merged. It tests what SegmentNodes::mergeable does, as far as
/// that can be known before the segment is built.
bool standsAlone(const Segment &segment, const NodeContext &context, double scale)
{
    return (!segment.isIsotropic() || segment.driesAt() > context.T) && isSeen(segment, context.T, scale);
}

/// Appends segments [from, to) one by one.
void appendApart(const Stroke &stroke, std::size_t from, std::size_t to, const NodeContext &context, double scale,
                 StrokeNodes &out)
{
    for (std::size_t k = from; k < to; ++k) {
        SegmentNodes built;
        const std::size_t begin = out.nodes.size();
        if (!buildSegment(stroke, stroke.segments[k], context, scale, out.nodes, built))
            continue;
        appendGroup(built, begin, out);
        out.clipped |= built.clipped;
    }
}

/// Appends the segments between these borders, block by block.
void appendBlocks(const Stroke &stroke, std::span<const std::size_t> borders, const NodeContext &context,
                  StrokeNodes &out)
{
    const double scale = std::ldexp(1.0, context.octave);
    const std::size_t count = borders.back() - borders.front();
    reserve(count, 5 * count, out);
    thread_local BuiltBlock block; // It keeps its memory.
    for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
        const std::size_t first = borders[i], end = borders[i + 1];
        const auto alone = [&](const Segment &s) { return standsAlone(s, context, scale); };
        if (std::any_of(&stroke.segments[first], stroke.segments.data() + end, alone)) {
            appendApart(stroke, first, end, context, scale, out);
            continue;
        }
        block.segments.clear();
        block.nodes.clear();
        for (std::size_t k = first; k < end; ++k) {
            SegmentNodes &built = block.segments.emplace_back();
            if (buildSegment(stroke, stroke.segments[k], context, scale, block.nodes, built))
                out.clipped |= built.clipped;
            else
                block.segments.pop_back();
        }
        appendBlock(block, out);
    }
}

/// Counts nodes, groups, rows and reaches.
struct NodesExtent {
    std::size_t nodes, groups, rows, reaches;

    explicit NodesExtent(const StrokeNodes &s)
        : nodes(s.nodes.size()), groups(s.groups.size()), rows(s.rows.size()), reaches(s.reaches.size())
    {}
    void operator+=(const NodesExtent &e)
    {
        nodes += e.nodes, groups += e.groups, rows += e.rows, reaches += e.reaches;
    }
    void resize(StrokeNodes &s) const
    {
        s.nodes.resize(nodes);
        s.groups.resize(groups);
        s.rows.resize(rows);
        s.reaches.resize(reaches);
    }
};

/// Puts all of `part` into `out` from `at` on, where there is room.
void copyNodes(const StrokeNodes &part, const NodesExtent &at, StrokeNodes &out)
{
    const auto nodes = std::uint32_t(at.nodes), reaches = std::uint32_t(at.reaches);
    std::ranges::transform(part.groups, out.groups.begin() + std::ptrdiff_t(at.groups), [&](NodeGroup group) {
        group.begin += nodes, group.end += nodes;
        group.row += std::uint32_t(at.rows);
        group.reachBegin += reaches, group.reachEnd += reaches;
        return group;
    });
    std::ranges::copy(part.nodes, out.nodes.begin() + std::ptrdiff_t(at.nodes));
    std::ranges::copy(part.rows, out.rows.begin() + std::ptrdiff_t(at.rows));
    std::ranges::copy(part.reaches, out.reaches.begin() + std::ptrdiff_t(at.reaches));
}

} // namespace

void appendNodes(const StrokeNodes &part, StrokeNodes &out)
{
    const NodesExtent at(out);
    NodesExtent end = at;
    end += NodesExtent(part);
    end.resize(out);
    copyNodes(part, at, out);
    out.clipped |= part.clipped;
}

void appendNodes(const Stroke &stroke, std::span<const std::size_t> borders, const NodeContext &context,
                 Threads threads, StrokeNodes &out)
{
    if (borders.size() < 2)
        return;
    constexpr std::size_t share = 2; // how many blocks a thread takes at a time: tens of microseconds
    const std::size_t blocks = borders.size() - 1, shares = (blocks + share - 1) / share;
    if (threads.count() == 1 || shares < 4)
        return appendBlocks(stroke, borders, context, out);
    std::vector<StrokeNodes> parts(shares);
    parallelFor(shares, threads, [&](std::size_t i) {
        const std::size_t begin = i * share, count = std::min(share, blocks - begin) + 1;
        appendBlocks(stroke, borders.subspan(begin, count), context, parts[i]);
    });
    std::vector<NodesExtent> places; // where each part begins
    NodesExtent end(out);
    for (const StrokeNodes &part : parts) {
        places.push_back(end);
        end += NodesExtent(part);
        out.clipped |= part.clipped;
    }
    end.resize(out);
    parallelFor(shares, threads, [&](std::size_t i) { copyNodes(parts[i], places[i], out); });
}

std::shared_ptr<const StrokeNodes> buildNodes(const Stroke &stroke, Microseconds T, int octave, const Rect &clip,
                                              Threads threads)
{
    const NodeContext context = contextOf(stroke, T, octave, clip);
    auto result = std::make_shared<StrokeNodes>();
    appendNodes(stroke, blocksOf(stroke).borders, context, threads, *result);
    giveBackSpareRoom(*result);
    return result;
}

} // namespace suffuse
