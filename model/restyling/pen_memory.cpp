#include "model/restyling/pen_memory.h"

#include "model/brush/brush_dynamics.h"
#include "model/brush/stroke_fit.h"
#include "model/paint/half_width.h"

#include <array>
#include <cmath>

namespace suffuse {

namespace {

/// Quantities in which pressure shows.
constexpr std::array heard{BrushQuantity::Size, BrushQuantity::Density, BrushQuantity::Opacity};
using Heard = std::array<double, heard.size()>;

constexpr int pressureSteps = 256; ///< in which pressures are looked for
constexpr double leastShare = 1e-3;
/// Speeds are averages over so many segments on either side.
constexpr std::size_t speedReach = 2;

/// Where the segments lie along the stroke and how fast it went there; the pressure is still to be found.
std::vector<RememberedPen> placesAlong(const Stroke &stroke)
{
    const std::size_t n = stroke.segments.size();
    std::vector<RememberedPen> pens(n);
    std::vector<double> starts(n + 1, 0);
    for (std::size_t k = 0; k < n; ++k)
        starts[k + 1] = starts[k] + arcLength(stroke.cubicOf(stroke.segments[k]));
    for (std::size_t k = 0; k < n; ++k) {
        RememberedPen &pen = pens[k];
        pen.distance = 0.5 * (starts[k] + starts[k + 1]);
        pen.rest = starts[n] - pen.distance;
        const std::size_t from = k < speedReach ? 0 : k - speedReach, to = std::min(k + speedReach + 1, n - 1);
        const double seconds = toSeconds(stroke.segments[to].born - stroke.segments[from].born);
        if (seconds > 0)
            pen.speed = (starts[to] - starts[from]) / seconds;
    }
    return pens;
}

/// What a segment lays down, as a long line would.
Heard laidBy(const Stroke &stroke, const Segment &segment)
{
    const Point along = tangentAt(stroke.cubicOf(segment), 0.5);
    const double spread = spreadAt(diffusionAcross(segment, along), segment.maxAge);
    return {std::sqrt(double(segment.diffusion)), peakDensity(segment.density, spread), segment.colour.opacity};
}

/// By what speed, distance and tapering have multiplied what a brush lays down.
Heard knownShares(const Brush &brush, const RememberedPen &pen, double spread, double length)
{
    Heard shares;
    shares.fill(1);
    for (std::size_t q = 0; q < heard.size(); ++q) {
        if (const ResponseCurve *curve = brush.curve(heard[q], BrushInput::Speed))
            shares[q] *= curve->at(pen.speed / spread / double(brush.fullSpeed));
        if (const ResponseCurve *curve = brush.curve(heard[q], BrushInput::Distance))
            shares[q] *= curve->at(pen.distance / spread / double(brush.fullDistance));
    }
    Taper taper = brush.taper;
    taper.tip = float(std::lerp(1.0, double(taper.tip), std::min(1.0, 0.5 * length / spread))); // as the builder does
    shares[0] *= taperAt(taper, pen.distance / spread, pen.rest / spread);
    return shares;
}

/// What each segment lays down, after all that is known beside the pressure is taken off.
std::vector<Heard> laidAlong(const Stroke &stroke, const Brush *painted, const std::vector<RememberedPen> &pens)
{
    std::vector<Heard> laid;
    double widest = 0, largest = 0;
    for (const Segment &segment : stroke.segments) {
        laid.push_back(laidBy(stroke, segment));
        if (!segment.takesPaint()) {
            widest = std::max(widest, spreadAt(segment.diffusion, segment.maxAge));
            largest = std::max(largest, laid.back()[0]);
        }
    }
    const double length = pens.back().distance + pens.back().rest;
    const double raise = length > 0 ? shortStrokeRaise(length, widest) : 1;
    const double spread = painted ? painted->spread() * largest / std::sqrt(double(painted->diffusion)) : 0;
    for (std::size_t k = 0; k < laid.size(); ++k) {
        laid[k][1] /= raise;
        if (!painted || !(spread > 0))
            continue;
        const Heard shares = knownShares(*painted, pens[k], spread, length);
        for (std::size_t q = 0; q < heard.size(); ++q)
            laid[k][q] /= std::max(shares[q], leastShare);
    }
    return laid;
}

/// Finds the pressure at which a brush's curves give certain shares of their greatest values.
class PressureSearch {
public:
    explicit PressureSearch(const Brush &brush)
    {
        for (std::size_t q = 0; q < heard.size(); ++q) {
            const ResponseCurve *curve = brush.curve(heard[q], BrushInput::Pressure);
            std::vector<double> values;
            double greatest = 0;
            for (int i = 0; curve && i <= pressureSteps; ++i) {
                values.push_back(curve->at(double(i) / pressureSteps));
                greatest = std::max(greatest, values.back());
            }
            if (!(greatest > 0))
                continue;
            for (double &value : values)
                value = logOf(value / greatest);
            m_curves.emplace_back(q, std::move(values));
        }
    }
    /// Whether the brush listens to pressure.
    bool hears() const { return !m_curves.empty(); }

    double pressureOf(const Heard &shares) const
    {
        int best = pressureSteps;
        double least = std::numeric_limits<double>::infinity();
        for (int i = pressureSteps; i >= 0; --i) {
            double error = 0;
            for (const auto &[q, values] : m_curves) {
                const double difference = values[std::size_t(i)] - logOf(shares[q]);
                error += difference * difference;
            }
            if (error < least) {
                least = error;
                best = i;
            }
        }
        return double(best) / pressureSteps;
    }

private:
    static double logOf(double share) { return std::log(std::clamp(share, leastShare, 1.0)); }

    std::vector<std::pair<std::size_t, std::vector<double>>> m_curves; ///< quantity, logarithms of its shares
};

} // namespace

void StrongestPaint::take(const Stroke &stroke, const Brush *painted)
{
    const std::vector<Heard> laid = laidAlong(stroke, painted, placesAlong(stroke));
    for (std::size_t k = 0; k < laid.size(); ++k) {
        if (stroke.segments[k].takesPaint())
            continue;
        size = std::max(size, laid[k][0]);
        peak = std::max(peak, laid[k][1]);
        opacity = std::max(opacity, laid[k][2]);
    }
}

std::vector<RememberedPen> penOf(const Stroke &stroke, const Brush *painted, const StrongestPaint &strongest)
{
    std::vector<RememberedPen> pens = placesAlong(stroke);
    const std::optional<PressureSearch> search = painted ? std::optional<PressureSearch>(*painted) : std::nullopt;
    const bool hears = search && search->hears();
    const std::vector<Heard> laid = laidAlong(stroke, hears ? painted : nullptr, pens);
    const auto share = [](double value, double greatest) { return greatest > 0 ? value / greatest : 1; };
    for (std::size_t k = 0; k < pens.size(); ++k) {
        const Heard shares{share(laid[k][0], strongest.size), share(laid[k][1], strongest.peak),
                           share(laid[k][2], strongest.opacity)};
        pens[k].pressure = hears ? search->pressureOf(shares) : std::clamp(shares[0] * shares[1], 0.0, 1.0);
    }
    return pens;
}

} // namespace suffuse
