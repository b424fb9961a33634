#include "model/stroke_fit.h"

#include "model/spline_fit.h"

#include <numbers>

namespace suffuse {

namespace {

using namespace knot_column;

/// A pause this long does not belong to the segment after it.
constexpr Microseconds longestBirthGap = 1'000'000 / 6;
constexpr int mostPieces = 1024;
constexpr double constantBelow = 1e-3;
/// Control points stay this close to the origin, so that origin plus offset stays in its domain.
constexpr double largestOffset = 6.7e11;

/// Hermite form of the spline between two knots at fraction u.
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

/// Handles longer than this would make a loop that the pen did not: next to a jump of the pointer the spline's speed is
/// that of the jump.
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

/// Emits the pieces of one interval.
class Splitter {
public:
    Splitter(const Brush &brush, const Knot &a, const Knot &b, std::vector<Segment> &segments)
        : m_brush(brush), m_a(a), m_b(b), m_segments(segments), m_spread(brush.spread()),
          m_fullDensity(densityFor(brush, 1)), m_born(std::max(a.time, b.time - longestBirthGap))
    {}

    /// Emits the smallest number of pieces, equal in time, that are short enough. Returns their arc length.
    double append(const Cubic &whole)
    {
        const double arc = arcLength(whole);
        const double wanted = std::min(std::ceil(arc / (0.5 * m_spread)), std::ceil(variation(0, 1)));
        int pieces = int(std::clamp(wanted, 1.0, double(mostPieces)));
        while (pieces < mostPieces && !isFineEnough(whole, pieces))
            ++pieces;
        Cubic rest = whole;
        for (int i = 0; i < pieces; ++i) {
            const auto parts = rest.split(1.0 / (pieces - i));
            emitSegment(i + 1 < pieces ? parts[0] : rest, (i + 0.5) / pieces, double(i) / pieces);
            rest = parts[1];
        }
        return arc;
    }

private:
    static double polygonLength(const Cubic &c)
    {
        return length(c.p[1] - c.p[0]) + length(c.p[2] - c.p[1]) + length(c.p[3] - c.p[2]);
    }

    /// Every piece is at most s/2 long, or its attributes are constant.
    bool isFineEnough(const Cubic &whole, int pieces) const
    {
        Cubic rest = whole;
        for (int i = 0; i < pieces; ++i) {
            const auto parts = rest.split(1.0 / (pieces - i));
            if (polygonLength(parts[0]) > 0.5 * m_spread && variation(double(i) / pieces, double(i + 1) / pieces) > 1)
                return false;
            rest = parts[1];
        }
        return true;
    }

    /// The greatest variation of an attribute, in multiples of what counts as constant.
    double variation(double from, double to) const
    {
        const KnotValues v[] = {valuesAt(m_a, m_b, from), valuesAt(m_a, m_b, 0.5 * (from + to)),
                                valuesAt(m_a, m_b, to)};
        double greatest = 0;
        for (std::size_t c = Density; c <= Opacity; ++c) {
            const auto [low, high] = std::minmax({v[0][c], v[1][c], v[2][c]});
            greatest = std::max(greatest, (high - low) / (constantBelow * (c == Density ? m_fullDensity : 1)));
        }
        return greatest;
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
        const KnotValues v = valuesAt(m_a, m_b, middle);
        const auto unit = [&v](std::size_t column) { return float(std::clamp(v[column], 0.0, 1.0)); };
        s.diffusion = m_brush.diffusion;
        s.density = float(std::clamp(v[Density], 0.0, 1e12));
        s.granulation = m_brush.granulation;
        s.maxAge = m_brush.maxAge;
        s.born = m_born + Microseconds(std::llround(from * double(m_b.time - m_born)));
        s.colour = {unit(Red), unit(Yellow), unit(Blue), unit(Opacity)};
        m_segments.push_back(std::move(s));
    }

    const Brush &m_brush;
    const Knot &m_a;
    const Knot &m_b;
    std::vector<Segment> &m_segments;
    double m_spread;
    double m_fullDensity;
    Microseconds m_born;
};

} // namespace

double densityFor(const Brush &brush, double pressure)
{
    const double share = brush.pressureFloor + (1 - double(brush.pressureFloor)) * pressure;
    return brush.peak * std::sqrt(std::numbers::pi) * brush.spread() * share;
}

Knot interpolated(const Knot &a, const Knot &b, double u)
{
    Knot k;
    k.parameter = a.parameter + u * (b.parameter - a.parameter);
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

double appendInterval(const Brush &brush, std::span<const Knot> knots, std::size_t i, std::vector<Segment> &segments)
{
    const Knot &a = knots[i], &b = knots[i + 1];
    const double third = (b.parameter - a.parameter) / 3, limit = handleLimit(knots, i);
    const Cubic cubic{
        {a.position(), a.position() + handle(a, third, limit), b.position() - handle(b, third, limit), b.position()}};
    return Splitter(brush, a, b, segments).append(cubic);
}

double arcLength(const Cubic &cubic)
{
    // Gauss-Legendre, 5 points on each quarter.
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
