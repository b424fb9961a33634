#include "model/shaping/area_strokes.h"

#include "model/area/outline.h"
#include "model/painting/validate.h"
#include "model/shaping/bound_values.h"
#include "model/shaping/curves/chains.h"
#include "model/shaping/curves/curve_fit.h"
#include "model/shaping/curves/split.h"

#include <numbers>

namespace suffuse {

namespace {

using Loop = std::vector<Cubic>;

/// The steps of float32 numbers at these distances from 0, a few of them.
double resolutionOf(const Rect &box)
{
    const double farthest =
        std::max({std::abs(box.left), std::abs(box.right), std::abs(box.top), std::abs(box.bottom)});
    return 4 * double(std::numeric_limits<float>::epsilon()) * farthest;
}

/// Makes coordinates of nodes one that are nearer to each other than `near`. Handles move along with their nodes.
void weld(std::vector<std::vector<Loop>> &outlines, double Point::*coordinate, double near)
{
    std::vector<double> places;
    const auto forEach = [&outlines](auto use) {
        for (std::vector<Loop> &loops : outlines)
            for (Loop &loop : loops)
                for (Cubic &curve : loop)
                    use(curve);
    };
    forEach([&](const Cubic &curve) { places.push_back(curve.p[0].*coordinate); });
    std::sort(places.begin(), places.end());
    std::vector<double> kept;
    for (const double place : places)
        if (kept.empty() || place - kept.back() > near)
            kept.push_back(place);
    forEach([&](Cubic &curve) {
        for (const std::size_t node : {std::size_t(0), std::size_t(3)}) {
            double &place = curve.p[node].*coordinate;
            const double by = *std::prev(std::upper_bound(kept.begin(), kept.end(), place)) - place;
            place += by;
            curve.p[node == 0 ? 1 : 2].*coordinate += by;
        }
    });
}

/// The curve of which two are parts that follow each other.
std::optional<Cubic> wholeOf(const Cubic &a, const Cubic &b)
{
    // At a node between parts of one cubic the lengths of the handles are in proportion to the parts of the parameter.
    const double before = length(a.p[3] - a.p[2]), after = length(b.p[1] - b.p[0]);
    const double share = before / (before + after);
    if (!(share > 1e-3 && share < 1 - 1e-3))
        return std::nullopt;
    const Cubic whole{
        {a.p[0], a.p[0] + (1 / share) * (a.p[1] - a.p[0]), b.p[3] + (1 / (1 - share)) * (b.p[2] - b.p[3]), b.p[3]}};
    const auto parts = whole.split(share);
    const double near = 1e-7 * (polygonLength(a) + polygonLength(b));
    for (std::size_t i = 0; i < 4; ++i)
        if (!(length(parts[0].p[i] - a.p[i]) <= near && length(parts[1].p[i] - b.p[i]) <= near))
            return std::nullopt;
    return whole;
}

/// A piece of an outline with its values.
struct OutlinePiece {
    Cubic curve;
    BoundValues::Found values;
};

/// The loop without nodes at which nothing happens: curves were divided where they turn up or down.
std::vector<OutlinePiece> withoutSplits(const Loop &loop, const BoundValues &values)
{
    // What lies where no segment lay before, as a moved outline does, is divided nowhere on account of values.
    const auto joined = [](const OutlinePiece &a, const OutlinePiece &b) {
        const bool isOne = a.values.isThere || b.values.isThere ? a.values.number == b.values.number : true;
        return isOne ? wholeOf(a.curve, b.curve) : std::nullopt;
    };
    std::vector<OutlinePiece> result;
    for (const Cubic &curve : loop) {
        const OutlinePiece piece{curve, values.valuesAt(curve)};
        const std::optional<Cubic> whole = result.empty() ? std::nullopt : joined(result.back(), piece);
        if (whole)
            result.back().curve = *whole;
        else
            result.push_back(piece);
    }
    if (result.size() > 2)
        if (const std::optional<Cubic> whole = joined(result.back(), result.front())) {
            result.front().curve = *whole;
            result.pop_back();
        }
    for (OutlinePiece &piece : result)
        if (!piece.values.isThere)
            piece.values = values.valuesAt(piece.curve);
    return result;
}

/// Whether a loop encloses as much as float32 can tell.
bool isSeen(const Loop &loop, double resolution)
{
    double around = 0;
    for (const Cubic &curve : loop)
        around += polygonLength(curve);
    return sizeOf(Area{{loop}}) > resolution * around;
}

/// The segments of a closed chain.
std::vector<Segment> segmentsOf(const std::vector<OutlinePiece> &loop, const BoundValues &values)
{
    std::vector<Segment> segments;
    const auto isSmooth = [](const Cubic &before, const Cubic &after) {
        return dot(endDirection(before), startDirection(after)) > 1 - 1e-6;
    };
    const Cubic *before = &loop.back().curve;
    for (const OutlinePiece &piece : loop) {
        Segment segment = values.values(piece.values.number);
        segment.bezier = toOffsets(piece.curve);
        if (!segments.empty())
            segment.bezier[0] = segments.back().bezier[3];
        if (isPoint(segment))
            continue;
        segment.node = isSmooth(*before, piece.curve) ? NodeKind::Smooth : NodeKind::Corner;
        before = &piece.curve;
        segments.push_back(std::move(segment));
    }
    if (!segments.empty())
        segments.back().bezier[3] = segments.front().bezier[0];
    return segments;
}

// Where outlines lie on each other within rounding, what is right of what may be decided wrongly, depending on how they
// lie to the level lines on which that is decided. So results are checked, and outlines are turned until one is right.
constexpr double turns[] = {0, 0.7, 1.9, 2.6};
constexpr double leastCertain = 1e-7; ///< of the box: sizes that differ by less are equal

Area turned(Area area, double angle)
{
    if (angle == 0)
        return area;
    const double c = std::cos(angle), s = std::sin(angle);
    for (Loop &loop : area.loops)
        for (Cubic &curve : loop)
            for (Point &p : curve.p)
                p = {c * p.x - s * p.y, s * p.x + c * p.y};
    return area;
}

bool isClosed(const Area &area)
{
    for (const Loop &loop : area.loops)
        for (std::size_t k = 0; k < loop.size(); ++k)
            if (loop[k].p[3] != loop[(k + 1) % loop.size()].p[0])
                return false;
    return true;
}

double boxSize(const Area &a, const Area &b)
{
    const Rect box = a.box().united(b.box());
    return box.width() * box.height();
}

/// The set of two areas, and what is left of the first one by a division.
struct SetOfTwo {
    Area set;
    Area rest;
};

SetOfTwo computed(const Area &a, const Area &b, AreaSet how, AreaEffort *effort)
{
    switch (how) {
    case AreaSet::Union:
        return {united(a, b, effort), {}};
    case AreaSet::Difference:
        return {difference(a, b, effort), {}};
    case AreaSet::Intersection:
        return {intersection(a, b, effort), {}};
    case AreaSet::Exclusion:
        return {exclusion(a, b, effort), {}};
    case AreaSet::Division:
        break;
    }
    return {intersection(a, b, effort), difference(a, b, effort)};
}

/// How much larger the set is than the sizes of the areas and of what they have in common say.
double excess(const SetOfTwo &of, const Area &a, const Area &b, AreaSet how, AreaEffort *effort)
{
    const double first = sizeOf(a), second = sizeOf(b), size = sizeOf(of.set);
    if (how == AreaSet::Intersection)
        return size + sizeOf(difference(a, b, effort)) - first;
    if (how == AreaSet::Division)
        return size + sizeOf(of.rest) - first;
    const double both = sizeOf(intersection(a, b, effort));
    if (how == AreaSet::Difference)
        return size + both - first;
    return size + (how == AreaSet::Union ? both : 2 * both) - first - second;
}

std::optional<SetOfTwo> certainSet(const Area &a, const Area &b, AreaSet how, AreaEffort *effort)
{
    for (const double angle : turns) {
        const Area first = turned(a, angle), second = turned(b, angle);
        SetOfTwo of = computed(first, second, how, effort);
        if (!isClosed(of.set) || !isClosed(of.rest) ||
            std::abs(excess(of, first, second, how, effort)) > leastCertain * boxSize(first, second))
            continue;
        return SetOfTwo{turned(std::move(of.set), -angle), turned(std::move(of.rest), -angle)};
    }
    return std::nullopt;
}

} // namespace

std::optional<Area> certainArea(const std::vector<Loop> &outline, FillRule rule, AreaEffort *effort)
{
    std::vector<std::pair<Area, double>> found;
    for (const double angle : turns) {
        Area area = areaOf(turned({outline}, angle).loops, rule, effort);
        if (!isClosed(area))
            continue;
        const double size = sizeOf(area);
        for (auto &[other, otherSize] : found)
            if (std::abs(size - otherSize) <= leastCertain * boxSize({outline}, {}))
                return std::move(other);
        found.emplace_back(turned(std::move(area), -angle), size);
    }
    return std::nullopt;
}

std::optional<std::vector<Area>> areasOf(const std::vector<StrokePtr> &strokes, AreaEffort *effort)
{
    std::vector<std::vector<Loop>> outlines;
    Rect box;
    for (const StrokePtr &stroke : strokes) {
        outlines.push_back(closedOutline(*stroke));
        const Point shift = stroke->origin - strokes.front()->origin;
        for (Loop &loop : outlines.back())
            for (Cubic &curve : loop) {
                for (Point &p : curve.p)
                    p = p + shift;
                box = box.united(curve.controlBox());
            }
    }
    const double near = resolutionOf(box);
    weld(outlines, &Point::x, near);
    weld(outlines, &Point::y, near);
    std::vector<Area> areas;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        std::optional<Area> area = certainArea(outlines[i], strokes[i]->fill->rule, effort);
        if (!area)
            return std::nullopt;
        areas.push_back(std::move(*area));
    }
    return areas;
}

std::optional<std::vector<Area>> setOf(const std::vector<Area> &areas, AreaSet how, AreaEffort *effort)
{
    std::vector<Area> result{areas.front()};
    for (auto next = areas.begin() + 1; next != areas.end(); ++next) {
        std::vector<Area> parts;
        for (const Area &part : result) {
            std::optional<SetOfTwo> of = certainSet(part, *next, how, effort);
            if (!of || (effort && effort->isSpent()))
                return std::nullopt;
            parts.push_back(std::move(of->set));
            parts.push_back(std::move(of->rest));
        }
        result = std::move(parts);
        // Of a union something may come later to what is empty.
        if (how == AreaSet::Division)
            std::erase_if(result, [](const Area &area) { return area.isEmpty(); });
        else
            result.resize(1);
    }
    std::erase_if(result, [](const Area &area) { return area.isEmpty(); });
    return result;
}

Area drawnAnew(const Area &area, double step, double tolerance)
{
    constexpr double mostSteps = 100'000, sharp = 0.3 * std::numbers::pi;
    constexpr std::size_t arm = 5;
    Area result;
    for (const Loop &loop : area.loops) {
        double around = 0;
        for (const Cubic &curve : loop)
            around += polygonLength(curve);
        if (!(around < mostSteps * step)) {
            result.loops.push_back(loop);
            continue;
        }
        std::vector<Point> way;
        double next = 0, gone = 0; // along the outline
        for (const Cubic &curve : loop) {
            const int pieces = 1 + int(4 * polygonLength(curve) / step);
            for (int i = 0; i < pieces; ++i) {
                const Point a = curve.at(double(i) / pieces), b = curve.at(double(i + 1) / pieces);
                const double length = suffuse::length(b - a);
                for (; next < gone + length; next += step)
                    way.push_back(a + ((next - gone) / length) * (b - a));
                gone += length;
            }
        }
        std::vector<std::size_t> corners = cornersOfWay(way, arm, sharp);
        if (corners.empty())
            corners.push_back(0);
        Loop anew;
        for (std::size_t c = 0; c < corners.size() && way.size() > 2 * arm; ++c) {
            const std::size_t to = c + 1 < corners.size() ? corners[c + 1] : corners[0] + way.size();
            std::vector<Point> points;
            for (std::size_t i = corners[c]; i <= to; ++i)
                points.push_back(way[i % way.size()]);
            for (const Cubic &curve : cubicsThrough(points, {}, {}, tolerance))
                anew.push_back(curve);
        }
        result.loops.push_back(anew.empty() ? loop : std::move(anew));
    }
    return result;
}

std::optional<Stroke> withArea(const Stroke &stroke, const Area &area, const std::vector<StrokePtr> &others)
{
    Stroke result = stroke;
    result.segments.clear();
    const BoundValues values(stroke, others);
    if (values.isEmpty())
        return std::nullopt;
    const double resolution = resolutionOf(area.box());
    for (const Loop &loop : area.loops)
        if (isSeen(loop, resolution))
            appendChain(result, segmentsOf(withoutSplits(loop, values), values));
    if (result.segments.empty())
        return std::nullopt;
    appendLifts(result, stroke);
    return problemOf(result).isEmpty() ? std::optional(std::move(result)) : std::nullopt;
}

bool appendLifts(Stroke &stroke, const Stroke &other)
{
    Stroke result = stroke;
    const Point shift = other.origin - stroke.origin;
    for (const Chain &chain : chainsOf(other)) {
        if (!other.segments[std::size_t(chain.first)].takesPaint())
            continue;
        std::vector<Segment> segments = chainOnly(other, chain).segments;
        for (Segment &segment : segments)
            for (Offset &o : segment.bezier)
                o = toOffset(shift + o, {});
        appendChain(result, std::move(segments));
    }
    if (!problemOf(result).isEmpty())
        return false;
    stroke = std::move(result);
    return true;
}

} // namespace suffuse
