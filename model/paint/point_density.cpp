#include "model/paint/point_density.h"

#include "model/painting/influence.h"

#include <numbers>

namespace suffuse {

namespace {

/// How a curve is divided.
struct Pieces {
    double flatness; ///< the distance between the curve and its pieces, in spreads
    int most;
};

Pieces piecesFor(CurveDetail detail)
{
    return detail == CurveDetail::Rough ? Pieces{0.03, 64} : Pieces{0.001, 1024};
}

/// Maps to where the segment's Gaussian is e^(−|x|²), so that lengths are in spreads.
class Whitening {
public:
    Whitening(const Segment &segment, double spread)
        : m_cos(std::cos(segment.anisotropyAngle)), m_sin(std::sin(segment.anisotropyAngle)),
          m_along(1 / (spread * std::sqrt(double(segment.anisotropyRatio)))), m_across(1 / spread)
    {}
    Point operator()(Point d) const
    {
        return {m_along * (m_cos * d.x + m_sin * d.y), m_across * (m_cos * d.y - m_sin * d.x)};
    }
    /// The reciprocal of the Gaussian's integral over the plane.
    double norm() const { return m_along * m_across / std::numbers::pi; }

private:
    double m_cos, m_sin, m_along, m_across;
};

/// How many pieces of equal parameter stay near enough to the whitened curve.
int pieceCount(const Cubic &c, const Pieces &pieces)
{
    const Point a = c.p[0] - 2 * c.p[1] + c.p[2], b = c.p[1] - 2 * c.p[2] + c.p[3];
    const double bend = 6 * std::max(length(a), length(b));
    return int(std::clamp(std::ceil(std::sqrt(bend / (8 * pieces.flatness))), 1.0, double(pieces.most)));
}

/// ∫ e^(−|x|²) dl over a straight piece from a to b, both as seen from the point.
double lineIntegral(Point a, Point b)
{
    const double l = length(b - a);
    if (l < 1e-6)
        return l * std::exp(-dot(a, a));
    const Point along = (1 / l) * (b - a);
    const double u0 = dot(a, along), u1 = dot(b, along), v = cross(along, a);
    return 0.5 * std::sqrt(std::numbers::pi) * std::exp(-v * v) * (std::erf(u1) - std::erf(u0));
}

} // namespace

double segmentDensity(const Segment &segment, double spread, Point fromOrigin, CurveDetail detail)
{
    const Whitening whiten(segment, spread);
    Cubic cubic, whitened;
    for (std::size_t i = 0; i < 4; ++i) {
        cubic.p[i] = (Point{} + segment.bezier[i]) - fromOrigin;
        whitened.p[i] = whiten(cubic.p[i]);
    }
    const int pieces = pieceCount(whitened, piecesFor(detail));
    double sum = 0;
    Point a = cubic.p[0];
    for (int k = 1; k <= pieces; ++k) {
        const Point b = k == pieces ? cubic.p[3] : cubic.at(double(k) / pieces);
        const Point wa = whiten(a), wb = whiten(b);
        const double whitenedLength = length(wb - wa);
        if (whitenedLength > 0) // The length counts on the canvas, while the exponent counts in spreads.
            sum += lineIntegral(wa, wb) * length(b - a) / whitenedLength;
        a = b;
    }
    return double(segment.density) * whiten.norm() * sum;
}

bool reaches(const Segment &segment, double spread, Point fromOrigin)
{
    const double reach = reachInSpreads * spread * std::sqrt(std::max(1.0f, segment.anisotropyRatio));
    const auto &p = segment.bezier;
    const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x, p[3].x});
    const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y, p[3].y});
    return fromOrigin.x >= left - reach && fromOrigin.x <= right + reach && fromOrigin.y >= top - reach &&
           fromOrigin.y <= bottom + reach;
}

double segmentDensityAt(const Stroke &stroke, const Segment &segment, Microseconds time, Point point)
{
    const double s = segment.spread(time);
    const Point at = point - stroke.origin;
    if (!(segment.age(time) > 0) || !(s > 0) || !reaches(segment, s, at))
        return 0;
    return segmentDensity(segment, s, at, CurveDetail::Fine);
}

double strokeDensityAt(const Stroke &stroke, Microseconds time, Point point)
{
    double density = 0;
    for (const Segment &segment : stroke.segments)
        density += (segment.lift ? -1 : 1) * segmentDensityAt(stroke, segment, time, point);
    return std::max(0.0, density);
}

} // namespace suffuse
