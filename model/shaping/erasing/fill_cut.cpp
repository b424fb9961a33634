#include "model/shaping/erasing/fill_cut.h"

#include "model/area/offset_curve.h"
#include "model/area/outline.h"
#include "model/geometry/bernstein.h"
#include "model/shaping/curves/split.h"
#include "model/shaping/erasing/fill_rings.h"

#include <algorithm>
#include <numbers>
#include <set>

namespace suffuse {

namespace {

/// Finds where rings change the side of a cut. `candidates(curve)` gives the parameters where they may, `side(point)`
/// is 1, −1, or 0 on the cut itself, where a ring is on the side that it was on before. `touches` gets whether a part
/// of a ring lies on the cut; `sides` whether a ring without gates is at the side 1 (or nowhere but on the cut).
template <typename Cut>
std::vector<RingGate> gatesAt(const std::vector<Ring> &rings, const Cut &cut, bool *touches = nullptr,
                              std::vector<bool> *sides = nullptr)
{
    struct Part {
        int curve;
        double from;
        int side;
    };
    std::vector<RingGate> gates;
    for (int r = 0; r < int(rings.size()); ++r) {
        std::vector<Part> parts;
        const Ring &ring = rings[std::size_t(r)];
        for (int c = 0; c < int(ring.curves.size()); ++c) {
            const Cubic &curve = ring.curves[std::size_t(c)].curve;
            std::vector<double> ends = distinct(cut.candidates(curve), curve);
            ends.push_back(1);
            double from = 0;
            for (const double to : ends) {
                parts.push_back({c, from, cut.side(curve.at(0.5 * (from + to)))});
                if (touches && parts.back().side == 0)
                    *touches = true;
                from = to;
            }
        }
        const auto known = std::ranges::find_if(parts, [](const Part &part) { return part.side != 0; });
        if (sides)
            sides->push_back(known == parts.end() || known->side > 0);
        if (known == parts.end())
            continue;
        const auto first = std::size_t(known - parts.begin());
        int side = known->side;
        for (std::size_t i = 1; i <= parts.size(); ++i) {
            const Part &part = parts[(first + i) % parts.size()];
            if (part.side == 0 || part.side == side)
                continue;
            side = part.side;
            const Point at = ring.curves[std::size_t(part.curve)].curve.at(part.from);
            gates.push_back({r, part.curve, part.from, side, cut.place(at), -1, {}});
        }
    }
    return gates;
}

/// Pairs the gates in the order of their places, as brackets are: the ring of each pair's first gate goes in, that of
/// the other one comes back. So each step of the winding number along the cut begins and ends in a pair.
std::vector<std::pair<int, int>> pairsOf(const std::vector<RingGate> &gates, const std::vector<int> &order)
{
    std::vector<std::pair<int, int>> pairs;
    std::vector<int> open;
    for (const int g : order) {
        if (open.empty() || gates[std::size_t(open.back())].sign == gates[std::size_t(g)].sign) {
            open.push_back(g);
            continue;
        }
        pairs.emplace_back(open.back(), g);
        open.pop_back();
    }
    return pairs;
}

std::vector<int> byPlace(const std::vector<RingGate> &gates)
{
    std::vector<int> order;
    for (int g = 0; g < int(gates.size()); ++g)
        order.push_back(g);
    std::ranges::stable_sort(order, {}, [&](int g) { return gates[std::size_t(g)].place; });
    return order;
}

/// A straight cut, seen from the stroke's origin. It goes on beyond its ends, where nothing is cut.
struct StraightCut {
    Point from, along; ///< a unit vector
    double tolerance;

    std::vector<double> candidates(const Cubic &curve) const
    {
        return bernsteinRoots(distanceFromLine(curve, from, turned(along)));
    }
    int side(Point p) const
    {
        const double d = cross(along, p - from);
        return std::abs(d) <= tolerance ? 0 : d > 0 ? 1 : -1;
    }
    double place(Point p) const { return dot(along, p - from); }
};

/// The gates of a cut from a to b, each with its partner where both are within it.
std::vector<RingGate> gatesOfLine(const Stroke &stroke, const std::vector<Ring> &rings, Point a, Point b)
{
    const Point along = unit(b - a);
    if (along == Point())
        return {};
    double tolerance = 0;
    for (const Ring &ring : rings)
        for (const RingCurve &part : ring.curves)
            tolerance = std::max(tolerance, resolutionAt(part.curve));
    std::vector<RingGate> gates = gatesAt(rings, StraightCut{a - stroke.origin, along, tolerance});
    const double end = length(b - a);
    for (const auto &[g, h] : pairsOf(gates, byPlace(gates))) {
        RingGate &in = gates[std::size_t(g)], &out = gates[std::size_t(h)];
        if (in.place < 0 || out.place > end)
            continue;
        in.partner = h;
        out.partner = g;
    }
    return gates;
}

bool isCut(const std::vector<RingGate> &gates)
{
    return std::ranges::any_of(gates, [](const RingGate &gate) { return gate.partner >= 0; });
}

/// The places that are nearer than a radius to a line from a to b. Along its boundary places go from 0 to 4, from the x
/// axis towards the y axis: around b, back to a, around a, and back to b.
struct RoundCut {
    Point a, b, along{1, 0};
    double radius;
    double length;

    RoundCut(Point from, Point to, double r) : a(from), b(to), radius(r), length(suffuse::length(to - from))
    {
        if (length > 0)
            along = unit(to - from);
    }

    /// What is so near to the boundary lies on it, as what was erased before does.
    static constexpr double nearness = 1e-3;

    std::vector<double> candidates(const Cubic &curve) const
    {
        std::vector<double> all;
        const auto add = [&all](std::span<const double> f) {
            const std::vector<double> roots = bernsteinRoots(f);
            all.insert(all.end(), roots.begin(), roots.end());
        };
        Rect box;
        box.include(a);
        box.include(b);
        if (!box.grown(2 * radius).intersects(curve.controlBox()))
            return all;
        const Point across = turned(along);
        for (const Point end : {a, b}) {
            add(powerOfCircle(curve, end, radius));
            add(distanceFromLine(curve, end, along)); // where the boundary is no circle any more
        }
        add(distanceFromLine(curve, a + radius * across, across));
        add(distanceFromLine(curve, a - radius * across, across));
        return all;
    }
    int side(Point p) const
    {
        const double t = std::clamp(dot(along, p - a), 0.0, length);
        const double d = suffuse::length(p - (a + t * along)) - radius;
        return std::abs(d) <= nearness * radius ? 0 : d > 0 ? 1 : -1;
    }
    double place(Point p) const
    {
        const Point across = turned(along);
        const double t = dot(along, p - a), side = dot(across, p - a);
        const auto around = [&](Point centre, Point axis) {
            return 0.5 + std::atan2(cross(axis, p - centre), dot(axis, p - centre)) / std::numbers::pi;
        };
        if (t > length || (length == 0 && t >= 0))
            return around(b, along);
        if (t < 0)
            return 2 + around(a, -1.0 * along);
        return side > 0 ? 1 + (length - t) / length : 3 + t / length;
    }
    /// The point at a place, or within the boundary for a share below 1.
    Point at(double place, double share = 1) const
    {
        const Point across = turned(along);
        const int part = std::clamp(int(place), 0, 3);
        const double t = place - part, angle = (t - 0.5) * std::numbers::pi, r = share * radius;
        switch (part) {
        case 0:
            return b + r * (std::cos(angle) * along + std::sin(angle) * across);
        case 1:
            return b - (t * length) * along + r * across;
        case 2:
            return a - r * (std::cos(angle) * along + std::sin(angle) * across);
        default:
            return a + (t * length) * along - r * across;
        }
    }
    /// The boundary with growing places, from one to a greater one; those from 4 on are a turn farther.
    std::vector<NewCurve> boundary(double from, double to) const
    {
        std::vector<NewCurve> curves;
        for (double place = from; place < to;) {
            const double next = std::min(to, std::floor(place) + 1), turn = 4 * std::floor(place / 4);
            const int part = int(std::floor(place)) % 4;
            if (part % 2 == 0)
                for (const Cubic &arc :
                     arcAround(part == 0 ? b : a, at(place - turn), (next - place) * std::numbers::pi))
                    curves.push_back({arc, false});
            else if (length > 0)
                curves.push_back({straightCubic(at(place - turn), at(next - turn)), true});
            place = next;
        }
        return curves;
    }
};

std::vector<NewCurve> backwards(std::vector<NewCurve> curves)
{
    std::ranges::reverse(curves);
    for (NewCurve &part : curves)
        std::ranges::reverse(part.curve.p);
    return curves;
}

double distanceFrom(const Cubic &curve, Point p)
{
    double least = std::min(length(curve.p[0] - p), length(curve.p[3] - p));
    for (const double t : bernsteinRoots(distanceSlope(curve, p)))
        least = std::min(least, length(curve.at(t) - p));
    return least;
}

/// A place of a round cut's boundary that is far from all rings, so that it is clear how often they run around it.
/// Where rings lie on all of the boundary, as what was erased before may, it is negative, and a point within counts.
double placeToCount(const std::vector<Ring> &rings, const RoundCut &cut, bool touches)
{
    constexpr int places = 64;
    double best = -1e-9, farthest = (touches ? 2 : 1e-3) * RoundCut::nearness * cut.radius;
    for (int i = 0; i < places && farthest < 0.1 * cut.radius; ++i) {
        const double place = 4 * (((i * 37) % places) + 0.5) / places; // not one beside the other
        const Point at = cut.at(place);
        double least = cut.radius;
        for (const Ring &ring : rings)
            for (const RingCurve &part : ring.curves)
                if (least > farthest && part.curve.controlBox().grown(least).contains(at))
                    least = std::min(least, distanceFrom(part.curve, at));
        if (least > farthest) {
            farthest = least;
            best = place;
        }
    }
    return best;
}

/// What a round cut does to rings.
struct RoundGates {
    std::vector<RingGate> gates; ///< in pairs; places grow from the first to the second of each
    std::vector<bool> isOutside; ///< for each ring, if no gate cuts it
    int around = 0;              ///< how often the rings run around all of its boundary, whatever the gates take off
};

RoundGates gatesOfRound(const std::vector<Ring> &rings, const RoundCut &cut)
{
    RoundGates result;
    bool touches = false;
    result.gates = gatesAt(rings, cut, &touches, &result.isOutside);
    std::vector<RingGate> &gates = result.gates;
    std::vector<int> order = byPlace(gates);
    const auto count = std::ptrdiff_t(order.size());
    const double counted = placeToCount(rings, cut, touches);
    result.around = windingOf(rings, cut.at(std::abs(counted), counted < 0 ? 1 - 3 * RoundCut::nearness : 1));
    if (count == 0)
        return result;
    // From there on each gate changes the winding number by one.
    int winding = result.around;
    std::ptrdiff_t gap = 0; // the number of gates before the place
    while (gap < count && gates[std::size_t(order[std::size_t(gap)])].place <= std::abs(counted))
        ++gap;
    std::ptrdiff_t first = gap; // the gate behind the gap that is run around least
    for (std::ptrdiff_t i = gap; i < gap + count - 1; ++i) {
        winding += gates[std::size_t(order[std::size_t(i % count)])].sign;
        if (std::abs(winding) < std::abs(result.around)) {
            result.around = winding;
            first = i + 1;
        }
    }
    first %= count;
    for (std::ptrdiff_t i = 0; i < first; ++i)
        gates[std::size_t(order[std::size_t(i)])].place += 4;
    std::rotate(order.begin(), order.begin() + first, order.end());
    for (const auto &[g, h] : pairsOf(gates, order)) {
        gates[std::size_t(g)].partner = h;
        gates[std::size_t(h)].partner = g;
    }
    return result;
}

/// Without what is nearer to a line than the radius. No value where that touches nothing.
std::optional<Stroke> withoutRound(const Stroke &stroke, const RoundCut &cut, std::vector<int> *sources)
{
    std::vector<Ring> rings = ringsOf(stroke);
    const RoundGates found = gatesOfRound(rings, cut);
    const bool stays = std::ranges::all_of(found.isOutside, [](bool outside) { return outside; });
    if (found.gates.empty() && stays && found.around == 0)
        return std::nullopt;
    RingCutter cutter(stroke, std::move(rings), found.gates);
    cutter.follow([](int sign) { return sign > 0; }, [&](int ring) { return bool(found.isOutside[std::size_t(ring)]); },
                  [&](const RingGate &from, const RingGate &to) {
                      return from.place < to.place ? cut.boundary(from.place, to.place)
                                                   : backwards(cut.boundary(to.place, from.place));
                  });
    for (int i = 0; i < std::abs(found.around); ++i)
        cutter.addLoop(found.around > 0 ? backwards(cut.boundary(0, 4)) : cut.boundary(0, 4));
    return cutter.result(sources);
}

std::vector<int> inOrder(std::size_t count)
{
    std::vector<int> all(count);
    for (std::size_t k = 0; k < count; ++k)
        all[k] = int(k);
    return all;
}

} // namespace

Stroke filledCut(const Stroke &stroke, Point a, Point b, std::vector<int> *sources)
{
    std::vector<Ring> rings = ringsOf(stroke);
    std::vector<RingGate> gates = gatesOfLine(stroke, rings, a, b);
    if (!isCut(gates)) {
        if (sources)
            *sources = inOrder(stroke.segments.size());
        return stroke;
    }
    RingCutter cutter(stroke, std::move(rings), std::move(gates));
    cutter.follow([](int) { return true; }, [](int) { return true; },
                  [](const RingGate &from, const RingGate &to) {
                      return std::vector<NewCurve>{{straightCubic(Point() + from.at, Point() + to.at), true}};
                  });
    return validOr(cutter.result(sources), stroke);
}

std::vector<CurvePlace> filledCutPlaces(const Stroke &stroke, Point a, Point b)
{
    const std::vector<Ring> rings = ringsOf(stroke);
    std::set<CurvePlace> places;
    for (const RingGate &gate : gatesOfLine(stroke, rings, a, b)) {
        const int segment = rings[std::size_t(gate.ring)].curves[std::size_t(gate.curve)].segment;
        if (gate.partner >= 0 && segment >= 0)
            places.insert({segment, gate.p});
    }
    return {places.begin(), places.end()};
}

std::optional<Stroke> filledErased(const Stroke &stroke, const std::vector<Point> &path, double radius,
                                   std::vector<int> *sources)
{
    Stroke left = stroke;
    std::vector<int> from = inOrder(stroke.segments.size());
    for (std::size_t i = 0; radius > 0 && i < path.size() && left.laysPaint(); ++i) {
        if (i == 0 && path.size() > 1)
            continue;
        const Point a = path[i == 0 ? 0 : i - 1] - stroke.origin, b = path[i] - stroke.origin;
        Rect reach;
        reach.include(a);
        reach.include(b);
        if (!reach.grown(radius).intersects(outlineBox(left)))
            continue;
        std::vector<int> step;
        std::optional<Stroke> next = withoutRound(left, RoundCut(a, b, radius), &step);
        if (!next)
            continue;
        left = std::move(*next);
        for (int &source : step)
            source = source < 0 ? -1 : from[std::size_t(source)];
        from = std::move(step);
    }
    if (sources)
        *sources = std::move(from);
    return left.laysPaint() ? std::optional(std::move(left)) : std::nullopt;
}

Stroke filledCutAt(const Stroke &stroke, const std::vector<CurvePlace> &places, std::vector<int> *sources)
{
    std::vector<Ring> rings = ringsOf(stroke);
    std::vector<std::vector<double>> parameters(stroke.segments.size());
    std::set<int> nodes;
    for (const CurvePlace &place : places) {
        if (place.segment < 0 || place.segment >= int(stroke.segments.size()))
            continue;
        const int node = nodeAt(stroke, place);
        if (node < 0)
            parameters[std::size_t(place.segment)].push_back(place.p);
        else if (isInnerNode(stroke, node))
            nodes.insert(node);
    }
    std::vector<RingGate> gates;
    for (int r = 0; r < int(rings.size()); ++r)
        for (int c = 0; c < int(rings[std::size_t(r)].curves.size()); ++c) {
            const RingCurve &curve = rings[std::size_t(r)].curves[std::size_t(c)];
            if (curve.segment < 0)
                continue;
            std::vector<double> at = distinct(parameters[std::size_t(curve.segment)], curve.curve);
            if (nodes.contains(curve.segment))
                at.insert(at.begin(), 0);
            for (const double p : at)
                gates.push_back({r, c, p, 1, 0, 0, {}});
        }
    if (gates.empty()) {
        if (sources)
            *sources = inOrder(stroke.segments.size());
        return stroke;
    }
    RingCutter cutter(stroke, std::move(rings), std::move(gates));
    cutter.open();
    return validOr(cutter.result(sources), stroke);
}

std::optional<Stroke> filledWithout(const Stroke &stroke, const std::vector<int> &gone, std::vector<int> *sources)
{
    const std::set<int> without(gone.begin(), gone.end());
    RingCutter cutter(stroke, ringsOf(stroke), {});
    cutter.leaveOut(without);
    Stroke result = cutter.result(sources);
    return result.laysPaint() ? std::optional(std::move(result)) : std::nullopt;
}

} // namespace suffuse
