#include "app/tools/seen_paint.h"

#include "app/panels/density_function.h"
#include "model/painting/influence.h"

#include <numbers>

namespace suffuse {

namespace {

constexpr double flatness = 0.03; ///< of the spread, between the curve and its pieces
constexpr int maxPieces = 64;

/// To where the segment's Gaussian is e^(−|x|²): lengths in spreads.
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
    /// Of the Gaussian's integral over the plane.
    double norm() const { return m_along * m_across / std::numbers::pi; }

private:
    double m_cos, m_sin, m_along, m_across;
};

/// Pieces of equal parameter that stay within `flatness` of the whitened curve.
int pieceCount(const Cubic &c)
{
    const Point a = c.p[0] - 2 * c.p[1] + c.p[2], b = c.p[1] - 2 * c.p[2] + c.p[3];
    const double bend = 6 * std::max(length(a), length(b));
    return std::clamp(int(std::ceil(std::sqrt(bend / (8 * flatness)))), 1, maxPieces);
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

double densityAt(const Segment &segment, double spread, Point fromOrigin)
{
    const Whitening whiten(segment, spread);
    Cubic cubic, whitened;
    for (std::size_t i = 0; i < 4; ++i) {
        cubic.p[i] = (Point{} + segment.bezier[i]) - fromOrigin;
        whitened.p[i] = whiten(cubic.p[i]);
    }
    const int pieces = pieceCount(whitened);
    double sum = 0;
    Point a = cubic.p[0];
    for (int k = 1; k <= pieces; ++k) {
        const Point b = k == pieces ? cubic.p[3] : cubic.at(double(k) / pieces);
        const Point wa = whiten(a), wb = whiten(b);
        const double whitenedLength = length(wb - wa);
        if (whitenedLength > 0) // dl on the canvas, the exponent in spreads
            sum += lineIntegral(wa, wb) * length(b - a) / whitenedLength;
        a = b;
    }
    return double(segment.density) * whiten.norm() * sum;
}

/// Whether the segment's influence reaches the point; the same box as influenceOf, without the way over the canvas.
bool reaches(const Segment &segment, double spread, Point fromOrigin)
{
    const double reach = reachInSpreads * spread * std::sqrt(std::max(1.0f, segment.anisotropyRatio));
    const auto &p = segment.bezier;
    const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x, p[3].x});
    const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y, p[3].y});
    return fromOrigin.x >= left - reach && fromOrigin.x <= right + reach && fromOrigin.y >= top - reach &&
           fromOrigin.y <= bottom + reach;
}

} // namespace

SeenPaint seenPaint(const Stroke &stroke, Microseconds T, Point point)
{
    const Point at = point - stroke.origin;
    SeenPaint seen;
    std::vector<std::pair<const Segment *, double>> here;
    double total = 0, largest = 0;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const Segment &segment = stroke.segments[k];
        const double spread = segment.spread(T);
        if (!(spread > 0) || !reaches(segment, spread, at))
            continue;
        const double density = densityAt(segment, spread, at);
        here.emplace_back(&segment, density);
        total += density;
        if (density > largest) {
            largest = density;
            seen.segment = int(k);
        }
    }
    if (!(total > 0))
        return {};
    double function = 0, opacity = 0;
    for (const auto &[segment, density] : here) {
        const double share = density / total;
        function += share * densityFunction(stroke.styleOf(*segment), total);
        opacity += share * double(segment->colour.opacity);
    }
    seen.opacity = function * opacity;
    return seen;
}

} // namespace suffuse
