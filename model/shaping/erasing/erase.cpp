#include "model/shaping/erasing/erase.h"

#include "model/area/outline.h"
#include "model/geometry/bernstein.h"
#include "model/shaping/curves/split.h"
#include "model/shaping/erasing/fill_cut.h"
#include "model/shaping/erasing/unfilled.h"

#include <functional>
#include <numeric>
#include <set>

namespace suffuse {

namespace {

/// The points that are nearer than a radius to a line from a to b. It is a disc where both are one point.
struct Capsule {
    Point a, b;
    Rect box;
};

double squaredDistance(const Capsule &capsule, Point p)
{
    const Point along = capsule.b - capsule.a, d = p - capsule.a;
    const double l2 = dot(along, along);
    const double t = l2 > 0 ? std::clamp(dot(d, along) / l2, 0.0, 1.0) : 0;
    const Point off = d - t * along;
    return dot(off, off);
}

/// The capsules of a path, seen from a stroke's origin.
std::vector<Capsule> capsulesOf(const std::vector<Point> &path, double radius, Point origin)
{
    std::vector<Capsule> capsules;
    const auto add = [&](Point a, Point b) {
        Rect box;
        box.include(a);
        box.include(b);
        capsules.push_back({a, b, box.grown(radius)});
    };
    for (std::size_t i = 1; i < path.size(); ++i)
        if (path[i] != path[i - 1])
            add(path[i - 1] - origin, path[i] - origin);
    if (capsules.empty() && !path.empty())
        add(path[0] - origin, path[0] - origin);
    return capsules;
}

/// Compares one segment with the part of the path that comes near it.
class Eraser {
public:
    Eraser(const std::vector<Capsule> &path, double radius, const Cubic &curve) : m_radius(radius), m_curve(curve)
    {
        const Rect box = curve.controlBox();
        for (const Capsule &capsule : path)
            if (capsule.box.intersects(box))
                m_near.push_back(&capsule);
    }

    bool isInside(double p) const
    {
        const Point at = m_curve.at(p);
        return std::any_of(m_near.begin(), m_near.end(),
                           [&](const Capsule *c) { return squaredDistance(*c, at) < m_radius * m_radius; });
    }

    /// The parameters where the curve goes into the path's area or out of it. Where it only touches the area, it does
    /// neither.
    std::vector<double> cuts() const
    {
        if (m_near.empty())
            return {};
        std::vector<double> candidates;
        const auto add = [&candidates](std::span<const double> f) {
            const std::vector<double> roots = bernsteinRoots(f);
            candidates.insert(candidates.end(), roots.begin(), roots.end());
        };
        for (const Capsule *c : m_near) {
            add(powerOfCircle(m_curve, c->a, m_radius));
            add(powerOfCircle(m_curve, c->b, m_radius));
            const Point along = unit(c->b - c->a), normal{-along.y, along.x};
            add(distanceFromLine(m_curve, c->a + m_radius * normal, normal));
            add(distanceFromLine(m_curve, c->a - m_radius * normal, normal));
        }
        candidates = distinct(std::move(candidates), m_curve);
        std::vector<double> result;
        double from = 0;
        std::optional<bool> before;
        for (std::size_t i = 0; i <= candidates.size(); ++i) {
            const double to = i < candidates.size() ? candidates[i] : 1;
            const bool inside = isInside(0.5 * (from + to));
            if (before && *before != inside)
                result.push_back(from);
            before = inside;
            from = to;
        }
        return result;
    }

private:
    double m_radius;
    const Cubic &m_curve;
    std::vector<const Capsule *> m_near;
};

/// Appends runs of pieces as strokes of their own. `starts` says before which piece a run begins, `keeps` which pieces
/// stay.
template <typename Starts, typename Keeps>
std::vector<Stroke> runsOf(const Stroke &stroke, std::vector<Piece> &pieces, Starts starts, Keeps keeps)
{
    Stroke empty = stroke;
    empty.segments.clear();
    std::vector<Stroke> runs;
    bool open = false;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!keeps(i)) {
            open = false;
            continue;
        }
        if (!open || starts(i)) {
            runs.push_back(empty);
            pieces[i].segment.start = false;
        }
        open = true;
        runs.back().segments.push_back(std::move(pieces[i].segment));
    }
    return runs;
}

/// The segments, cut where the path goes in or out, and which of the pieces lie inside.
struct ErasedPieces {
    std::vector<Piece> pieces;
    std::vector<bool> inside;
};

/// The pieces of a stroke; no value where the path touches nothing of it.
std::optional<ErasedPieces> erasedPieces(const Stroke &stroke, const std::vector<Point> &path, double radius,
                                         Microseconds T)
{
    if (!(radius > 0))
        return std::nullopt;
    const std::vector<Capsule> capsules = capsulesOf(path, radius, stroke.origin);
    std::vector<std::vector<double>> cuts(stroke.segments.size());
    std::vector<bool> startsInside(stroke.segments.size());
    bool touched = false;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        if (stroke.segments[k].born > T || stroke.segments[k].takesPaint())
            continue;
        const Cubic curve = offsetsOf(stroke.segments[k]);
        const Eraser eraser(capsules, radius, curve);
        cuts[k] = eraser.cuts();
        startsInside[k] = eraser.isInside(0.5 * (cuts[k].empty() ? 1 : cuts[k].front()));
        touched = touched || startsInside[k] || !cuts[k].empty();
    }
    if (!touched)
        return std::nullopt;
    ErasedPieces result{piecesOf(stroke, cuts), {}};
    for (std::size_t i = 0; i < result.pieces.size(); ++i) { // Each cut goes in or out.
        const Piece &piece = result.pieces[i];
        result.inside.push_back(piece.from == 0 ? startsInside[std::size_t(piece.source)] : !result.inside[i - 1]);
    }
    return result;
}

std::vector<int> allSegments(const Stroke &stroke)
{
    std::vector<int> all(stroke.segments.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

/// The stroke that some of the pieces make. A new chain begins behind a gap, and before each piece i with `cuts(i)`.
template <typename Keeps, typename Cuts>
Stroke chainsOfPieces(const Stroke &stroke, std::vector<Piece> &pieces, Keeps keeps, Cuts cuts,
                      std::vector<int> *sources)
{
    Stroke result = stroke;
    result.segments.clear();
    if (sources)
        sources->clear();
    bool isGap = false;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!keeps(i)) {
            isGap = true;
            continue;
        }
        Segment &segment = pieces[i].segment;
        segment.start = !result.segments.empty() && (segment.start || isGap || cuts(i));
        result.segments.push_back(std::move(segment));
        isGap = false;
        if (sources)
            sources->push_back(pieces[i].source);
    }
    return result;
}

/// The places where a stroke is cut: parameters inside segments, and nodes, named by the segments that begin there.
struct Cuts {
    std::vector<CurvePlace> splits;
    std::set<int> nodes;

    Cuts(const Stroke &stroke, const std::vector<CurvePlace> &places)
    {
        for (const CurvePlace &place : places) {
            if (place.segment < 0 || place.segment >= int(stroke.segments.size()))
                continue;
            if (const int node = nodeAt(stroke, place); node >= 0)
                nodes.insert(node);
            else
                splits.push_back(place);
        }
    }
    bool isBefore(const Piece &piece) const { return piece.from > 0 || nodes.contains(piece.source); }
};

} // namespace

std::vector<Stroke> erased(const Stroke &stroke, const std::vector<Point> &path, double radius,
                           std::vector<int> *sources, Microseconds T)
{
    std::optional<ErasedPieces> left = erasedPieces(stroke, path, radius, T);
    if (sources)
        *sources = allSegments(stroke);
    if (!left)
        return {stroke};
    if (sources) {
        sources->clear();
        for (std::size_t i = 0; i < left->pieces.size(); ++i)
            if (!left->inside[i])
                sources->push_back(left->pieces[i].source);
    }
    return runsOf(
        stroke, left->pieces, [](std::size_t) { return false; }, [&](std::size_t i) { return !left->inside[i]; });
}

std::optional<Stroke> erasedInOne(const Stroke &stroke, const std::vector<Point> &path, double radius,
                                  std::vector<int> *sources, Microseconds T)
{
    if (stroke.fill && stroke.fill->born <= T)
        return filledErased(stroke, path, radius, sources);
    std::optional<ErasedPieces> left = erasedPieces(stroke, path, radius, T);
    if (sources)
        *sources = allSegments(stroke);
    if (!left)
        return stroke;
    if (stroke.fill) { // It comes later, within the outline that it always had.
        for (std::size_t i = 0; i < left->pieces.size(); ++i)
            if (left->inside[i])
                left->pieces[i].segment.density = 0;
        const auto no = [](std::size_t) { return false; };
        return chainsOfPieces(stroke, left->pieces, std::not_fn(no), no, sources);
    }
    Stroke result = chainsOfPieces(
        stroke, left->pieces, [&](std::size_t i) { return !left->inside[i]; }, [](std::size_t) { return false; },
        sources);
    return result.laysPaint() ? std::optional(std::move(result)) : std::nullopt;
}

std::optional<Stroke> withoutSegments(const Stroke &stroke, const std::vector<int> &gone, std::vector<int> *sources)
{
    if (stroke.fill)
        return filledWithout(stroke, gone, sources);
    const std::set<int> without(gone.begin(), gone.end());
    std::vector<Piece> pieces = piecesOf(stroke, std::vector<CurvePlace>());
    Stroke result = chainsOfPieces(
        stroke, pieces, [&](std::size_t i) { return !without.contains(int(i)); }, [](std::size_t) { return false; },
        sources);
    return result.laysPaint() ? std::optional(std::move(result)) : std::nullopt;
}

std::optional<Stroke> withSegmentsOnly(const Stroke &stroke, const std::vector<int> &kept)
{
    const std::set<int> stays(kept.begin(), kept.end());
    std::vector<int> others;
    for (int k = 0; k < int(stroke.segments.size()); ++k)
        if (!stays.contains(k))
            others.push_back(k);
    if (others.empty() || !stroke.fill)
        return withoutSegments(stroke, others);
    Stroke unfilled = stroke; // The fill belongs to the stroke as a whole.
    unfilled.fill = {};
    std::optional<Stroke> part = withoutSegments(unfilled, others);
    if (part) {
        part->fill = stroke.fill;
        part = withoutFill(*part);
    }
    return part;
}

bool mayErase(const Stroke &stroke, const std::vector<Point> &path, double radius)
{
    Rect box;
    for (Point p : path)
        box.include(p - stroke.origin);
    box = box.grown(radius);
    if (stroke.fill && outlineBox(stroke).intersects(box))
        return radius > 0;
    return radius > 0 && std::any_of(stroke.segments.begin(), stroke.segments.end(),
                                     [&box](const Segment &s) { return offsetsOf(s).controlBox().intersects(box); });
}

std::vector<CurvePlace> crossings(const Stroke &stroke, Point a, Point b)
{
    const Point along = b - a;
    const double l2 = dot(along, along);
    if (!(l2 > 0))
        return {};
    std::set<CurvePlace> places;
    const Point start = a - stroke.origin, direction = unit(along);
    for (int k = 0; k < int(stroke.segments.size()); ++k) {
        const Cubic curve = offsetsOf(stroke.segments[std::size_t(k)]);
        for (double p : bernsteinRoots(distanceFromLine(curve, start, {-direction.y, direction.x}))) {
            const double t = dot(curve.at(p) - start, along) / l2;
            if (t < 0 || t > 1)
                continue;
            const int node = nodeAt(stroke, {k, p});
            if (node < 0)
                places.insert({k, p});
            else if (isInnerNode(stroke, node))
                places.insert({node, 0});
        }
    }
    return {places.begin(), places.end()};
}

std::vector<Stroke> cutAt(const Stroke &stroke, const std::vector<CurvePlace> &places)
{
    const Cuts cuts(stroke, places);
    std::vector<Piece> pieces = piecesOf(stroke, cuts.splits);
    return runsOf(
        stroke, pieces, [&](std::size_t i) { return cuts.isBefore(pieces[i]); }, [](std::size_t) { return true; });
}

Stroke cutInOne(const Stroke &stroke, const std::vector<CurvePlace> &places, std::vector<int> *sources)
{
    if (stroke.fill)
        return filledCutAt(stroke, places, sources);
    const Cuts cuts(stroke, places);
    std::vector<Piece> pieces = piecesOf(stroke, cuts.splits);
    return chainsOfPieces(
        stroke, pieces, [](std::size_t) { return true; }, [&](std::size_t i) { return cuts.isBefore(pieces[i]); },
        sources);
}

} // namespace suffuse
