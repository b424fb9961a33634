#include "model/brush/response_curve.h"

namespace suffuse {

namespace {

double slopeBetween(Offset a, Offset b)
{
    return (double(b.y) - double(a.y)) / (double(b.x) - double(a.x));
}

/// The slope at a point between two intervals of given lengths and slopes. At an extremum it is 0, otherwise the
/// weighted harmonic mean, so that the curve stays monotone (Fritsch and Butland).
double slopeAtInner(double h0, double d0, double h1, double d1)
{
    if (d0 * d1 <= 0)
        return 0;
    const double w0 = 2 * h1 + h0, w1 = h1 + 2 * h0;
    return (w0 + w1) / (w0 / d0 + w1 / d1);
}

} // namespace

double ResponseCurve::at(double x) const
{
    x = std::clamp(x, 0.0, 1.0);
    if (x <= double(points.front().x))
        return points.front().y;
    if (x >= double(points.back().x))
        return points.back().y;
    std::size_t i = 0;
    while (x > double(points[i + 1].x))
        ++i;
    const Offset a = points[i], b = points[i + 1];
    const double h = double(b.x) - double(a.x), d = slopeBetween(a, b), u = (x - double(a.x)) / h;
    double start = d, end = d;
    if (i > 0)
        start = slopeAtInner(double(a.x) - double(points[i - 1].x), slopeBetween(points[i - 1], a), h, d);
    if (i + 2 < points.size())
        end = slopeAtInner(h, d, double(points[i + 2].x) - double(b.x), slopeBetween(b, points[i + 2]));
    // This is the distance from the straight line, which two points give exactly.
    const double bend = h * u * (1 - u) * ((1 - u) * (start - d) - u * (end - d));
    return std::clamp(double(a.y) + u * (double(b.y) - double(a.y)) + bend, 0.0, 1.0);
}

bool ResponseCurve::isValid() const
{
    if (points.size() < 2 || points.size() > mostPoints)
        return false;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Offset p = points[i];
        if (!(p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1) || (i > 0 && !(p.x > points[i - 1].x)))
            return false;
    }
    return true;
}

} // namespace suffuse
