#include "model/shaping/reshape.h"

#include "model/painting/bernstein.h"
#include "model/shaping/merge.h"
#include "model/shaping/split.h"

#include <set>

namespace suffuse {

namespace {

/// Squared distance from a point to a box; 0 inside.
double squaredDistance(const Rect &box, Point p)
{
    const double x = std::max({box.left - p.x, p.x - box.right, 0.0});
    const double y = std::max({box.top - p.y, p.y - box.bottom, 0.0});
    return x * x + y * y;
}

} // namespace

Point nodePosition(const Stroke &stroke, int node)
{
    return node < int(stroke.segments.size()) ? stroke.origin + stroke.segments[std::size_t(node)].bezier[0]
                                              : stroke.origin + stroke.segments.back().bezier[3];
}

NodeKind nodeKind(const Stroke &stroke, int node)
{
    return isInnerNode(stroke, node) ? stroke.segments[std::size_t(node)].node : NodeKind::Corner;
}

std::optional<Point> handlePosition(const Stroke &stroke, int node, bool after)
{
    const int segment = after ? node : node - 1;
    if (segment < 0 || segment >= int(stroke.segments.size()))
        return std::nullopt;
    return stroke.origin + stroke.segments[std::size_t(segment)].bezier[after ? 1 : 2];
}

std::vector<int> cornersOf(const Stroke &stroke)
{
    std::vector<int> corners;
    for (std::size_t k = 1; k < stroke.segments.size(); ++k) {
        const Point in = endDirection(offsetsOf(stroke.segments[k - 1]));
        const Point out = startDirection(offsetsOf(stroke.segments[k]));
        if (dot(in, out) < 0.9998) // more than about a degree
            corners.push_back(int(k));
    }
    return corners;
}

CurvePlace nearestPlace(const Stroke &stroke, Point point, double *distance)
{
    CurvePlace best;
    double nearest = std::numeric_limits<double>::infinity(); // squared
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
    int first = 0, last = int(stroke.segments.size()); // nodes
    while (gone.contains(first))
        ++first;
    while (gone.contains(last))
        --last;
    Stroke result = stroke;
    result.segments.clear();
    std::vector<int> from;
    for (int k = first; k < last;) {
        int next = k + 1;
        while (next < last && gone.contains(next))
            ++next;
        const std::vector<Segment> run(stroke.segments.begin() + k, stroke.segments.begin() + next);
        Segment one = merged(run);
        const bool isWhole = next == k + 1 || !isPoint(one);
        for (int i = k; i < (isWhole ? k + 1 : next); ++i) {
            result.segments.push_back(isWhole ? one : stroke.segments[std::size_t(i)]);
            from.push_back(i);
        }
        k = next;
    }
    if (result.segments.empty()) {
        result = stroke;
        for (int k = 0; k < int(stroke.segments.size()); ++k)
            from.push_back(k);
    }
    if (sources)
        *sources = std::move(from);
    return validOr(std::move(result), stroke);
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
    const Point leaving =
        first > 0 ? endDirection(offsetsOf(stroke.segments[std::size_t(first - 1)])) : startDirection(start);
    const Point arriving =
        last + 1 < n ? startDirection(offsetsOf(stroke.segments[std::size_t(last + 1)])) : endDirection(end);
    Segment bridge = withValuesOf(run);
    bridge.bezier = toOffsets(arcBetween(start.p[0], leaving, end.p[3], arriving));
    bridge.bezier[0] = run.front().bezier[0];
    bridge.bezier[3] = run.back().bezier[3];
    if (isPoint(bridge))
        return stroke;
    if (first > 0)
        bridge.node = NodeKind::Smooth;
    Stroke result = stroke;
    result.segments.erase(result.segments.begin() + first, result.segments.begin() + last + 1);
    result.segments.insert(result.segments.begin() + first, std::move(bridge));
    if (last + 1 < n)
        result.segments[std::size_t(first) + 1].node = NodeKind::Smooth;
    return validOr(std::move(result), stroke);
}

} // namespace suffuse
