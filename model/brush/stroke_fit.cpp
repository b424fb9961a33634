#include "model/brush/stroke_fit.h"

#include "model/brush/spline_fit.h"
#include "model/paint/half_width.h"

#include <numbers>

namespace suffuse {

namespace {

using namespace knot_column;

/// A pause of at least this length does not belong to the segment after it.
constexpr Microseconds longestBirthGap = 1'000'000 / 6;
constexpr int mostPieces = 1024;
constexpr double constantBelow = 1e-3;
/// A tip that is not round counts as constant while the path turns by fewer radians.
constexpr double largestTurn = 0.01;
/// Control points stay this close to the origin, so that origin plus offset stays in its domain.
constexpr double largestOffset = 6.7e11;

/// The Hermite form of the spline between two knots, at fraction u.
KnotValues valuesAt(const Knot &a, const Knot &b, double u)
{
    const double h = b.parameter - a.parameter, v = 1 - u;
    KnotValues result;
    for (std::size_t c = 0; c < result.size(); ++c)
        result[c] = v * v * (1 + 2 * u) * a.value[c] + u * u * (1 + 2 * v) * b.value[c] +
                    h * u * v * (v * a.derivative[c] - u * b.derivative[c]);
    return result;
}

double chord(const Knot &a, const Knot &b)
{
    return length(b.position() - a.position());
}

/// Handles longer than this would make a loop that the pen did not draw: beside a jump of the pointer the spline has
/// the speed of the jump.
double handleLimit(std::span<const Knot> knots, std::size_t i)
{
    const double own = chord(knots[i], knots[i + 1]);
    if (i == 0 || i + 2 >= knots.size())
        return own;
    return std::max(own, std::min(chord(knots[i - 1], knots[i]), chord(knots[i + 1], knots[i + 2])));
}

Point handle(const Knot &knot, double third, double limit)
{
    Point d{third * knot.derivative[X], third * knot.derivative[Y]};
    const double l = length(d);
    return l > limit ? (limit / l) * d : d;
}

Offset offsetOf(Point p)
{
    return {float(std::clamp(p.x, -largestOffset, largestOffset)),
            float(std::clamp(p.y, -largestOffset, largestOffset))};
}

/// Appends the pieces of one interval.
class Splitter {
public:
    Splitter(const Brush &brush, const Knot &a, const Knot &b, const TaperedPath &path, std::vector<Segment> &segments)
        : m_brush(brush), m_a(a), m_b(b), m_path(path), m_segments(segments),
          m_born(std::max(a.time, b.time - longestBirthGap))
    {}

    /// Appends the smallest number of pieces, equal in time, that are short enough. Returns their arc length.
    double append(const Cubic &whole)
    {
        m_whole = whole;
        const double arc = arcLength(whole);
        const double wanted = std::min(std::ceil(arc / (0.5 * spreadAt(0.5))), std::ceil(variation(0, 1)));
        int pieces = int(std::clamp(wanted, 1.0, double(mostPieces)));
        while (pieces < mostPieces && !isFineEnough(pieces))
            pieces += 1 + pieces / 16;
        Cubic rest = whole;
        for (int i = 0; i < pieces; ++i) {
            const auto parts = rest.split(1.0 / (pieces - i));
            emitSegment(i + 1 < pieces ? parts[0] : rest, (i + 0.5) / pieces, double(i) / pieces);
            rest = parts[1];
        }
        return arc;
    }

private:
    Paint paintAt(double u) const
    {
        Knot at;
        at.value = valuesAt(m_a, m_b, u);
        Paint paint = at.paint();
        const double distance = m_a.distance + u * (m_b.distance - m_a.distance);
        paint.size = std::max(leastSize, paint.size * taperAt(m_path.taper, distance, m_path.length - distance));
        return paint;
    }

    double spreadAt(double u) const
    {
        const Paint paint = paintAt(u);
        return spreadOf(m_brush, paint.size, paint.maxAge);
    }

    /// Whether every piece is at most s/2 long, or its attributes are constant.
    bool isFineEnough(int pieces) const
    {
        Cubic rest = m_whole;
        for (int i = 0; i < pieces; ++i) {
            const auto parts = rest.split(1.0 / (pieces - i));
            const double from = double(i) / pieces, to = double(i + 1) / pieces;
            if (polygonLength(parts[0]) > 0.5 * spreadAt(0.5 * (from + to)) && variation(from, to) > 1)
                return false;
            rest = parts[1];
        }
        return true;
    }

    /// The greatest variation of an attribute, as a multiple of the variation that counts as constant.
    double variation(double from, double to) const
    {
        const double middle = 0.5 * (from + to);
        const Paint p[] = {paintAt(from), paintAt(middle), paintAt(to)};
        double greatest = 0;
        const auto compare = [&](double a, double b, double c, double full) {
            const auto [low, high] = std::minmax({a, b, c});
            greatest = std::max(greatest, (high - low) / (constantBelow * full));
        };
        compare(p[0].size, p[1].size, p[2].size, 1);
        compare(p[0].peak, p[1].peak, p[2].peak, std::max(double(m_brush.peak), 1e-30));
        compare(p[0].granulation, p[1].granulation, p[2].granulation, 1);
        compare(p[0].maxAge, p[1].maxAge, p[2].maxAge, m_brush.maxAge);
        compare(p[0].colour.red, p[1].colour.red, p[2].colour.red, 1);
        compare(p[0].colour.yellow, p[1].colour.yellow, p[2].colour.yellow, 1);
        compare(p[0].colour.blue, p[1].colour.blue, p[2].colour.blue, 1);
        compare(p[0].colour.opacity, p[1].colour.opacity, p[2].colour.opacity, 1);
        if (m_brush.tip.ratio != 1)
            greatest = std::max(greatest, turn(from, to) / largestTurn);
        return greatest;
    }

    /// The angle between the directions at two places, radians.
    double turn(double from, double to) const
    {
        const Point a = m_whole.derivative(from), b = m_whole.derivative(to);
        return std::abs(std::atan2(cross(a, b), dot(a, b)));
    }

    void emitSegment(const Cubic &cubic, double middle, double from)
    {
        Segment s;
        for (std::size_t i = 0; i < 4; ++i)
            s.bezier[i] = offsetOf(cubic.p[i]);
        if (!m_segments.empty())
            s.bezier[0] = m_segments.back().bezier[3];
        const bool isPoint = s.bezier[0] == s.bezier[1] && s.bezier[0] == s.bezier[2] && s.bezier[0] == s.bezier[3];
        if (isPoint)
            return;
        setPaint(s, m_brush, paintAt(middle), cubic.derivative(0.5));
        s.born = m_born + Microseconds(std::llround(from * double(m_b.time - m_born)));
        m_segments.push_back(std::move(s));
    }

    const Brush &m_brush;
    const Knot &m_a;
    const Knot &m_b;
    const TaperedPath &m_path;
    std::vector<Segment> &m_segments;
    Microseconds m_born;
    Cubic m_whole;
};

} // namespace

void Knot::setPaint(const Paint &paint)
{
    value[Size] = paint.size;
    value[Peak] = paint.peak;
    value[Granulation] = paint.granulation;
    value[MaxAge] = paint.maxAge;
    value[Red] = paint.colour.red;
    value[Yellow] = paint.colour.yellow;
    value[Blue] = paint.colour.blue;
    value[Opacity] = paint.colour.opacity;
}

Paint Knot::paint() const
{
    const auto unit = [this](std::size_t column) { return float(std::clamp(value[column], 0.0, 1.0)); };
    Paint paint;
    paint.size = std::clamp(value[Size], leastSize, 1.0);
    paint.peak = std::max(0.0, value[Peak]);
    paint.granulation = std::clamp(value[Granulation], 0.0, 1.0);
    paint.maxAge = value[MaxAge];
    paint.colour = {unit(Red), unit(Yellow), unit(Blue), unit(Opacity)};
    return paint;
}

void setPaint(Segment &segment, const Brush &brush, const Paint &paint, Point direction)
{
    constexpr double least = std::numeric_limits<float>::min();
    const double age = std::clamp(paint.maxAge, leastAge * double(brush.maxAge), double(brush.maxAge));
    const double spread = spreadAcross(brush.tip, spreadOf(brush, paint.size, age), direction);
    segment.diffusion = float(std::max(least, double(brush.diffusion) * paint.size * paint.size));
    segment.density = float(std::clamp(densityOfPeak(paint.peak, spread), 0.0, 1e12));
    segment.granulation = float(paint.granulation);
    segment.maxAge = float(std::max(least, age));
    segment.colour = paint.colour;
    if (brush.tip.ratio != 1) {
        segment.anisotropyRatio = brush.tip.ratio;
        segment.anisotropyAngle = float(tipAngle(brush.tip, direction));
    }
}

Knot interpolated(const Knot &a, const Knot &b, double u)
{
    Knot k;
    k.parameter = a.parameter + u * (b.parameter - a.parameter);
    k.distance = a.distance + u * (b.distance - a.distance);
    k.time = a.time + Microseconds(std::llround(u * double(b.time - a.time)));
    for (std::size_t c = 0; c < k.value.size(); ++c)
        k.value[c] = (1 - u) * a.value[c] + u * b.value[c];
    return k;
}

void fitSpline(std::span<Knot> knots, bool startIsFixed)
{
    const auto n = Eigen::Index(knots.size());
    constexpr Eigen::Index columns = std::tuple_size_v<KnotValues>;
    Eigen::VectorXd times(n);
    Eigen::MatrixXd values(n, columns);
    for (Eigen::Index i = 0; i < n; ++i) {
        times[i] = knots[std::size_t(i)].parameter;
        values.row(i) = Eigen::Map<const Eigen::RowVectorXd>(knots[std::size_t(i)].value.data(), columns);
    }
    const Eigen::RowVectorXd start = Eigen::Map<const Eigen::RowVectorXd>(knots[0].derivative.data(), columns);
    const Eigen::MatrixXd d = startIsFixed ? splineDerivatives(times, values, start) : splineDerivatives(times, values);
    for (Eigen::Index i = startIsFixed ? 1 : 0; i < n; ++i)
        Eigen::Map<Eigen::RowVectorXd>(knots[std::size_t(i)].derivative.data(), columns) = d.row(i);
}

double appendInterval(const Brush &brush, std::span<const Knot> knots, std::size_t i, const TaperedPath &path,
                      std::vector<Segment> &segments)
{
    const Knot &a = knots[i], &b = knots[i + 1];
    const double third = (b.parameter - a.parameter) / 3, limit = handleLimit(knots, i);
    const Cubic cubic{
        {a.position(), a.position() + handle(a, third, limit), b.position() - handle(b, third, limit), b.position()}};
    return Splitter(brush, a, b, path, segments).append(cubic);
}

double arcLength(const Cubic &cubic)
{
    // Gauss-Legendre quadrature with 5 points on each quarter.
    static constexpr double node[] = {0, 0.5384693101056831, 0.9061798459386640};
    static constexpr double weight[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    constexpr int parts = 4;
    double sum = 0;
    for (int part = 0; part < parts; ++part) {
        const double middle = (part + 0.5) / parts, half = 0.5 / parts;
        sum += weight[0] * length(cubic.derivative(middle));
        for (int i = 1; i < 3; ++i)
            sum += weight[i] * (length(cubic.derivative(middle - half * node[i])) +
                                length(cubic.derivative(middle + half * node[i])));
    }
    return sum * 0.5 / parts;
}

double shortStrokeRaise(double arcLength, double spread)
{
    return arcLength < 2 * spread ? 1 / std::erf(arcLength / (2 * spread)) : 1;
}

} // namespace suffuse
