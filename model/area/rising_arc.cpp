#include "model/area/rising_arc.h"

namespace suffuse {

namespace {

/// The parameter in [0, 1] where a monotone cubic of one coordinate takes a value.
double parameterOf(double a, double b, double c, double d, double value)
{
    const bool rises = a < d;
    if (rises ? value <= a : value >= a)
        return 0;
    if (rises ? value >= d : value <= d)
        return 1;
    // Relative to the value, so that an arc far from 0 has the digits that its own size needs.
    const double c0 = a - value, c1 = 3 * (b - a), c2 = 3 * (c - 2 * b + a), c3 = d - a + 3 * (b - c);
    const double exact = 2e-16 * std::abs(d - a);
    double low = 0, high = 1, t = (value - a) / (d - a), step = 1;
    for (int i = 0; i < 100; ++i) {
        const double off = c0 + t * (c1 + t * (c2 + t * c3));
        if (std::abs(off) <= exact)
            return t;
        ((off > 0) == rises ? high : low) = t;
        const double slope = c1 + t * (2 * c2 + 3 * t * c3), next = t - off / slope;
        const bool inside = next > low && next < high;
        if (inside && std::abs(next - t) < 1e-15)
            return next;
        // Newton's method, as long as its steps become much smaller.
        const double newton = std::abs(next - t);
        const bool takes = inside && newton < 0.5 * step;
        step = takes ? newton : high - low;
        t = takes ? next : 0.5 * (low + high);
        if (high - low < 1e-16)
            break;
    }
    return t;
}

/// Adds the parameters in (0, 1) where one coordinate turns.
void addTurns(double a, double b, double c, double d, std::vector<double> &turns)
{
    const double first = b - a, second = c - b, third = d - c; // the slope's Bernstein coefficients
    const double square = first - 2 * second + third, linear = 2 * (second - first);
    const double discriminant = linear * linear - 4 * square * first;
    if (!(discriminant > 0))
        return;
    const double q = -0.5 * (linear + std::copysign(std::sqrt(discriminant), linear));
    for (const double t : {q / square, first / q})
        if (t > 0 && t < 1)
            turns.push_back(t);
}

} // namespace

double RisingArc::parameterAtY(double y) const
{
    const auto &p = curve.p;
    return parameterOf(p[0].y, p[1].y, p[2].y, p[3].y, y);
}

double RisingArc::xAtParameter(double t) const
{
    return t <= 0 ? curve.p[0].x : t >= 1 ? curve.p[3].x : std::clamp(curve.at(t).x, left(), right());
}

double RisingArc::parameterAtX(double x) const
{
    const auto &p = curve.p;
    return parameterOf(p[0].x, p[1].x, p[2].x, p[3].x, x);
}

ArcChord::ArcChord(const RisingArc &arc)
    : m_x(arc.curve.p[0].x), m_y(arc.curve.p[0].y), m_bend(std::numeric_limits<double>::infinity())
{
    const auto &p = arc.curve.p;
    const double height = p[3].y - p[0].y, width = arc.right() - arc.left();
    if (!(height > 1e-6 * width))
        return;
    m_slope = (p[3].x - p[0].x) / height;
    const auto off = [&](Point q) { return std::abs(q.x - m_x - m_slope * (q.y - m_y)); };
    const double farthest = std::max({std::abs(p[0].x), std::abs(p[3].x), std::abs(p[0].y), std::abs(p[3].y)});
    m_bend = std::max(off(p[1]), off(p[2])) + 1e-9 * (width + height) + 1e-14 * (1 + std::abs(m_slope)) * farthest;
}

Cubic between(const Cubic &curve, double from, double to)
{
    if (from <= 0 && to >= 1)
        return curve;
    const Cubic before = to >= 1 ? curve : curve.split(to)[0];
    return from <= 0 ? before : before.split(from / std::min(to, 1.0))[1];
}

void appendRisingParts(const Cubic &curve, std::vector<RisingPart> &out)
{
    const auto &p = curve.p;
    std::vector<double> turns;
    addTurns(p[0].x, p[1].x, p[2].x, p[3].x, turns);
    addTurns(p[0].y, p[1].y, p[2].y, p[3].y, turns);
    std::sort(turns.begin(), turns.end());
    turns.push_back(1);
    double from = 0;
    Point begin = p[0];
    for (const double to : turns) {
        if (to <= from)
            continue;
        Cubic part = between(curve, from, to);
        part.p[0] = begin; // Neighbours meet in the same point.
        begin = to >= 1 ? p[3] : part.p[3];
        part.p[3] = begin;
        from = to;
        if (part.p[0].y == part.p[3].y)
            continue;
        const bool falls = part.p[0].y > part.p[3].y;
        if (falls)
            part = {{part.p[3], part.p[2], part.p[1], part.p[0]}};
        out.push_back({{part}, falls});
    }
}

} // namespace suffuse
