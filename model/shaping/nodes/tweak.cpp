#include "model/shaping/nodes/tweak.h"

#include "model/painting/validate.h"
#include "model/shaping/curves/runs.h"
#include "model/shaping/curves/split.h"

#include <cstdint>
#include <numbers>

namespace suffuse {

namespace {

constexpr double longestPart = 0.4;   ///< As a share of the radius: the longest segment that follows a push.
constexpr double longestRough = 0.15; ///< As a share of the radius: the longest segment that can be roughened.
constexpr double roughCell = 0.3;     ///< As a share of the radius: how far the noise pushes in one direction.
constexpr double slopeStep = 1e-3;    ///< As a share of the radius: the step by which the slope of a field is measured.

double squaredDistanceTo(const Rect &box, Point p)
{
    const double x = std::max({box.left - p.x, p.x - box.right, 0.0});
    const double y = std::max({box.top - p.y, p.y - box.bottom, 0.0});
    return x * x + y * y;
}

/// A pseudo-random number in [−1, 1] for a cell of the plane.
double noiseOf(std::int64_t x, std::int64_t y, std::uint64_t seed)
{
    std::uint64_t h = std::uint64_t(x) * 0x9e3779b97f4a7c15u ^ std::uint64_t(y) * 0xc2b2ae3d27d4eb4fu ^ seed;
    for (int round = 0; round < 2; ++round) { // the last part of splitmix64
        h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
        h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
        h ^= h >> 31;
    }
    return double(h >> 11) * 0x1p-52 - 1;
}

/// How the plane moves under the brush. Places are relative to the middle of the brush.
class TouchField {
public:
    explicit TouchField(const Tweak &tweak) : m_tweak(tweak) {}

    double weight(Point p) const
    {
        const double rest = 1 - dot(p, p) / (m_tweak.radius * m_tweak.radius);
        return rest > 0 ? rest * rest : 0;
    }

    Point move(Point p) const
    {
        const double w = weight(p);
        if (w == 0)
            return {};
        switch (m_tweak.kind) {
        case TweakKind::Push:
            return w * m_tweak.by;
        case TweakKind::Pinch:
            return (-m_tweak.share * w) * p;
        case TweakKind::Roughen:
            return (w * m_tweak.share * m_tweak.radius) * noise(p + m_tweak.centre);
        case TweakKind::Comb:
            break;
        }
        return {};
    }

    /// The vector at p after the move, as far as the field is linear there. Opposite vectors stay opposite.
    Point turned(Point p, Point vector) const
    {
        const double l = length(vector);
        if (l == 0)
            return vector;
        const double h = slopeStep * m_tweak.radius;
        const Point step = (h / l) * vector;
        return vector + (l / (2 * h)) * (move(p + step) - move(p - step));
    }

private:
    Point noise(Point p) const
    {
        const double cell = roughCell * m_tweak.radius;
        const double x = std::floor(p.x / cell), y = std::floor(p.y / cell);
        const double u = smoothStep(p.x / cell - x), v = smoothStep(p.y / cell - y);
        const auto at = [&](int i, int j) {
            const auto column = std::int64_t(x) + i, row = std::int64_t(y) + j;
            const std::uint64_t seed = std::uint64_t(m_tweak.seed) << 1;
            return Point{noiseOf(column, row, seed), noiseOf(column, row, seed | 1)};
        };
        return (1 - v) * ((1 - u) * at(0, 0) + u * at(1, 0)) + v * ((1 - u) * at(0, 1) + u * at(1, 1));
    }

    const Tweak &m_tweak;
};

/// Halves the parts of a curve under the circle until they are short enough.
void addCuts(const Cubic &curve, double from, double to, Point centre, double radius, double longest,
             std::vector<double> &cuts)
{
    const Cubic part = partOf(curve, from, to);
    const bool isFar = squaredDistanceTo(part.controlBox(), centre) >= radius * radius;
    if (isFar || polygonLength(part) <= longest || to - from < 1e-4)
        return;
    const double middle = 0.5 * (from + to);
    addCuts(curve, from, middle, centre, radius, longest, cuts);
    cuts.push_back(middle);
    addCuts(curve, middle, to, centre, radius, longest, cuts);
}

/// Turns the segments of a run, and makes a chain of them again. Its ends stay in their places where they lie outside
/// of the circle.
class Combing {
public:
    Combing(RunPath &path, const Tweak &tweak, Point centre) : m_path(path), m_tweak(tweak), m_field(tweak)
    {
        for (std::size_t node = 0; node <= path.curves.size(); ++node) {
            const Point place = placeOf(node) - centre;
            const double weight = m_field.weight(place);
            m_weights.push_back(weight);
            // A run that is held at both ends gives way on both sides of the middle. If it gave way where it turns, it
            // would turn back.
            m_closing.push_back(weight * (1 - std::sqrt(weight)));
        }
        m_startIsFree = !path.joinsBefore && m_weights.front() > 0;
        m_endIsFree = !path.joinsAfter && m_weights.back() > 0;
        const double sense = senseOfRun();
        double angle = 0;
        for (std::size_t node = 0; node <= path.curves.size(); ++node) {
            const Point t = sense * directionAt(node);
            const double here = std::atan2(cross(t, tweak.by), dot(t, tweak.by));
            angle = node == 0 ? here : angle + std::remainder(here - angle, 2 * std::numbers::pi);
            m_turns.push_back(tweak.share * m_weights[node] * angle);
        }
    }

    void run()
    {
        std::vector<Point> moves = movesOfNodes();
        std::vector<double> shares = sharesOfWay();
        const Point gap = moves.back();
        double weights = 0;
        Point mean;
        for (std::size_t k = 0; k < moves.size(); ++k) {
            mean = mean + m_weights[k] * moves[k];
            weights += m_weights[k];
        }
        const bool closes = !m_startIsFree && !m_endIsFree;
        const Point shift = m_startIsFree && m_endIsFree ? (1 / weights) * mean : m_startIsFree ? gap : Point();
        for (std::size_t k = 0; k < moves.size(); ++k)
            moves[k] = moves[k] - shift - (closes ? shares[k] : 0.0) * gap;
        const double total = m_weighedWay;
        for (std::size_t k = 0; k < m_path.curves.size(); ++k) {
            Cubic &c = m_path.curves[k];
            const auto handle = [&](Point vector, std::size_t node, double sense) {
                const Point closing = closes && total > 0 ? (m_closing[node] / total) * gap : Point();
                return rotated(vector, m_turns[node]) - (sense * length(vector)) * closing;
            };
            const Point leaving = handle(c.p[1] - c.p[0], k, 1), arriving = handle(c.p[2] - c.p[3], k + 1, -1);
            c.p[0] = c.p[0] + moves[k];
            c.p[3] = c.p[3] + moves[k + 1];
            c.p[1] = c.p[0] + leaving;
            c.p[2] = c.p[3] + arriving;
        }
    }

private:
    static Point rotated(Point v, double angle)
    {
        const double c = std::cos(angle), s = std::sin(angle);
        return {c * v.x - s * v.y, s * v.x + c * v.y};
    }
    Point placeOf(std::size_t node) const
    {
        return node < m_path.curves.size() ? m_path.curves[node].p[0] : m_path.curves.back().p[3];
    }
    Point directionAt(std::size_t node) const
    {
        const Point in = node > 0 ? endDirection(m_path.curves[node - 1]) : Point();
        const Point out = node < m_path.curves.size() ? startDirection(m_path.curves[node]) : Point();
        return in + out;
    }
    /// Whether the run turns into the direction of the brush (1) or into the opposite one (-1). A free end is drawn
    /// along by the brush; a run with no free end, or with two, turns by as little as it can.
    double senseOfRun() const
    {
        if (m_startIsFree != m_endIsFree)
            return m_endIsFree ? 1 : -1;
        double along = 0;
        for (std::size_t node = 0; node < m_weights.size(); ++node)
            along += m_weights[node] * dot(directionAt(node), m_tweak.by);
        return along < 0 ? -1 : 1;
    }
    std::vector<Point> movesOfNodes() const
    {
        std::vector<Point> moves{Point()};
        for (std::size_t k = 0; k < m_path.curves.size(); ++k) {
            const Point chord = m_path.curves[k].p[3] - m_path.curves[k].p[0];
            moves.push_back(moves.back() + rotated(chord, 0.5 * (m_turns[k] + m_turns[k + 1])) - chord);
        }
        return moves;
    }
    /// The share of the weighted way at each node, and the whole of it.
    std::vector<double> sharesOfWay()
    {
        std::vector<double> shares{0};
        for (std::size_t k = 0; k < m_path.curves.size(); ++k)
            shares.push_back(shares.back() +
                             0.5 * (m_closing[k] + m_closing[k + 1]) * (m_path.lengths[k + 1] - m_path.lengths[k]));
        m_weighedWay = shares.back();
        for (double &share : shares)
            share = m_weighedWay > 0 ? share / m_weighedWay : 0;
        return shares;
    }

    RunPath &m_path;
    const Tweak &m_tweak;
    TouchField m_field;
    std::vector<double> m_weights, m_closing, m_turns;
    bool m_startIsFree = false, m_endIsFree = false; ///< an end of the stroke that lies under the circle
    double m_weighedWay = 0;
};

void moveByField(Stroke &stroke, const Tweak &tweak, const std::vector<int> &under)
{
    const TouchField field(tweak);
    const Point toMiddle = stroke.origin - tweak.centre;
    for (const int k : under) {
        Segment &segment = stroke.segments[std::size_t(k)];
        const Cubic c = offsetsOf(segment);
        Cubic moved = c;
        for (const std::size_t end : {std::size_t(0), std::size_t(3)}) {
            const std::size_t handle = end == 0 ? 1 : 2;
            const Point place = c.p[end] + toMiddle;
            moved.p[end] = c.p[end] + field.move(place);
            moved.p[handle] = moved.p[end] + field.turned(place, c.p[handle] - c.p[end]);
        }
        segment.bezier = toOffsets(moved);
    }
}

void comb(Stroke &stroke, const Tweak &tweak, const std::vector<int> &under)
{
    std::vector<bool> near(stroke.segments.size());
    for (const int k : under)
        near[std::size_t(k)] = true;
    for (const Chain &run : runsOf(stroke, near)) {
        RunPath path(stroke, run);
        Segment &first = stroke.segments[std::size_t(run.first)], &last = stroke.segments[std::size_t(run.last)];
        const Offset start = first.bezier[0], end = last.bezier[3];
        Combing(path, tweak, tweak.centre - stroke.origin).run();
        writeCurves(stroke, run.first, path.curves);
        if (path.joinsBefore)
            first.bezier[0] = start;
        if (path.joinsAfter)
            last.bezier[3] = end;
    }
}

/// The segments of a stroke of which the circle may touch something, in order. A comb turns curves whatever lies around
/// them, so it leaves what takes paint away where the paint is.
std::vector<int> segmentsUnder(const Stroke &stroke, const Tweak &tweak)
{
    const Point centre = tweak.centre - stroke.origin;
    const bool leavesLifts = tweak.kind == TweakKind::Comb && stroke.laysPaint();
    std::vector<int> under;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k)
        if (squaredDistanceTo(offsetsOf(stroke.segments[k]).controlBox(), centre) < tweak.radius * tweak.radius &&
            !(leavesLifts && stroke.segments[k].takesPaint()))
            under.push_back(int(k));
    return under;
}

/// Splits what lies under the circle and is too long to follow. Returns the segments that there were, and gets where
/// each of those that there are came from; both are empty if nothing is split.
std::vector<Segment> split(Stroke &stroke, const Tweak &tweak, const std::vector<int> &under, std::vector<int> &from)
{
    const Point centre = tweak.centre - stroke.origin;
    const double longest = (tweak.kind == TweakKind::Roughen ? longestRough : longestPart) * tweak.radius;
    std::vector<std::vector<double>> all;
    for (const int k : under) {
        const Cubic curve = offsetsOf(stroke.segments[std::size_t(k)]);
        std::vector<double> cuts;
        addCuts(curve, 0, 1, centre, tweak.radius, longest, cuts);
        cuts = distinct(std::move(cuts), curve);
        if (cuts.empty())
            continue;
        all.resize(stroke.segments.size());
        all[std::size_t(k)] = std::move(cuts);
    }
    if (all.empty())
        return {};
    std::vector<Segment> parts;
    for (Piece &piece : piecesOf(stroke, all)) {
        parts.push_back(std::move(piece.segment));
        from.push_back(piece.source);
    }
    stroke.segments.swap(parts);
    return parts;
}

/// Whether a segment is what a stroke may have, now that its curve is another one.
bool isGood(const Segment &now, const Segment &before, Point origin)
{
    Stroke alone;
    alone.id = 1;
    alone.origin = origin;
    alone.segments = {now};
    alone.segments.front().start = false;
    return problemOf(alone).isEmpty() && (!isPoint(now) || isPoint(before));
}

} // namespace

bool tweak(Stroke &stroke, const Tweak &touch, std::vector<int> *sources)
{
    std::vector<int> under = segmentsUnder(stroke, touch);
    if (under.empty())
        return false;
    std::vector<int> from;
    std::vector<Segment> whole = split(stroke, touch, under, from);
    if (!whole.empty())
        under = segmentsUnder(stroke, touch);
    std::vector<Segment> before;
    for (const int k : under)
        before.push_back(stroke.segments[std::size_t(k)]);
    if (touch.kind == TweakKind::Comb)
        comb(stroke, touch, under);
    else
        moveByField(stroke, touch, under);
    // Only what lies under the circle differs: so it alone is looked at, and put back.
    bool changes = !whole.empty(), good = true;
    for (std::size_t i = 0; i < under.size() && good; ++i) {
        const Segment &now = stroke.segments[std::size_t(under[i])];
        changes = changes || now.bezier != before[i].bezier;
        good = now.bezier == before[i].bezier || isGood(now, before[i], stroke.origin);
    }
    if (changes && good) {
        if (sources)
            *sources = std::move(from);
        return true;
    }
    for (std::size_t i = 0; i < under.size(); ++i)
        stroke.segments[std::size_t(under[i])] = std::move(before[i]);
    if (!whole.empty())
        stroke.segments = std::move(whole);
    return false;
}

std::optional<Stroke> tweaked(const Stroke &stroke, const Tweak &touch, std::vector<int> *sources)
{
    if (segmentsUnder(stroke, touch).empty())
        return std::nullopt;
    Stroke result = stroke;
    if (!tweak(result, touch, sources))
        return std::nullopt;
    if (sources && sources->empty())
        for (int k = 0; k < int(result.segments.size()); ++k)
            sources->push_back(k);
    return result;
}

} // namespace suffuse
