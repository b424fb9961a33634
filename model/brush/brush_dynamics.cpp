#include "model/brush/brush_dynamics.h"

#include "model/brush/random_values.h"

namespace suffuse {

namespace {

/// The channels of random values are the quantities, then those of the jitter.
constexpr int jitterChannel = 16;

double inputOf(const Brush &brush, const BrushDynamic &dynamic, const PenState &pen, std::uint64_t seed)
{
    switch (dynamic.input) {
    case BrushInput::Pressure:
        return pen.pressure;
    case BrushInput::Tilt:
        return pen.tilt;
    case BrushInput::Speed:
        return pen.speed / double(brush.fullSpeed);
    case BrushInput::Distance:
        return pen.distance / double(brush.fullDistance);
    case BrushInput::StrokeRandom:
        return strokeRandom(seed, int(dynamic.quantity));
    case BrushInput::Drift:
        return driftAt(seed, int(dynamic.quantity), pen.distance / double(brush.driftLength));
    }
    return 1;
}

Colour mixed(const Colour &a, const Colour &b, double share)
{
    const auto channel = [share](float from, float to) { return float(from + share * (double(to) - double(from))); };
    return {channel(a.red, b.red), channel(a.yellow, b.yellow), channel(a.blue, b.blue), channel(a.opacity, b.opacity)};
}

Colour jittered(const Brush &brush, Colour colour, double distance, std::uint64_t seed)
{
    const ColourJitter &j = brush.jitter;
    if (j == ColourJitter{})
        return colour;
    const auto stray = [&](int i, float amount) {
        const int channel = jitterChannel + i;
        const double value =
            j.along ? driftAt(seed, channel, distance / double(brush.driftLength)) : strokeRandom(seed, channel);
        return double(amount) * (2 * value - 1);
    };
    const double lightness = -stray(3, j.lightness);
    const auto moved = [=](float value, double by) {
        return float(std::clamp(double(value) + by + lightness, 0.0, 1.0));
    };
    colour.red = moved(colour.red, stray(0, j.red));
    colour.yellow = moved(colour.yellow, stray(1, j.yellow));
    colour.blue = moved(colour.blue, stray(2, j.blue));
    return colour;
}

} // namespace

Paint paintAt(const Brush &brush, const PenState &pen, std::uint64_t seed)
{
    std::array<double, brushQuantities> share;
    share.fill(1);
    bool mixes = false;
    for (const BrushDynamic &d : brush.dynamics) {
        share[std::size_t(d.quantity)] *= d.curve.at(inputOf(brush, d, pen, seed));
        mixes = mixes || d.quantity == BrushQuantity::ColourMix;
    }
    const auto of = [&share](BrushQuantity quantity) { return share[std::size_t(quantity)]; };
    Paint paint;
    paint.size = std::max(leastSize, of(BrushQuantity::Size));
    paint.peak = double(brush.peak) * of(BrushQuantity::Density);
    paint.granulation = double(brush.granulation) * of(BrushQuantity::Granulation);
    paint.maxAge = double(brush.maxAge) * std::max(leastAge, of(BrushQuantity::MaxAge));
    paint.colour = mixes ? mixed(brush.colour, brush.secondColour, of(BrushQuantity::ColourMix)) : brush.colour;
    paint.colour = jittered(brush, paint.colour, pen.distance, seed);
    paint.colour.opacity = float(double(paint.colour.opacity) * of(BrushQuantity::Opacity));
    return paint;
}

double taperAt(const Taper &taper, double distance, double rest)
{
    double share = 1;
    if (distance < double(taper.in))
        share = distance / double(taper.in);
    if (rest < double(taper.out))
        share = std::min(share, rest / double(taper.out));
    share = std::max(share, 0.0);
    return std::max(leastSize, double(taper.tip) + (1 - double(taper.tip)) * share * (2 - share));
}

double spreadOf(const Brush &brush, double size, double maxAge)
{
    return 2 * size * std::sqrt(double(brush.diffusion) * maxAge);
}

double tipAngle(const TipShape &tip, Point direction)
{
    return double(tip.angle) + (tip.followsPath ? std::atan2(direction.y, direction.x) : 0);
}

double spreadAcross(const TipShape &tip, double spread, Point direction)
{
    if (tip.ratio == 1)
        return spread;
    // √(nᵀ(ratio·aaᵀ + bbᵀ)n) of the path's normal n, a along the tip's angle, b across.
    const double angle = tipAngle(tip, direction), l = length(direction);
    const Point along{std::cos(angle), std::sin(angle)};
    const double c = l > 0 ? cross(direction, along) / l : 1;
    return spread * std::sqrt(1 + (double(tip.ratio) - 1) * c * c);
}

} // namespace suffuse
