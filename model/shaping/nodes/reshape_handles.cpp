#include "model/shaping/nodes/reshape_handles.h"

#include "model/painting/decimal.h"
#include "model/shaping/curves/split.h"
#include "model/shaping/nodes/reshape.h"

#include <set>

namespace suffuse {

namespace {

constexpr double nodeZone = 1.0 / 8; ///< parameters within which a drag of the curve takes the node along

Offset moved(Offset o, Point by)
{
    return toOffset(by + o, {});
}

Point vectorBetween(Offset from, Offset to)
{
    return (Point() + to) - (Point() + from);
}

bool makesPoints(const Stroke &after, const Stroke &before)
{
    for (std::size_t k = 0; k < after.segments.size(); ++k)
        if (isPoint(after.segments[k]) && !isPoint(before.segments[k]))
            return true;
    return false;
}

/// A node where a chain goes on, with its two handles.
struct HandleNode {
    Offset &before;
    Offset &arriving; ///< the end of the segment before, at the same place as `leaving`
    Offset &leaving;
    Offset &after;

    HandleNode(Stroke &stroke, const NodeSides &join)
        : before(stroke.segments[std::size_t(join.before)].bezier[2]),
          arriving(stroke.segments[std::size_t(join.before)].bezier[3]),
          leaving(stroke.segments[std::size_t(join.after)].bezier[0]),
          after(stroke.segments[std::size_t(join.after)].bezier[1])
    {}
    Point place() const { return Point() + leaving; }
};

void moveNode(Stroke &stroke, int node, Point by)
{
    const NodeSides sides = sidesOf(stroke, node);
    if (sides.before >= 0) {
        Segment &s = stroke.segments[std::size_t(sides.before)];
        s.bezier[2] = moved(s.bezier[2], by);
        s.bezier[3] = moved(s.bezier[3], by);
    }
    if (sides.after >= 0) {
        Segment &s = stroke.segments[std::size_t(sides.after)];
        s.bezier[0] = moved(s.bezier[0], by);
        s.bezier[1] = moved(s.bezier[1], by);
    }
}

/// Turns or mirrors the handle that is opposite to the moved one, as the kind demands that the node had before.
void followHandle(Stroke &stroke, int node, bool after, const Stroke &before)
{
    const std::optional<NodeSides> join = joinAt(stroke, node);
    const NodeKind kind = nodeKind(before, node);
    if (!join || kind == NodeKind::Corner)
        return;
    HandleNode n(stroke, *join);
    const Point own = vectorBetween(n.leaving, after ? n.after : n.before);
    Offset &opposite = after ? n.before : n.after;
    const double reach = kind == NodeKind::Symmetric ? length(own) : length(vectorBetween(n.leaving, opposite));
    if (own != Point())
        opposite = toOffset(n.place() - reach * unit(own), {});
}

/// Turns the two handles into one line, along the mean of the directions in which they point.
void makeSmooth(Stroke &stroke, const NodeSides &join, bool symmetric)
{
    HandleNode n(stroke, join);
    const Point in = vectorBetween(n.before, n.leaving), out = vectorBetween(n.leaving, n.after);
    double before = length(in), after = length(out);
    const bool isStraight = before > 0 && after > 0 && dot(unit(in), unit(out)) > 1 - 1e-12;
    const bool isEven = std::abs(before - after) <= 1e-6 * (before + after);
    if (isStraight && (!symmetric || isEven))
        return;
    const Segment &first = stroke.segments[std::size_t(join.before)];
    const Segment &second = stroke.segments[std::size_t(join.after)];
    const Point arriving = vectorBetween(first.bezier[0], n.leaving);
    const Point leaving = vectorBetween(n.leaving, second.bezier[3]);
    Point direction = unit(unit(before > 0 ? in : arriving) + unit(after > 0 ? out : leaving));
    if (direction == Point()) // At a hairpin the line lies across it.
        direction = unit(Point{-in.y, in.x} + Point{-arriving.y, arriving.x});
    if (direction == Point())
        return;
    if (before == 0)
        before = length(arriving) / 3;
    if (after == 0)
        after = length(leaving) / 3;
    if (symmetric)
        before = after = 0.5 * (before + after);
    const Point place = n.place();
    n.before = toOffset(place - before * direction, {});
    n.after = toOffset(place + after * direction, {});
}

} // namespace

std::optional<NodeSides> joinAt(const Stroke &stroke, int node)
{
    const NodeSides sides = sidesOf(stroke, node);
    if (sides.before < 0 && sides.after < 0)
        return {};
    if (sides.before >= 0 && sides.after >= 0)
        return sides;
    const Chain chain = chainAt(stroke, std::max(sides.before, sides.after));
    return isClosed(stroke, chain) ? std::optional(NodeSides{chain.last, chain.first}) : std::nullopt;
}

Stroke withNodeMoved(const Stroke &stroke, const std::vector<int> &nodes, Point by)
{
    std::set<int> wanted;
    for (int node : nodes)
        for (const int each : nodesTogether(stroke, node))
            wanted.insert(each);
    Stroke result = stroke;
    if (int(wanted.size()) == nodeCount(stroke)) {
        result.origin = {decimalSum(stroke.origin.x, by.x), decimalSum(stroke.origin.y, by.y)};
        return validOr(std::move(result), stroke);
    }
    // A segment that would shrink to a point stops a hair's breadth before.
    double hair = 0;
    for (const Segment &s : stroke.segments)
        hair = std::max(hair, resolutionAt(offsetsOf(s)));
    for (Point aside : {Point{}, Point{hair, 0}, Point{0, hair}}) {
        result.segments = stroke.segments;
        for (int node : wanted)
            moveNode(result, node, by + aside);
        if (!makesPoints(result, stroke))
            return validOr(std::move(result), stroke);
    }
    return stroke;
}

Stroke withHandleMoved(const Stroke &stroke, int node, bool after, Point to)
{
    if (!handlePosition(stroke, node, after))
        return stroke;
    Stroke result = stroke;
    const NodeSides sides = sidesOf(stroke, node);
    if (after)
        result.segments[std::size_t(sides.after)].bezier[1] = toOffset(to, stroke.origin);
    else
        result.segments[std::size_t(sides.before)].bezier[2] = toOffset(to, stroke.origin);
    followHandle(result, node, after, stroke);
    return makesPoints(result, stroke) ? stroke : validOr(std::move(result), stroke);
}

Stroke withNodeKind(const Stroke &stroke, const std::vector<int> &nodes, NodeKind kind)
{
    Stroke result = stroke;
    std::set<int> done; // A seam has two numbers.
    for (int node : nodes) {
        const std::optional<NodeSides> join = joinAt(stroke, node);
        if (!join || !done.insert(join->after).second)
            continue;
        if (kind != NodeKind::Corner)
            makeSmooth(result, *join, kind == NodeKind::Symmetric);
        result.segments[std::size_t(join->after)].node = kind;
    }
    return makesPoints(result, stroke) ? stroke : validOr(std::move(result), stroke);
}

Stroke withCurveDragged(const Stroke &stroke, int segment, double p, Point by)
{
    if (segment < 0 || segment >= int(stroke.segments.size()))
        return stroke;
    Stroke result = stroke;
    Segment &s = result.segments[std::size_t(segment)];
    const Point before = offsetsOf(s).at(p);
    // Near a node the handles alone would have to swing far out.
    if (const double toNode = std::min(p, 1 - p); toNode < nodeZone)
        for (const int node : nodesTogether(stroke, p < 0.5 ? segment : endNode(stroke, segment)))
            moveNode(result, node, (1 - toNode / nodeZone) * by);
    // The smallest movement of the two handles that takes the point the rest of the way.
    const Point rest = before + by - offsetsOf(s).at(p);
    const double first = 3 * (1 - p) * (1 - p) * p, second = 3 * (1 - p) * p * p;
    if (const double squares = first * first + second * second; squares > 1e-12) {
        s.bezier[1] = moved(s.bezier[1], (first / squares) * rest);
        s.bezier[2] = moved(s.bezier[2], (second / squares) * rest);
    }
    followHandle(result, segment, true, stroke);
    followHandle(result, endNode(stroke, segment), false, stroke);
    return makesPoints(result, stroke) ? stroke : validOr(std::move(result), stroke);
}

} // namespace suffuse
