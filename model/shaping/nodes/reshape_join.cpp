#include "model/painting/validate.h"
#include "model/shaping/curves/runs.h"
#include "model/shaping/curves/split.h"
#include "model/shaping/nodes/reshape.h"

namespace suffuse {

namespace {

/// Offsets whose distance is at most this are one place.
double weldingDistance(Offset a, Offset b)
{
    return resolutionAt(Cubic{{Point() + a, Point() + b, {}, {}}});
}

double distance(Offset a, Offset b)
{
    return length((Point() + a) - (Point() + b));
}

NodeKind kindBetween(const Segment &before, const Segment &after)
{
    return breaksBetween(before, after) ? NodeKind::Corner : NodeKind::Smooth;
}

/// A segment from the end of one segment to the start of another, with the values of a third.
Segment bridgeBetween(const Segment &before, const Segment &after, const Segment &values)
{
    Segment bridge = values;
    const Cubic in = offsetsOf(before), out = offsetsOf(after);
    bridge.bezier = toOffsets(arcBetween(in.p[3], endDirection(in), out.p[0], startDirection(out)));
    bridge.bezier[0] = before.bezier[3];
    bridge.bezier[3] = after.bezier[0];
    return bridge;
}

/// A stroke's segments as offsets from another stroke's origin, with the style that they had.
std::vector<Segment> movedOver(const Stroke &stroke, const Stroke &to)
{
    std::vector<Segment> segments = stroke.segments;
    const Point shift = stroke.origin - to.origin;
    for (Segment &s : segments) {
        for (Offset &o : s.bezier)
            o = toOffset(shift + o, {});
        if (!s.style && stroke.style != to.style)
            s.style = stroke.style;
    }
    return segments;
}

/// Appends `tail` to `segments`. A bridge gets the values of the tail if `valuesOfTail`, else those before it.
void append(std::vector<Segment> &segments, std::vector<Segment> tail, bool valuesOfTail)
{
    Segment &last = segments.back(), &first = tail.front();
    if (distance(last.bezier[3], first.bezier[0]) <= weldingDistance(last.bezier[3], first.bezier[0])) {
        // The side that gives the values keeps its place, to the last bit.
        if (valuesOfTail)
            last.bezier[3] = first.bezier[0];
        else
            first.bezier[0] = last.bezier[3];
    } else {
        Segment bridge = bridgeBetween(last, first, valuesOfTail ? first : last);
        bridge.node = kindBetween(last, bridge);
        segments.push_back(std::move(bridge));
    }
    first.node = kindBetween(segments.back(), first);
    first.start = false;
    segments.insert(segments.end(), std::make_move_iterator(tail.begin()), std::make_move_iterator(tail.end()));
}

bool hasPoints(const std::vector<Segment> &segments)
{
    return std::any_of(segments.begin(), segments.end(), isPoint);
}

} // namespace

Stroke reversed(const Stroke &stroke)
{
    Stroke result = stroke;
    std::reverse(result.segments.begin(), result.segments.end());
    const std::size_t n = stroke.segments.size();
    for (std::size_t k = 0; k < n; ++k) {
        Segment &s = result.segments[k];
        std::reverse(s.bezier.begin(), s.bezier.end());
        // The kind, and whether there is a gap, belong to the node at the start. Ends have no kind, so the two share
        // what is written there.
        const Segment &node = stroke.segments[k == 0 ? 0 : n - k];
        s.node = node.node;
        s.start = k > 0 && node.start;
    }
    return result;
}

bool join(Stroke &a, bool aAtEnd, const Stroke &b, bool bAtEnd)
{
    // Only what is new is checked, and a's segment beside it.
    const Segment &end = aAtEnd ? a.segments.back() : a.segments.front();
    Stroke added;
    added.id = a.id;
    added.style = a.style;
    added.origin = a.origin;
    if (aAtEnd) {
        added.segments = {end}; // If the segment begins a chain of a, that does not matter here.
        append(added.segments, movedOver(bAtEnd ? reversed(b) : b, a), false);
    } else {
        added.segments = movedOver(bAtEnd ? b : reversed(b), a);
        append(added.segments, {end}, true);
    }
    if ((hasPoints(added.segments) && !isPoint(end) && !hasPoints(b.segments)) || !problemOf(added).isEmpty())
        return false;
    auto from = std::make_move_iterator(added.segments.begin()), to = std::make_move_iterator(added.segments.end());
    if (aAtEnd) {
        a.segments.back() = *from;
        a.segments.insert(a.segments.end(), from + 1, to);
    } else {
        a.segments.front() = *(to - 1);
        a.segments.front().start = false;
        a.segments.insert(a.segments.begin(), from, to - 1);
    }
    return true;
}

std::optional<Stroke> joined(const Stroke &a, bool aAtEnd, const Stroke &b, bool bAtEnd)
{
    Stroke result = a;
    if (!join(result, aAtEnd, b, bAtEnd))
        return std::nullopt;
    return result;
}

std::optional<Stroke> closed(const Stroke &stroke)
{
    if (const std::vector<Chain> chains = chainsOf(stroke); chains.size() > 1)
        return joinedWithin(stroke, int(stroke.segments.size()), 0);
    const Segment &first = stroke.segments.front(), &last = stroke.segments.back();
    if (distance(last.bezier[3], first.bezier[0]) <= weldingDistance(last.bezier[3], first.bezier[0]))
        return std::nullopt;
    Stroke result = stroke;
    Segment bridge = bridgeBetween(last, first, last);
    bridge.node = kindBetween(last, bridge);
    result.segments.push_back(std::move(bridge));
    return result;
}

namespace {

/// The chain that ends or begins at a node, by itself, and the side on which the node is.
struct ChainEnd {
    Chain chain;
    Stroke stroke;
    bool atEnd = false;

    ChainEnd(const Stroke &whole, const NodeSides &sides)
        : chain(chainAt(whole, std::max(sides.before, sides.after))), stroke(chainOnly(whole, chain)),
          atEnd(sides.before >= 0)
    {}
};

bool isChainEnd(const NodeSides &sides)
{
    return (sides.before < 0) != (sides.after < 0);
}

/// The stroke with other segments in the place of one of its chains, and without another chain if one is given.
Stroke withChain(const Stroke &stroke, const Chain &place, const std::vector<Segment> &segments, const Chain *gone)
{
    Stroke result = stroke;
    result.segments.clear();
    for (const Chain &chain : chainsOf(stroke)) {
        if (chain == place)
            appendChain(result, segments);
        else if (!gone || chain != *gone)
            appendChain(result, chainOnly(stroke, chain).segments);
    }
    return result;
}

} // namespace

std::optional<Stroke> joinedAt(const Stroke &a, int aNode, const Stroke &b, int bNode)
{
    const NodeSides aSides = sidesOf(a, aNode), bSides = sidesOf(b, bNode);
    if (!isChainEnd(aSides) || !isChainEnd(bSides))
        return std::nullopt;
    const ChainEnd end(a, aSides), other(b, bSides);
    const std::optional<Stroke> chain = joined(end.stroke, end.atEnd, other.stroke, other.atEnd);
    if (!chain)
        return std::nullopt;
    Stroke result = withChain(a, end.chain, chain->segments, nullptr);
    for (const Chain &more : chainsOf(b))
        if (more != other.chain)
            appendChain(result, movedOver(chainOnly(b, more), a));
    return problemOf(result).isEmpty() || !problemOf(a).isEmpty() ? std::optional(std::move(result)) : std::nullopt;
}

std::optional<Stroke> combined(const Stroke &a, const Stroke &b)
{
    Stroke result = a;
    appendChain(result, movedOver(b, a));
    return problemOf(result).isEmpty() ? std::optional(std::move(result)) : std::nullopt;
}

std::optional<Stroke> joinedWithin(const Stroke &stroke, int node, int other)
{
    const NodeSides sides = sidesOf(stroke, node), otherSides = sidesOf(stroke, other);
    if (node == other || !isChainEnd(sides) || !isChainEnd(otherSides))
        return std::nullopt;
    const ChainEnd one(stroke, sides), two(stroke, otherSides);
    const std::optional<Stroke> chain =
        one.chain == two.chain ? closed(one.stroke) : joined(one.stroke, one.atEnd, two.stroke, two.atEnd);
    if (!chain)
        return std::nullopt;
    return withChain(stroke, one.chain, chain->segments, one.chain == two.chain ? nullptr : &two.chain);
}

} // namespace suffuse
