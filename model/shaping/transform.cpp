#include "model/shaping/transform.h"

#include "model/geometry/bernstein.h"
#include "model/painting/decimal.h"
#include "model/painting/tensor.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/split.h"

#include <utility>

namespace suffuse {

namespace {

/// The greatest ratio of |dl′|/|dl| within a part that is longer than the spread.
constexpr double largestStretch = 1.01;
/// In shorter parts the spread evens out the error of having one density for the whole part. A part of length l, in
/// which the ratio is 1 + δ, has an error whose first moment is at most δφl²/12. A row of such parts, each in
/// proportion right, sums to δφl/12 times the kernel at its ends: 0.047·δ·l/s of the density there, and half as much
/// again where the curve bends. Half a per cent, as in the longer parts, means δ = 0.07·s/l.
constexpr double evenedStretch = 0.07;

/// As a share of the spread: in so short a part only the amount of paint matters, not where it lies.
constexpr double shortestEvenPart = 1.0 / 256;

/// The spread of a dry segment along the shorter axis of its tensor.
double fullSpread(const Segment &segment)
{
    return segment.spread(segment.driesAt()) * std::sqrt(std::min(1.0, double(segment.anisotropyRatio)));
}

/// (|dl′|/|dl|)² in a direction of length 1.
double squaredStretch(const Affine &map, Point direction)
{
    const Point turned = map.turned(direction);
    return dot(turned, turned);
}

/// How uneven a part of a given length may be.
double largestRatio(double length, double spread)
{
    return length < spread ? 1 + evenedStretch * spread / length : largestStretch;
}

/// An upper bound of |d ln stretch/dθ|: (σ₁/σ₂ − σ₂/σ₁)/2 for the map's singular values.
double steepestOf(const Affine &map)
{
    const double squares = map.a * map.a + map.b * map.b + map.c * map.c + map.d * map.d; // σ₁² + σ₂²
    const double product = std::abs(map.determinant());                                   // σ₁σ₂
    return 0.5 * std::sqrt(std::max(0.0, squares * squares - 4 * product * product)) / product;
}

/// Whether the stretch is surely even along a curve. The angle between the sides of its control polygon, which contains
/// all its directions, decides.
bool isSurelyEven(const Cubic &curve, double steepest, double spread)
{
    double angle = 0;
    const Point start = startDirection(curve);
    for (std::size_t i = 1; i < 4; ++i) {
        const Point side = curve.p[i] - curve.p[i - 1];
        if (side != Point())
            angle = std::max(angle, std::abs(std::atan2(cross(start, side), dot(start, side))));
    }
    return angle < 1 && 2 * angle * steepest < std::log(largestRatio(polygonLength(curve), spread));
}

/// Walks along a curve, and marks each place where the stretch has changed too much since the last mark.
class EvenParts {
public:
    EvenParts(const Cubic &curve, const Affine &map, double steepest, double spread)
        : m_curve(curve), m_map(map), m_spread(spread), m_close(std::cos(std::min(0.1, 0.01 / steepest)))
    {
        restart(startDirection(curve));
    }

    std::vector<double> find()
    {
        constexpr double largestStep = 1.0 / 16, smallestStep = 1.0 / 16384;
        double step = largestStep;
        while (m_at < 1) {
            const double to = std::min(1.0, m_at + step);
            const Point direction = directionAt(to);
            // At a sharp turn the stretch may come back to what it was, so smaller steps are taken there.
            const bool isClose = dot(direction, m_direction) > m_close || step <= smallestStep;
            const double length = m_length + suffuse::length(m_curve.at(to) - m_curve.at(m_at));
            const double most = largestRatio(length, m_spread);
            if (isClose && take(directionAt(0.5 * (m_at + to)), most) && take(direction, most)) {
                go(to, direction, length);
                step = std::min(2 * step, largestStep);
            } else if (step > smallestStep) {
                step = 0.5 * step;
            } else {
                // Around a cusp the parts would never be even.
                if (polygonLength(partOf(m_curve, m_mark, m_at)) >= shortestEvenPart * m_spread) {
                    m_mark = m_at;
                    m_marks.push_back(m_mark);
                    restart(m_direction);
                }
                include(squaredStretch(m_map, direction));
                go(to, direction, m_length + suffuse::length(m_curve.at(to) - m_curve.at(m_at)));
            }
        }
        return distinct(std::move(m_marks), m_curve);
    }

private:
    /// The direction at p or, at a cusp and where handles are drawn in, the last direction before.
    Point directionAt(double p) const
    {
        const Point direction = unit(m_curve.derivative(p));
        return direction == Point() ? m_direction : direction;
    }

    /// Adds a direction to the part. Returns false, and does nothing, if the part would become too uneven.
    bool take(Point direction, double most)
    {
        const double g = squaredStretch(m_map, direction);
        if (std::max(m_most, g) > most * most * std::min(m_least, g))
            return false;
        include(g);
        return true;
    }

    void include(double g)
    {
        m_least = std::min(m_least, g);
        m_most = std::max(m_most, g);
    }

    void go(double to, Point direction, double length)
    {
        m_at = to;
        m_direction = direction;
        m_length = length;
    }

    void restart(Point direction)
    {
        m_direction = direction;
        m_least = m_most = squaredStretch(m_map, direction);
        m_length = 0;
    }

    const Cubic &m_curve;
    const Affine &m_map;
    double m_spread;
    double m_close; ///< the cosine of the angle within which the stretch changes by at most a hundredth
    double m_at = 0, m_mark = 0;
    double m_length = 0; ///< from the last mark
    Point m_direction;
    double m_least = 1, m_most = 1; ///< squared stretches
    std::vector<double> m_marks;
};

/// The quotient of the arc lengths after and before the map. Both are computed by one rule, so it lies between the
/// extremes of the stretch.
double meanStretch(const Cubic &curve, const Affine &map)
{
    constexpr std::array<double, 3> nodes{0, 0.5384693101056831, 0.9061798459386640};
    constexpr std::array<double, 3> weights{0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    double before = 0, after = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (int side = i == 0 ? 1 : -1; side <= 1; side += 2) {
            const Point d = curve.derivative(0.5 * (1 + side * nodes[i]));
            before += weights[i] * length(d);
            after += weights[i] * length(map.turned(d));
        }
    }
    return before > 0 ? after / before : 1;
}

void scaleEvenly(Segment &segment, const Affine &map)
{
    const double determinant = map.determinant();
    const double squared = std::abs(determinant);
    segment.diffusion = float(segment.diffusion * squared);
    segment.density = float(segment.density * std::sqrt(squared));
    if (segment.isIsotropic())
        return;
    const double turn = std::atan2(map.c, map.a);
    segment.anisotropyAngle = float(determinant > 0 ? segment.anisotropyAngle + turn : turn - segment.anisotropyAngle);
}

void scaleUnevenly(Segment &segment, const Affine &map)
{
    setTensor(segment, mapped(tensorOf(segment), map));
    const double factor = std::abs(map.determinant()) / meanStretch(offsetsOf(segment), map);
    segment.density = float(segment.density * factor);
}

/// Its density stays, since it is that of an area. The lines of one colour are mapped as lines: they need not stay
/// perpendicular to the way from `from` to `to`.
Fill mappedFill(Fill fill, const Affine &map, SpreadRule rule)
{
    if (rule == SpreadRule::Scales) {
        const Tensor tensor = tensorOf(fill);
        if (map.isSimilarity() && fill.isIsotropic())
            fill.diffusion = float(fill.diffusion * std::abs(map.determinant()));
        else
            setTensor(fill, mapped(tensor, map));
    }
    if (!fill.gradient)
        return fill;
    Gradient &g = *fill.gradient;
    const Point from = map.turned(Point() + g.from), along = (Point() + g.to) - (Point() + g.from);
    const Point slope = 1 / dot(along, along) * along; // of the place between the colours
    const double determinant = map.determinant();      // It is turned by the inverse transposed map.
    const Point turned{(map.d * slope.x - map.c * slope.y) / determinant,
                       (map.a * slope.y - map.b * slope.x) / determinant};
    g.from = toOffset(from, {});
    g.to = toOffset(from + 1 / dot(turned, turned) * turned, {});
    return fill;
}

std::vector<Piece> mappedPieces(const Stroke &stroke, const Affine &map, SpreadRule rule)
{
    const bool isEven = map.isSimilarity();
    const double steepest = steepestOf(map);
    std::vector<std::vector<double>> places(stroke.segments.size());
    if (rule == SpreadRule::Scales && !isEven)
        for (std::size_t k = 0; k < places.size(); ++k) {
            const Segment &segment = stroke.segments[k];
            const Cubic curve = offsetsOf(segment);
            const double spread = fullSpread(segment);
            const bool paints = segment.density > 0; // What only bounds a fill has no spread that could vary.
            if (paints && !isPoint(segment) && !isSurelyEven(curve, steepest, spread))
                places[k] = EvenParts(curve, map, steepest, spread).find();
        }
    std::vector<Piece> pieces = piecesOf(stroke, places);
    for (Piece &piece : pieces) {
        Segment &segment = piece.segment;
        if (rule == SpreadRule::Scales)
            (isEven ? scaleEvenly : scaleUnevenly)(segment, map);
        for (Offset &o : segment.bezier)
            o = toOffset(map.turned(Point() + o), {});
    }
    return pieces;
}

} // namespace

std::optional<Stroke> tryTransformed(const Stroke &stroke, const Affine &map, SpreadRule rule,
                                     std::vector<int> *sources)
{
    if (!map.inverse())
        return std::nullopt;
    Stroke result = stroke;
    result.origin = map(stroke.origin);
    if (sources)
        sources->clear();
    if (map.isTranslation()) {
        result.origin = {decimalSum(stroke.origin.x, map.offset.x), decimalSum(stroke.origin.y, map.offset.y)};
        for (int k = 0; sources && k < int(stroke.segments.size()); ++k)
            sources->push_back(k);
    } else {
        if (stroke.fill)
            result.fill = mappedFill(*stroke.fill, map, rule);
        if (stroke.picture) // The linear part alone: it hangs on the origin, which is mapped itself.
            result.picture = mapped(*stroke.picture, {map.a, map.b, map.c, map.d, {}});
        result.segments.clear();
        for (Piece &piece : mappedPieces(stroke, map, rule)) {
            const bool isNewPoint = isPoint(piece.segment) && !isPoint(stroke.segments[std::size_t(piece.source)]);
            if (isNewPoint)
                return std::nullopt;
            result.segments.push_back(std::move(piece.segment));
            if (sources)
                sources->push_back(piece.source);
        }
    }
    if (!problemOf(result).isEmpty())
        return std::nullopt;
    return result;
}

Stroke transformed(const Stroke &stroke, const Affine &map, SpreadRule rule)
{
    return tryTransformed(stroke, map, rule).value_or(stroke);
}

Rect curveBox(const Cubic &cubic)
{
    Rect box;
    box.include(cubic.p[0]);
    box.include(cubic.p[3]);
    for (Point axis : {Point{1, 0}, Point{0, 1}}) {
        std::array<double, 3> slope;
        for (std::size_t i = 0; i < 3; ++i)
            slope[i] = dot(axis, cubic.p[i + 1] - cubic.p[i]);
        for (double p : bernsteinRoots(slope))
            box.include(cubic.at(p));
    }
    return box;
}

Rect curveBox(const Stroke &stroke)
{
    Rect box;
    const bool lays = stroke.laysPaint();
    for (const Segment &segment : stroke.segments) {
        if (segment.takesPaint() && lays)
            continue;
        const Cubic curve = stroke.cubicOf(segment);
        // Most segments lie within what is covered already.
        const Rect control = curve.controlBox();
        if (control.left < box.left || control.right > box.right || control.top < box.top ||
            control.bottom > box.bottom)
            box = box.united(curveBox(curve));
    }
    return box;
}

Rect controlBox(const Stroke &stroke)
{
    Rect box;
    for (const Segment &segment : stroke.segments)
        for (const Offset &offset : segment.bezier)
            box.include(stroke.origin + offset);
    return box;
}

} // namespace suffuse
