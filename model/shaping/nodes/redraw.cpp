#include "model/shaping/nodes/redraw.h"

#include "model/brush/stroke_fit.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/curve_fit.h"
#include "model/shaping/curves/runs.h"
#include "model/shaping/curves/split.h"

namespace suffuse {

namespace {

constexpr int pointsEach = 8;    ///< points of a segment's curve
constexpr double blendReach = 2; ///< How far a line bends at a joint, as a multiple of `reach`.
/// The tolerance of the curve that follows the line, as a share of `reach`.
constexpr double toleranceInReach = 1.0 / 40;
/// As a share of `reach`: places that are nearer to each other are one place.
constexpr double shortestPart = 1e-3;

struct Nearest {
    CurvePlace place;
    double distance = std::numeric_limits<double>::infinity();
};

/// The nearest place in some segments, among those that lay paint.
Nearest nearestIn(const Stroke &stroke, const Chain &within, Point point)
{
    Nearest best;
    for (int k = within.first; k <= within.last; ++k) {
        const Segment &segment = stroke.segments[std::size_t(k)];
        const Rect box = stroke.cubicOf(segment).controlBox().grown(best.distance);
        if (segment.takesPaint() || !box.contains(point))
            continue;
        Stroke one;
        one.origin = stroke.origin;
        one.segments = {segment};
        double distance = 0;
        const CurvePlace place = nearestPlace(one, point, &distance);
        if (distance < best.distance)
            best = {{k, place.p}, distance};
    }
    return best;
}

Point directionAt(const Stroke &stroke, const CurvePlace &place)
{
    const Cubic curve = offsetsOf(stroke.segments[std::size_t(place.segment)]);
    const Point d = unit(curve.derivative(place.p));
    return d != Point() ? d : place.p < 0.5 ? startDirection(curve) : endDirection(curve);
}

Point pointAt(const Stroke &stroke, const CurvePlace &place)
{
    return stroke.cubicOf(stroke.segments[std::size_t(place.segment)]).at(place.p);
}

/// The direction from the start of the line to its first point that is so far away.
Point departure(const std::vector<Point> &line, double way)
{
    for (const Point &p : line)
        if (length(p - line.front()) >= way)
            return unit(p - line.front());
    return unit(line.back() - line.front());
}

/// Bends the beginning of a line so that it starts at a point in a direction. If it would have to turn back, it is only
/// moved there. Returns the direction in which it starts; 0 means the line's own.
Point blendStart(std::vector<Point> &line, Point start, Point direction, double within)
{
    const Point first = line.front();
    const bool turnsBack = dot(departure(line, within), direction) < 0;
    double way = 0;
    Point last = first;
    for (Point &p : line) {
        way += length(p - last);
        last = p;
        const double share = 1 - smoothStep(way / within);
        const Point wanted = turnsBack ? start + (p - first) : start + way * direction;
        p = share * wanted + (1 - share) * p;
    }
    return turnsBack ? Point() : direction;
}

double wayOf(const std::vector<Point> &line)
{
    double way = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
        way += length(line[i] - line[i - 1]);
    return way;
}

/// The values along a path, by shares of its arc length.
struct Dress {
    std::vector<Segment> segments;
    std::vector<double> ends; ///< the shares at which the values end
};

Dress dressOf(std::vector<Segment> segments)
{
    Dress dress{std::move(segments), {}};
    double way = 0;
    for (const Segment &s : dress.segments)
        dress.ends.push_back(way += arcLength(offsetsOf(s)));
    for (double &end : dress.ends)
        end = way > 0 ? end / way : 1;
    dress.ends.back() = 1;
    return dress;
}

/// The parameter of a cubic at a share of its arc length.
double parameterAt(const Cubic &cubic, double share)
{
    const double wanted = share * arcLength(cubic);
    double low = 0, high = 1;
    for (int i = 0; i < 30; ++i) {
        const double middle = 0.5 * (low + high);
        (arcLength(partOf(cubic, 0, middle)) < wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// Segments along curves, with the values that `dress` has at the same shares of the way.
std::vector<Segment> dressed(const std::vector<Cubic> &curves, const Dress &dress)
{
    std::vector<double> ends;
    double total = 0;
    for (const Cubic &c : curves)
        ends.push_back(total += arcLength(c));
    std::vector<Segment> result;
    const auto append = [&](const Cubic &part, std::size_t value) {
        Segment segment = dress.segments[value];
        segment.bezier = toOffsets(part);
        segment.node = NodeKind::Smooth;
        segment.start = false;
        if (!result.empty())
            segment.bezier[0] = result.back().bezier[3];
        result.push_back(std::move(segment));
    };
    std::size_t value = 0;
    double begin = 0;
    for (std::size_t k = 0; k < curves.size(); ++k) {
        const double own = ends[k] - begin;
        std::vector<double> cuts;
        std::vector<std::size_t> values{value};
        while (value + 1 < dress.segments.size() && dress.ends[value] * total < ends[k]) {
            const double p = own > 0 ? parameterAt(curves[k], (dress.ends[value] * total - begin) / own) : 1;
            ++value;
            if (const double last = cuts.empty() ? 0 : cuts.back();
                distinct({p - last}, partOf(curves[k], last, 1)).empty() || !(p > last && p < 1)) {
                values.back() = value; // The piece is too short to be a segment of its own.
                continue;
            }
            cuts.push_back(p);
            values.push_back(value);
        }
        double from = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double to = i < cuts.size() ? cuts[i] : 1;
            append(partOf(curves[k], from, to), values[i]);
            from = to;
        }
        begin = ends[k];
    }
    return result;
}

/// Sets the kind of a node after a part has been put in: it is a corner where the direction breaks.
void setKindAt(Stroke &stroke, std::size_t node)
{
    if (!isInnerNode(stroke, int(node)))
        return;
    const Point in = endDirection(offsetsOf(stroke.segments[node - 1]));
    const Point out = startDirection(offsetsOf(stroke.segments[node]));
    stroke.segments[node].node = dot(in, out) < smoothCosine ? NodeKind::Corner : NodeKind::Smooth;
}

} // namespace

std::vector<Point> pointsAlong(const Stroke &stroke)
{
    std::vector<Point> points;
    for (const Segment &segment : stroke.segments) {
        const Cubic curve = stroke.cubicOf(segment);
        if (points.empty())
            points.push_back(curve.p[0]);
        for (int i = 1; i <= pointsEach; ++i)
            if (const Point p = curve.at(double(i) / pointsEach); p != points.back())
                points.push_back(p);
    }
    return points;
}

std::optional<RedrawnPart> partToRedraw(const Stroke &stroke, const std::vector<Point> &line, double reach)
{
    if (line.size() < 2 || stroke.segments.empty())
        return std::nullopt;
    const Chain all{0, int(stroke.segments.size()) - 1};
    const Nearest start = nearestIn(stroke, all, line.front());
    const bool hasStart = start.distance <= reach;
    const Nearest end = hasStart ? nearestIn(stroke, chainAt(stroke, start.place.segment), line.back())
                                 : nearestIn(stroke, all, line.back());
    const bool hasEnd = end.distance <= reach;
    if (hasStart && hasEnd) {
        const bool reversed = end.place < start.place;
        const RedrawnPart part{reversed ? end.place : start.place, reversed ? start.place : end.place, reversed};
        if (length(pointAt(stroke, part.from) - pointAt(stroke, part.to)) > shortestPart * reach)
            return part;
        return std::nullopt;
    }
    if (!hasStart && !hasEnd)
        return std::nullopt;
    // This tells towards which end of the chain the line goes or, where it joins behind, from which it comes.
    const CurvePlace place = hasStart ? start.place : end.place;
    std::vector<Point> away = line;
    if (!hasStart)
        std::reverse(away.begin(), away.end());
    const bool onwards = dot(departure(away, reach), directionAt(stroke, place)) >= 0;
    const Chain chain = chainAt(stroke, place.segment);
    RedrawnPart part;
    part.from = onwards ? place : CurvePlace{chain.first, 0};
    part.to = onwards ? CurvePlace{chain.last, 1} : place;
    part.reversed = onwards != hasStart;
    (onwards ? part.joinsEnd : part.joinsStart) = false;
    return part;
}

std::optional<Stroke> redrawn(const Stroke &stroke, const RedrawnPart &part, const Stroke &line, double reach,
                              RedrawValues values, std::vector<int> *sources)
{
    std::vector<Point> points = pointsAlong(line);
    if (points.size() < 2)
        return std::nullopt;
    for (Point &p : points)
        p = p - stroke.origin;
    if (part.reversed)
        std::reverse(points.begin(), points.end());

    // The stroke is divided into what is before, within and behind the part.
    const std::vector<Piece> pieces = piecesOf(stroke, std::vector<CurvePlace>{part.from, part.to});
    std::vector<Segment> before, within, behind;
    std::vector<int> sourcesBefore, sourcesBehind;
    for (const Piece &piece : pieces) {
        const CurvePlace middle{piece.source, 0.5 * (piece.from + piece.to)};
        if (middle < part.from) {
            before.push_back(piece.segment);
            sourcesBefore.push_back(piece.source);
        } else if (middle < part.to) {
            within.push_back(piece.segment);
        } else {
            behind.push_back(piece.segment);
            sourcesBehind.push_back(piece.source);
        }
    }
    if (within.empty())
        return std::nullopt;
    const bool begins = before.empty() || within.front().start;
    const bool ends = behind.empty() || behind.front().start;

    // The line is bent into the stroke where it joins it.
    const double reachOfBlend = std::min(blendReach * reach, wayOf(points) / 3);
    Point leaving, arriving;
    if (part.joinsStart && !begins)
        leaving = blendStart(points, Point() + within.front().bezier[0], directionAt(stroke, part.from), reachOfBlend);
    if (part.joinsEnd && !ends) {
        std::reverse(points.begin(), points.end());
        arriving = -1.0 * blendStart(points, Point() + within.back().bezier[3], -1.0 * directionAt(stroke, part.to),
                                     reachOfBlend);
        std::reverse(points.begin(), points.end());
    }
    const std::vector<Cubic> curves = cubicsThrough(points, leaving, arriving, toleranceInReach * reach);
    std::vector<Segment> own = within;
    if (values == RedrawValues::Line) {
        own = line.segments;
        if (part.reversed)
            std::reverse(own.begin(), own.end());
        for (Segment &s : own)
            if (!s.style && line.style != stroke.style)
                s.style = line.style;
    }
    std::vector<Segment> put = dressed(curves, dressOf(std::move(own)));
    put.front().start = within.front().start;
    if (!begins)
        put.front().bezier[0] = before.back().bezier[3];
    if (!ends)
        put.back().bezier[3] = behind.front().bezier[0];
    if (std::any_of(put.begin(), put.end(), isPoint))
        return std::nullopt;

    Stroke result = stroke;
    result.segments = std::move(before);
    const std::size_t first = result.segments.size(), behindAt = first + put.size();
    std::vector<int> from = std::move(sourcesBefore);
    from.resize(behindAt, -1);
    from.insert(from.end(), sourcesBehind.begin(), sourcesBehind.end());
    result.segments.insert(result.segments.end(), put.begin(), put.end());
    result.segments.insert(result.segments.end(), behind.begin(), behind.end());
    setKindAt(result, first);
    setKindAt(result, behindAt);
    if (!problemOf(result).isEmpty())
        return std::nullopt;
    if (sources)
        *sources = std::move(from);
    return result;
}

} // namespace suffuse
