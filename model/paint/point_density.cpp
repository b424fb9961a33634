#include "model/paint/point_density.h"

#include "model/paint/fill_density.h"

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
        : m_along(1 / (spread * std::sqrt(double(segment.anisotropyRatio)))), m_across(1 / spread)
    {
        if (segment.anisotropyRatio != 1) { // A round Gaussian needs no turning, which saves the two functions.
            m_cos = std::cos(segment.anisotropyAngle);
            m_sin = std::sin(segment.anisotropyAngle);
        }
    }
    Point operator()(Point d) const
    {
        return {m_along * (m_cos * d.x + m_sin * d.y), m_across * (m_cos * d.y - m_sin * d.x)};
    }
    /// The reciprocal of the Gaussian's integral over the plane.
    double norm() const { return m_along * m_across / std::numbers::pi; }

private:
    double m_cos = 1, m_sin = 0, m_along, m_across;
};

/// The length, quicker than by std::hypot, which guards against overflow.
double stepLength(Point d)
{
    return std::sqrt(dot(d, d));
}

/// How many pieces of equal parameter stay near enough to the whitened curve.
int pieceCount(const Cubic &c, const Pieces &pieces)
{
    const Point a = c.p[0] - 2 * c.p[1] + c.p[2], b = c.p[1] - 2 * c.p[2] + c.p[3];
    const double bend = 6 * std::sqrt(std::max(dot(a, a), dot(b, b)));
    return int(std::clamp(std::ceil(std::sqrt(bend / (8 * pieces.flatness))), 1.0, double(pieces.most)));
}

/// Calls `use` with each straight piece of a segment's curve.
template <typename Use>
void forEachPiece(const Segment &segment, const Whitening &whiten, CurveDetail detail, Use use)
{
    const Cubic cubic = offsetsOf(segment);
    const Cubic whitened{{whiten(cubic.p[0]), whiten(cubic.p[1]), whiten(cubic.p[2]), whiten(cubic.p[3])}};
    const double scale = 0.5 * std::sqrt(std::numbers::pi) * double(segment.density) * whiten.norm();
    const int count = pieceCount(whitened, piecesFor(detail));
    Point a = cubic.p[0], wa = whitened.p[0];
    for (int k = 1; k <= count; ++k) {
        const Point b = k == count ? cubic.p[3] : cubic.at(double(k) / count), wb = whiten(b);
        const double whitenedLength = stepLength(wb - wa);
        if (whitenedLength > 0) // The length counts on the canvas, while the exponent counts in spreads.
            use(DensityOfSegment::Piece{wa, (1 / whitenedLength) * (wb - wa), whitenedLength,
                                        scale * stepLength(b - a) / whitenedLength});
        a = b;
        wa = wb;
    }
}

/// What a piece adds to the density at a point of the whitened plane.
double densityOf(const DensityOfSegment::Piece &piece, Point at)
{
    constexpr double farthest = 6; // e^(−x²) and 1 − erf(x) are below 1e-15 from here on, in spreads.
    constexpr double tiny = 1e-6;  // The difference of two error functions would have no digits left.
    const Point from = piece.start - at;
    const double u = dot(from, piece.along), v = cross(piece.along, from), end = u + piece.length;
    if (std::abs(v) > farthest || u > farthest || end < -farthest)
        return 0;
    const double along = piece.length < tiny ? 2 / std::sqrt(std::numbers::pi) * piece.length * std::exp(-u * u)
                                             : std::erf(end) - std::erf(u);
    return piece.weight * std::exp(-v * v) * along;
}

Rect influenceBox(const Segment &segment, double spread)
{
    const double reach = reachInSpreads * spread * std::sqrt(std::max(1.0f, segment.anisotropyRatio));
    return offsetsOf(segment).controlBox().grown(reach);
}

} // namespace

DensityOfSegment::DensityOfSegment(const Segment &segment, double spread, CurveDetail detail)
    : m_influence(influenceBox(segment, spread))
{
    const Whitening whiten(segment, spread);
    m_toWhite = {whiten({1, 0}), whiten({0, 1})};
    forEachPiece(segment, whiten, detail, [this](const Piece &piece) { m_pieces.push_back(piece); });
}

double DensityOfSegment::operator()(Point fromOrigin) const
{
    if (!reaches(fromOrigin))
        return 0;
    const Point at = fromOrigin.x * m_toWhite[0] + fromOrigin.y * m_toWhite[1];
    double sum = 0;
    for (const Piece &piece : m_pieces)
        sum += densityOf(piece, at);
    return sum;
}

double segmentDensity(const Segment &segment, double spread, Point fromOrigin, CurveDetail detail)
{
    const Whitening whiten(segment, spread);
    const Point at = whiten(fromOrigin);
    double sum = 0;
    forEachPiece(segment, whiten, detail,
                 [&sum, at](const DensityOfSegment::Piece &piece) { sum += densityOf(piece, at); });
    return sum;
}

bool reaches(const Segment &segment, double spread, Point fromOrigin)
{
    return influenceBox(segment, spread).contains(fromOrigin);
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
        if (!segment.fade)
            density += (segment.lift ? -1 : 1) * segmentDensityAt(stroke, segment, time, point);
    density += fillDensityAt(stroke, time, point);
    return std::max(0.0, density);
}

} // namespace suffuse
