#include "model/paint/half_width.h"

#include "model/brush/stroke_fit.h"

#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

using std::numbers::e;
using std::numbers::pi;

/// Beyond so many spreads φˢ would grow faster than anybody wants.
constexpr double mostSpreads = 2;
/// In spreads: nothing is seen farther away from a curve, where the density is e^(−36) of its peak.
constexpr double farthestSpreads = 6;
/// The number of places of a curve, besides its start, at which its width is computed.
constexpr int widthPlaces = 8;

/// Where the dry paint of a segment is seen, in a stroke of a given length.
class SeenPaintOf {
public:
    SeenPaintOf(const Segment &segment, const Style &style, double strokeLength)
        : m_segment(segment), m_age(segment.age(segment.driesAt())), m_cut(visibleCut(style)), m_length(strokeLength)
    {}

    /// How far beside a curve along `tangent` paint is seen.
    double beside(Point tangent) const
    {
        const double density = double(m_segment.density) * share(-m_length / 2, spreadAlong(tangent));
        return m_cut > 0 ? halfWidth(diffusionAcross(m_segment, tangent), density, m_age, m_cut) : 0;
    }

    /// How far beyond the end of a curve along `tangent` paint is seen.
    double beyond(Point tangent) const
    {
        const double s = spreadAlong(tangent);
        const double needed =
            m_cut * std::sqrt(4 * pi * diffusionAcross(m_segment, tangent) * m_age) / double(m_segment.density);
        if (!(m_cut > 0 && share(0, s) > needed))
            return 0;
        double low = 0, high = farthestSpreads * s;
        for (int k = 0; k < 50; ++k) {
            const double middle = 0.5 * (low + high);
            (share(middle, s) > needed ? low : high) = middle;
        }
        return low;
    }

private:
    double spreadAlong(Point tangent) const
    {
        return std::sqrt(4 * diffusionAcross(m_segment, {-tangent.y, tangent.x}) * m_age);
    }
    /// The share of an endless line's density that is left so far beyond the end of the stroke; in its middle that is
    /// −length / 2.
    double share(double beyond, double s) const
    {
        return 0.5 * (std::erf((beyond + m_length) / s) - std::erf(beyond / s));
    }

    const Segment &m_segment;
    double m_age, m_cut, m_length;
};

} // namespace

double spreadAt(double diffusion, double age)
{
    return std::sqrt(4 * diffusion * age);
}

double peakDensity(double density, double spread)
{
    return density / (std::sqrt(pi) * spread);
}

double densityOfPeak(double peak, double spread)
{
    return peak * std::sqrt(pi) * spread;
}

Point tangentAt(const Cubic &cubic, double t)
{
    for (const Point d : {cubic.derivative(t), cubic.derivative(0.5), cubic.p[3] - cubic.p[0]})
        if (const double l = length(d); l > 0)
            return (1 / l) * d;
    return {1, 0};
}

double diffusionAcross(const Segment &segment, Point tangent)
{
    const double D = segment.diffusion;
    if (segment.isIsotropic())
        return D;
    const Point axis{std::cos(double(segment.anisotropyAngle)), std::sin(double(segment.anisotropyAngle))};
    const double along = dot(axis, tangent), across = cross(axis, tangent);
    const double square = along * along + across * across;
    return D * (double(segment.anisotropyRatio) * across * across + along * along) / square;
}

double halfWidth(double diffusion, double density, double age, double cut)
{
    const double s = std::sqrt(4 * diffusion * std::max(age, 0.0));
    const double excess = density / (cut * std::sqrt(pi) * s);
    return s > 0 && excess > 1 ? s * std::sqrt(std::log(excess)) : 0;
}

Rect seenBox(const Stroke &stroke)
{
    double total = 0;
    for (const Segment &segment : stroke.segments)
        total += segment.takesPaint() ? 0 : arcLength(stroke.cubicOf(segment));
    Rect box;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const Segment &segment = stroke.segments[k];
        if (segment.takesPaint())
            continue;
        const Cubic cubic = stroke.cubicOf(segment);
        const SeenPaintOf seen(segment, stroke.styleOf(segment), total);
        for (int place = 0; place <= widthPlaces; ++place) {
            const double t = double(place) / widthPlaces;
            const Point at = cubic.at(t), tangent = tangentAt(cubic, t);
            const Point aside = seen.beside(tangent) * Point{-tangent.y, tangent.x};
            box.include(at + aside);
            box.include(at - aside);
        }
        if (stroke.beginsChain(k))
            box.include(cubic.p[0] - seen.beyond(tangentAt(cubic, 0)) * tangentAt(cubic, 0));
        if (k + 1 == stroke.segments.size() || stroke.beginsChain(k + 1))
            box.include(cubic.p[3] + seen.beyond(tangentAt(cubic, 1)) * tangentAt(cubic, 1));
    }
    return box;
}

double greatestHalfWidth(double density, double cut)
{
    return density / (cut * std::sqrt(2 * pi * e));
}

double fadingAge(double diffusion, double density, double cut)
{
    return density * density / (4 * pi * diffusion * cut * cut);
}

WidthValues valuesForHalfWidth(double halfWidth, double diffusion, double age, double cut)
{
    double s = std::sqrt(4 * diffusion * age);
    if (halfWidth > mostSpreads * s) {
        s = halfWidth / mostSpreads;
        diffusion = s * s / (4 * age);
    }
    const double spreads = halfWidth / s;
    return {diffusion, cut * std::sqrt(pi) * s * std::exp(spreads * spreads)};
}

double diffusionForHalfWidth(double halfWidth, double density, double age, double cut)
{
    // With s = s₀e^(−u), s₀ = φˢ/(ξ√π): w² = s₀² u e^(−2u), and t < t*/e is u > ½, the lower branch.
    const double s0 = density / (cut * std::sqrt(pi));
    const double share = halfWidth / s0;
    const double w = lowerLambertW(std::max(-2 * share * share, -1 / e));
    const double s = s0 * std::exp(w / 2);
    return s * s / (4 * age);
}

double lowerLambertW(double x)
{
    const double fromBranch = 1 + e * x;
    if (fromBranch <= 0)
        return -1;
    double y;
    if (fromBranch < 0.2) { // Near the branch point its series is used.
        const double p = std::sqrt(2 * fromBranch);
        y = -1 - p - p * p / 3 - 11 * p * p * p / 72;
    } else {
        const double l = std::log(-x);
        y = l - std::log(-l);
    }
    for (int i = 0; i < 40; ++i) { // These are Halley's steps on y·e^y = x.
        const double ey = std::exp(y), f = y * ey - x;
        const double step = f / (ey * (y + 1) - (y + 2) * f / (2 * y + 2));
        if (!std::isfinite(step))
            break;
        y -= step;
        if (std::abs(step) <= 1e-15 * std::abs(y))
            break;
    }
    return std::min(y, -1.0);
}

} // namespace suffuse
