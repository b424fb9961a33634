#include "render/nodes/bulk_nodes.h"

#include "render/nodes/blocks.h"

#include <cmath>

namespace suffuse {

namespace {

/// So many segments that are not merged make a job, one for each lane.
constexpr std::size_t together = 32;

/// Divides the segments of a block, which begin at `first`, into jobs.
void addRuns(BulkStroke &stroke, std::size_t first)
{
    const std::span<const SegmentNodes> block(stroke.segments.data() + first, stroke.segments.size() - first);
    forEachRun(block, [&](std::size_t from, std::size_t to) {
        const auto begin = std::uint32_t(first + from), end = std::uint32_t(first + to);
        const bool merge = to - from > 1;
        if (!merge && !stroke.runs.empty())
            if (BulkStroke::Run &last = stroke.runs.back(); !last.merge && last.end - last.begin < together) {
                last.end = end;
                return;
            }
        stroke.runs.push_back({begin, end, merge});
    });
}

/// Appends a segment that is not merged.
void appendPlain(const SegmentNodes &segment, const NodePlace &place, const BulkResults &results, StrokeNodes &out)
{
    const double metric = 1 / (segment.spread * segment.spread);
    const std::size_t begin = out.nodes.size();
    const PlainNode *nodes = results.plain + place.first;
    for (std::size_t i = 0; i < place.nodes; ++i)
        out.nodes.push_back({nodes[i].x, nodes[i].y, metric, 0, metric, nodes[i].weight, segment.radius});
    appendGroup(segment, begin, out);
}

/// Appends a run that was merged. Its segments get the ranges of their Level 0 nodes.
void appendRun(std::span<SegmentNodes> run, const NodePlace *places, const BulkResults &results, MergedSpan &merged,
               StrokeNodes &out)
{
    const std::uint32_t begin = places[0].first;
    for (std::size_t k = 0; k < run.size(); ++k) {
        run[k].begin = places[k].first - begin;
        run[k].end = run[k].begin + places[k].nodes;
    }
    const auto end = std::uint32_t(begin + run.back().end);
    if (begin == end) { // As buildNodes does where no segment has a length.
        for (const SegmentNodes &segment : run.first(1))
            appendGroup(segment, out.nodes.size(), out);
        return;
    }
    merged.nodes.clear();
    merged.windows.clear();
    for (std::uint32_t at = begin; at < end;) {
        const MergedWindow &window = results.windows[results.windowAt[at]];
        const std::size_t first = merged.nodes.size();
        for (std::uint32_t i = window.first; i < window.first + window.count; ++i) {
            const MergedNode &n = results.merged[i];
            SpanNode &node = merged.nodes.emplace_back();
            node.x = n.x, node.y = n.y, node.weight = n.weight;
            std::copy_n(n.values, node.values.size(), node.values.begin());
        }
        merged.windows.push_back({window.begin - begin, window.end - begin, first, merged.nodes.size()});
        at = window.end;
    }
    appendWindows(run, merged, out);
}

} // namespace

bool planBulk(const Stroke &stroke, Microseconds T, int octave, const Rect &clip, BulkStroke &out)
{
    const NodeContext context = contextOf(stroke, T, octave, clip);
    const double scale = std::ldexp(1.0, octave);
    const std::vector<std::size_t> borders = blocksOf(stroke).borders;
    out.segments.clear(), out.sources.clear(), out.runs.clear();
    out.nodes = 0;
    out.segments.reserve(stroke.segments.size());
    out.sources.reserve(stroke.segments.size());
    for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
        const std::size_t first = out.segments.size();
        for (std::size_t k = borders[i]; k < borders[i + 1]; ++k) {
            SegmentNodes &segment = out.segments.emplace_back();
            if (!describeSegment(stroke, stroke.segments[k], context, scale, segment)) {
                out.segments.pop_back();
                continue;
            }
            if (!segment.isotropic || segment.clipped)
                return false;
            out.sources.push_back(&stroke.segments[k]);
            out.nodes += 4 + 2.5 * segment.length;
        }
        addRuns(out, first);
    }
    return true;
}

void writeRecords(const BulkStroke &stroke, std::uint32_t first, SegmentRecord *segments, NodeJob *jobs)
{
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const SegmentNodes &s = stroke.segments[k];
        const Colour &c = s.values.colour;
        SegmentRecord record;
        for (std::size_t i = 0; i < 4; ++i)
            record.x[i] = stroke.sources[k]->bezier[i].x, record.y[i] = stroke.sources[k]->bezier[i].y;
        const float values[] = {c.red, c.yellow, c.blue, c.opacity, s.values.granulation};
        std::copy_n(values, 5, record.values);
        record.inverse = 1 / s.spread;
        record.gain = s.gain;
        record.tolerance = s.tolerance;
        record.allowed = s.epsilon * s.peak;
        segments[k] = record;
    }
    for (std::size_t k = 0; k < stroke.runs.size(); ++k) {
        const BulkStroke::Run &run = stroke.runs[k];
        jobs[k] = {first + run.begin, run.end - run.begin, run.merge};
    }
}

std::shared_ptr<const StrokeNodes> bulkNodes(const BulkStroke &stroke, std::uint32_t first, const BulkResults &results)
{
    const NodePlace *places = results.places + first;
    for (const BulkStroke::Run &run : stroke.runs)
        if (places[run.begin].nodes == NodePlace::refused)
            return nullptr;
    // These keep their memory. The nodes that are returned get as much as they need.
    thread_local StrokeNodes out;
    thread_local std::vector<SegmentNodes> ranges;
    thread_local MergedSpan merged;
    out.nodes.clear(), out.rows.clear(), out.groups.clear(), out.reaches.clear();
    for (const BulkStroke::Run &run : stroke.runs) {
        const std::span segments(stroke.segments.data() + run.begin, run.end - run.begin);
        if (!run.merge) {
            for (std::size_t k = 0; k < segments.size(); ++k)
                appendPlain(segments[k], places[run.begin + k], results, out);
            continue;
        }
        ranges.assign(segments.begin(), segments.end());
        appendRun(ranges, places + run.begin, results, merged, out);
    }
    return std::make_shared<const StrokeNodes>(out);
}

} // namespace suffuse
