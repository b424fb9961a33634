#include "model/shaping/nodes/bending.h"

#include "model/painting/validate.h"
#include "model/shaping/curves/curve_fit.h"
#include "model/shaping/curves/split.h"
#include "model/shaping/nodes/reshape.h"

namespace suffuse {

namespace {

constexpr double mostTurn = 0.5;  ///< A segment that turns by more radians than these is split before it is offset.
constexpr int mostParts = 64;     ///< No segment is split into more parts than these.
constexpr double mostMitre = 4;   ///< The length of a mitre is at most this times the distance of the offset.
constexpr double joinRamp = 3;    ///< The offset grows from the ends of a run within this times its distance.
constexpr int offsetSamples = 12; ///< the number of points of a segment to which its offset is fitted

bool hasPoints(const Stroke &after)
{
    return std::any_of(after.segments.begin(), after.segments.end(), isPoint);
}

Point normalOf(Point direction)
{
    return {-direction.y, direction.x};
}

/// The sum of the angles between the sides of a curve's control polygon. The curve turns by no more.
double turnOf(const Cubic &curve)
{
    double turn = 0;
    Point last = startDirection(curve);
    for (std::size_t i = 1; i < 4; ++i) {
        const Point side = unit(curve.p[i] - curve.p[i - 1]);
        if (side == Point())
            continue;
        turn += std::abs(std::atan2(cross(last, side), dot(last, side)));
        last = side;
    }
    return turn;
}

/// The offset of a run, node by node and curve by curve.
class Offsetting {
public:
    Offsetting(const RunPath &path, double distance) : m_path(path), m_distance(distance)
    {
        const bool both = path.joinsBefore && path.joinsAfter;
        m_ramp = std::min(joinRamp * std::abs(distance), (both ? 0.5 : 1) * path.total());
    }

    std::vector<Cubic> run() const
    {
        std::vector<Cubic> result;
        for (std::size_t k = 0; k < m_path.curves.size(); ++k)
            result.push_back(offset(k));
        for (std::size_t k = 1; k < result.size(); ++k)
            meet(k, result[k - 1], result[k]);
        return result;
    }

private:
    double distanceAt(double way) const
    {
        double share = 1;
        if (m_path.joinsBefore)
            share *= smoothStep(way / m_ramp);
        if (m_path.joinsAfter)
            share *= smoothStep((m_path.total() - way) / m_ramp);
        return share * m_distance;
    }

    Cubic offset(std::size_t k) const
    {
        const Cubic &curve = m_path.curves[k];
        const double start = m_path.lengths[k], way = m_path.lengths[k + 1] - start;
        Point last = startDirection(curve);
        const auto at = [&](double t) {
            const Point d = unit(curve.derivative(t));
            last = d == Point() ? (t < 0.5 ? startDirection(curve) : endDirection(curve)) : d;
            return curve.at(t) + distanceAt(start + t * way) * normalOf(last);
        };
        std::vector<Point> between;
        for (int i = 1; i < offsetSamples; ++i)
            between.push_back(at(double(i) / offsetSamples));
        const Point from = at(0), to = at(1);
        // Directions lie along the curve or, inside of its centre of curvature, against it. On a ramp its slope is
        // added.
        const auto directionAt = [&](Point tangent, Point step, double place) {
            const double h = 1e-3 * std::max(m_ramp, 1e-12);
            const double slope = m_ramp > 0 ? (distanceAt(place + h) - distanceAt(place - h)) / (2 * h) : 0;
            return unit((dot(step, tangent) < 0 ? -1.0 : 1.0) * tangent + slope * normalOf(tangent));
        };
        const Point direction = directionAt(startDirection(curve), between.front() - from, start);
        const Point arrival = directionAt(endDirection(curve), to - between.back(), start + way);
        CurveFit fit(from, std::move(between), to);
        return fittedCubic(fit, direction, arrival, 4);
    }

    /// Brings the ends of two offset curves together. They meet already, or are mitred at a corner.
    void meet(std::size_t k, Cubic &before, Cubic &after) const
    {
        const Point in = normalOf(endDirection(m_path.curves[k - 1])), out = normalOf(startDirection(m_path.curves[k]));
        const Point node = m_path.curves[k].p[0];
        Point place = 0.5 * (before.p[3] + after.p[0]);
        if (dot(in, out) < smoothCosine) {
            const Point middle = in + out;
            const double mitre = std::min(mostMitre, 2 / std::max(1e-9, dot(middle, middle)));
            place = node + (distanceAt(m_path.lengths[k]) * mitre) * middle;
        }
        const Point byBefore = place - before.p[3], byAfter = place - after.p[0];
        before.p[2] = before.p[2] + byBefore;
        after.p[1] = after.p[1] + byAfter;
        before.p[3] = after.p[0] = place;
    }

    const RunPath &m_path;
    double m_distance;
    double m_ramp;
};

} // namespace

Stroke straightened(const Stroke &stroke, double share, const std::vector<bool> &chosen)
{
    share = std::clamp(share, 0.0, 1.0);
    Stroke result = stroke;
    for (const Chain &run : smoothRunsOf(stroke, chosen)) {
        const RunPath path(stroke, run);
        const Point start = path.curves.front().p[0], chord = path.curves.back().p[3] - start;
        if (!(path.total() > 0) || chord == Point())
            continue;                                   // A closed curve has no chord.
        const Point along = (1 / path.total()) * chord; // the way on the chord for each unit of the arc
        std::vector<Cubic> curves = path.curves;
        for (std::size_t k = 0; k < curves.size(); ++k) {
            Cubic &c = curves[k];
            const auto onChord = [&](std::size_t node) { return start + path.lengths[node] * along; };
            const Point from = c.p[0], to = c.p[3];
            const Point leaving = c.p[1] - from, arriving = to - c.p[2];
            c.p[0] = from + share * (onChord(k) - from);
            c.p[3] = to + share * (onChord(k + 1) - to);
            c.p[1] = c.p[0] + leaving + share * (length(leaving) * along - leaving);
            c.p[2] = c.p[3] - arriving - share * (length(arriving) * along - arriving);
        }
        writeCurves(result, run.first, curves);
        result.segments[std::size_t(run.first)].bezier[0] = stroke.segments[std::size_t(run.first)].bezier[0];
        result.segments[std::size_t(run.last)].bezier[3] = stroke.segments[std::size_t(run.last)].bezier[3];
        // The neighbours keep their direction, so there is a corner now.
        for (const int node : {run.first, run.last + 1})
            if (share > 0 && isInnerNode(stroke, node))
                result.segments[std::size_t(node)].node = NodeKind::Corner;
    }
    return hasPoints(result) && !hasPoints(stroke) ? stroke : validOr(std::move(result), stroke);
}

Stroke offsetAside(const Stroke &stroke, double distance, const std::vector<bool> &chosen, std::vector<int> *sources)
{
    std::vector<CurvePlace> places;
    for (std::size_t k = 0; distance != 0 && k < stroke.segments.size(); ++k)
        if (chosen.empty() || chosen[k]) {
            const int parts =
                int(std::clamp(std::ceil(turnOf(offsetsOf(stroke.segments[k])) / mostTurn), 1.0, double(mostParts)));
            for (int i = 1; i < parts; ++i)
                places.push_back({int(k), double(i) / parts});
        }
    std::vector<int> from;
    Stroke result = withNodes(stroke, places, &from);
    std::vector<bool> meant(from.size());
    for (std::size_t k = 0; k < from.size(); ++k)
        meant[k] = chosen.empty() || chosen[std::size_t(from[k])];
    const Stroke split = result;
    for (const Chain &run : runsOf(split, meant)) {
        const RunPath path(split, run);
        if (distance == 0 || !(path.total() > 0))
            continue;
        writeCurves(result, run.first, Offsetting(path, distance).run());
        if (path.joinsBefore)
            result.segments[std::size_t(run.first)].bezier[0] = split.segments[std::size_t(run.first)].bezier[0];
        if (path.joinsAfter)
            result.segments[std::size_t(run.last)].bezier[3] = split.segments[std::size_t(run.last)].bezier[3];
    }
    if ((hasPoints(result) && !hasPoints(stroke)) || !problemOf(result).isEmpty()) {
        from.resize(stroke.segments.size());
        for (std::size_t k = 0; k < from.size(); ++k)
            from[k] = int(k);
        result = stroke;
    }
    if (sources)
        *sources = std::move(from);
    return result;
}

} // namespace suffuse
