#include "model/restyling/vary.h"

#include "model/area/outline.h"
#include "model/brush/random_values.h"
#include "model/brush/stroke_fit.h"
#include "model/painting/validate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

/// Channels of random values.
enum Varies { VariesDiffusion, VariesDensity, VariesAge, VariesGrain, VariesHue, VariesLightness, VariesOpacity };

/// A random value in [−1, 1] for a channel at a place of a stroke.
class Strays {
public:
    Strays(const VaryAmounts &amounts, StrokeId stroke)
        : m_amounts(amounts), m_seed(stroke * 0x9E3779B97F4A7C15u + amounts.seed)
    {}
    void goTo(std::size_t segment, double distance)
    {
        m_segment = segment;
        m_distance = distance;
    }
    double of(Varies channel) const { return 2 * value(channel) - 1; }
    /// A factor between 1/(1 + amount) and 1 + amount.
    double factor(Varies channel, double amount) const { return std::pow(1 + amount, of(channel)); }

private:
    double value(Varies channel) const
    {
        switch (m_amounts.per) {
        case VaryAmounts::EachStroke:
            return strokeRandom(m_seed, channel);
        case VaryAmounts::EachSegment:
            return randomAt(m_seed, channel, std::int64_t(m_segment));
        case VaryAmounts::Along:
            break;
        }
        return driftAt(m_seed, channel, m_distance / m_amounts.length);
    }

    const VaryAmounts &m_amounts;
    std::uint64_t m_seed;
    std::size_t m_segment = 0;
    double m_distance = 0;
};

float inShare(double value)
{
    return float(std::clamp(value, 0.0, 1.0));
}

Segment variedSegment(const Segment &segment, const VaryAmounts &amounts, const Strays &strays)
{
    Segment result = segment;
    const auto multiply = [&](float &value, Varies channel, double amount) {
        if (amount > 0)
            value = float(double(value) * strays.factor(channel, amount));
    };
    multiply(result.diffusion, VariesDiffusion, amounts.diffusion);
    multiply(result.density, VariesDensity, amounts.density);
    multiply(result.maxAge, VariesAge, amounts.maxAge);
    const auto add = [&](float &value, Varies channel, double amount) {
        if (amount > 0)
            value = inShare(double(value) + amount * strays.of(channel));
    };
    add(result.granulation, VariesGrain, amounts.granulation);
    if (amounts.hue > 0)
        result.colour = withHueTurned(result.colour, amounts.hue * strays.of(VariesHue));
    for (float Colour::*channel : {&Colour::red, &Colour::yellow, &Colour::blue})
        add(result.colour.*channel, VariesLightness, amounts.lightness);
    add(result.colour.opacity, VariesOpacity, amounts.opacity);
    return problemOf(result).isEmpty() ? result : segment;
}

Fill variedFill(const Fill &fill, const VaryAmounts &amounts, Strays &strays)
{
    Segment like;
    like.diffusion = fill.diffusion > 0 ? fill.diffusion : 1; // A crisp edge has no D, and stays crisp.
    like.density = fill.density;
    like.granulation = fill.granulation;
    like.maxAge = fill.maxAge;
    like.colour = fill.colour;
    const Segment varied = variedSegment(like, amounts, strays);
    Fill result = fill;
    if (fill.diffusion > 0)
        result.diffusion = varied.diffusion;
    result.density = varied.density;
    result.granulation = varied.granulation;
    result.maxAge = varied.maxAge;
    result.colour = varied.colour;
    if (fill.gradient) {
        like.colour = fill.gradient->colour;
        result.gradient->colour = variedSegment(like, amounts, strays).colour;
    }
    return result;
}

} // namespace

Colour withHueTurned(const Colour &colour, double radians)
{
    // Rodrigues' rotation about (1, 1, 1)/√3: what is grey stays, and so does the sum of the three.
    const double r = double(colour.red), y = double(colour.yellow), b = double(colour.blue);
    const double mean = (r + y + b) / 3, c = std::cos(radians), s = std::sin(radians) / std::numbers::sqrt3;
    const auto turned = [&](double own, double before, double after) {
        return inShare(mean + (own - mean) * c + (before - after) * s);
    };
    return {turned(r, b, y), turned(y, r, b), turned(b, y, r), colour.opacity};
}

Stroke varied(const Stroke &stroke, const VaryAmounts &amounts, const std::vector<bool> &chosen)
{
    Stroke result = stroke;
    Strays strays(amounts, stroke.id);
    double distance = 0;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const Segment &segment = stroke.segments[k];
        const double arc = arcLength(stroke.cubicOf(segment));
        strays.goTo(k, distance + 0.5 * arc);
        distance += arc;
        if ((chosen.empty() || chosen[k]) && !segment.takesPaint())
            result.segments[k] = variedSegment(segment, amounts, strays);
    }
    bool meansFill = bool(stroke.fill);
    for (std::size_t k = 0; k < stroke.segments.size(); ++k)
        meansFill = meansFill && (chosen.empty() || !chosen[k] || onlyBounds(stroke, k));
    if (meansFill) { // It strays as a segment does in its place.
        strays.goTo(stroke.segments.size(), 0.5 * distance);
        result.fill = variedFill(*stroke.fill, amounts, strays);
    }
    return problemOf(result).isEmpty() ? result : stroke;
}

} // namespace suffuse
