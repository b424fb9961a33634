#include "model/shaping/nodes/reshape.h"

#include "model/geometry/bernstein.h"
#include "model/shaping/curves/merge.h"
#include "model/shaping/curves/runs.h"
#include "model/shaping/curves/split.h"
#include "model/shaping/nodes/reshape_handles.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace suffuse {

namespace {

/// The squared distance from a point to a box; 0 inside of it.
double squaredDistance(const Rect &box, Point p)
{
    const double x = std::max({box.left - p.x, p.x - box.right, 0.0});
    const double y = std::max({box.top - p.y, p.y - box.bottom, 0.0});
    return x * x + y * y;
}

/// Appends what is left of a chain without some nodes to `result`, and the indices of the segments that it came from to
/// `sources`.
void appendWithoutNodes(const Stroke &stroke, const Chain &chain, const std::set<int> &gone, Stroke &result,
                        std::vector<int> &sources)
{
    int first = chain.first, end = chain.last + 1; // indices of segments
    while (first < end && gone.contains(first))
        ++first;
    if (gone.contains(endNode(stroke, chain.last)))
        while (--end > first && gone.contains(end))
            ;
    std::vector<Segment> left;
    for (int k = first; k < end;) {
        int next = k + 1;
        while (next < end && gone.contains(next))
            ++next;
        const std::vector<Segment> run(stroke.segments.begin() + k, stroke.segments.begin() + next);
        Segment one = merged(run);
        const bool isWhole = next == k + 1 || !isPoint(one);
        for (int i = k; i < (isWhole ? k + 1 : next); ++i) {
            left.push_back(isWhole ? one : stroke.segments[std::size_t(i)]);
            sources.push_back(i);
        }
        k = next;
    }
    appendChain(result, std::move(left));
}

} // namespace

Point nodePosition(const Stroke &stroke, int node)
{
    const NodeSides sides = sidesOf(stroke, node);
    return sides.after >= 0 ? stroke.origin + stroke.segments[std::size_t(sides.after)].bezier[0]
                            : stroke.origin + stroke.segments[std::size_t(sides.before)].bezier[3];
}

NodeKind nodeKind(const Stroke &stroke, int node)
{
    const std::optional<NodeSides> join = joinAt(stroke, node);
    if (!join)
        return NodeKind::Corner;
    const Segment &after = stroke.segments[std::size_t(join->after)];
    return breaksBetween(stroke.segments[std::size_t(join->before)], after) ? NodeKind::Corner : after.node;
}

std::optional<Point> handlePosition(const Stroke &stroke, int node, bool after)
{
    const NodeSides sides = sidesOf(stroke, node);
    const int segment = after ? sides.after : sides.before;
    if (segment < 0)
        return std::nullopt;
    return stroke.origin + stroke.segments[std::size_t(segment)].bezier[after ? 1 : 2];
}

std::vector<int> cornersOf(const Stroke &stroke)
{
    std::vector<int> corners;
    for (std::size_t k = 1; k < stroke.segments.size(); ++k) {
        if (!stroke.beginsChain(k) && breaksBetween(stroke.segments[k - 1], stroke.segments[k]))
            corners.push_back(int(k));
    }
    return corners;
}

CurvePlace nearestPlace(const Stroke &stroke, Point point, double *distance)
{
    CurvePlace best;
    double nearest = std::numeric_limits<double>::infinity(); // squared distance
    const Point local = point - stroke.origin;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const Cubic curve = offsetsOf(stroke.segments[k]);
        if (squaredDistance(curve.controlBox(), local) >= nearest)
            continue;
        std::vector<double> candidates = bernsteinRoots(distanceSlope(curve, local));
        candidates.push_back(0);
        candidates.push_back(1);
        for (double p : candidates) {
            const Point d = curve.at(p) - local;
            if (dot(d, d) < nearest) {
                nearest = dot(d, d);
                best = {int(k), p};
            }
        }
    }
    if (distance)
        *distance = std::sqrt(nearest);
    return best;
}

Stroke withNodes(const Stroke &stroke, const std::vector<CurvePlace> &places, std::vector<int> *sources)
{
    Stroke result = stroke;
    result.segments.clear();
    if (sources)
        sources->clear();
    for (Piece &piece : piecesOf(stroke, places)) {
        result.segments.push_back(std::move(piece.segment));
        if (sources)
            sources->push_back(piece.source);
    }
    return result;
}

Stroke withoutNodes(const Stroke &stroke, const std::vector<int> &nodes, std::vector<int> *sources)
{
    const std::set<int> gone(nodes.begin(), nodes.end());
    Stroke result = stroke;
    result.segments.clear();
    std::vector<int> from;
    for (const Chain &chain : chainsOf(stroke))
        appendWithoutNodes(stroke, chain, gone, result, from);
    if (result.segments.empty()) {
        result = stroke;
        from.resize(stroke.segments.size());
        std::iota(from.begin(), from.end(), 0);
    }
    if (sources)
        *sources = std::move(from);
    return validOr(std::move(result), stroke);
}

Stroke withSeamsBeside(const Stroke &stroke, std::vector<int> &nodes)
{
    const std::set<int> chosen(nodes.begin(), nodes.end());
    std::set<int> renumbered = chosen;
    Stroke result = stroke;
    for (const Chain &chain : chainsOf(stroke)) {
        const int end = endNode(stroke, chain.last), count = chain.last - chain.first + 1;
        const auto first = result.segments.begin() + chain.first, behind = result.segments.begin() + chain.last + 1;
        const bool isAtSeam = chosen.contains(chain.first) || chosen.contains(end);
        const bool isBornAtOnce = std::all_of(first, behind, [&](const Segment &s) { return s.born == first->born; });
        int seam = chain.first + 1;
        while (chosen.contains(seam))
            ++seam;
        if (!isAtSeam || seam > chain.last || !isBornAtOnce || !isClosed(stroke, chain))
            continue;
        const auto numberOf = [&](int node) { return chain.first + (node - seam + count) % count; };
        for (int node = chain.first; node <= chain.last; ++node)
            renumbered.erase(node);
        renumbered.erase(end);
        renumbered.insert(numberOf(chain.first));
        for (int node = chain.first + 1; node <= chain.last; ++node)
            if (chosen.contains(node))
                renumbered.insert(numberOf(node));
        const bool starts = std::exchange(first->start, false);
        std::rotate(first, result.segments.begin() + seam, behind);
        first->start = starts;
    }
    nodes.assign(renumbered.begin(), renumbered.end());
    return result;
}

Stroke withBridge(const Stroke &stroke, int first, int last)
{
    const int n = int(stroke.segments.size());
    first = std::max(first, 0);
    last = std::min(last, n - 1);
    if (first > last)
        return stroke;
    const std::vector<Segment> run(stroke.segments.begin() + first, stroke.segments.begin() + last + 1);
    const Cubic start = offsetsOf(run.front()), end = offsetsOf(run.back());
    const bool begins = stroke.beginsChain(std::size_t(first));
    const bool ends = last + 1 == n || stroke.beginsChain(std::size_t(last) + 1);
    const Point leaving =
        begins ? startDirection(start) : endDirection(offsetsOf(stroke.segments[std::size_t(first - 1)]));
    const Point arriving = ends ? endDirection(end) : startDirection(offsetsOf(stroke.segments[std::size_t(last + 1)]));
    Segment bridge = withValuesOf(run);
    bridge.bezier = toOffsets(arcBetween(start.p[0], leaving, end.p[3], arriving));
    bridge.bezier[0] = run.front().bezier[0];
    bridge.bezier[3] = run.back().bezier[3];
    if (isPoint(bridge))
        return stroke;
    if (!begins)
        bridge.node = NodeKind::Smooth;
    Stroke result = stroke;
    result.segments.erase(result.segments.begin() + first, result.segments.begin() + last + 1);
    result.segments.insert(result.segments.begin() + first, std::move(bridge));
    if (!ends)
        result.segments[std::size_t(first) + 1].node = NodeKind::Smooth;
    return validOr(std::move(result), stroke);
}

} // namespace suffuse
