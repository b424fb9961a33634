#include "model/colour/colour_shift.h"

#include "model/colour/hue_shares.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr double leastChroma = 1e-4; ///< less than a tenth of a step of 8-bit channels: no hue can be seen

/// The middle between the greatest and the least channel, as in HSL.
double lightnessOf(const HueShares &s)
{
    return 1 - s.black - 0.5 * s.chroma;
}

/// How colourful a colour of this lightness can be.
double mostChroma(double lightness)
{
    return 1 - std::abs(2 * lightness - 1);
}

double movedLightness(double lightness, double by)
{
    return by >= 0 ? lightness + (1 - lightness) * by : lightness * (1 + by);
}

} // namespace

bool isGrey(const Colour &colour)
{
    return toShares(colour, 0).chroma < leastChroma;
}

Colour shifted(const Colour &colour, const ColourShift &shift)
{
    if (shift == ColourShift{})
        return colour;
    HueShares s = toShares(colour, 0);
    // Mixing white or black in dilutes the hue, so that tints and shades stay what they are.
    const double lightness = movedLightness(lightnessOf(s), std::clamp(shift.lightness, -1.0, 1.0));
    const double diluted = s.chroma * (1 - std::min(std::abs(shift.lightness), 1.0));
    s.chroma = std::min(diluted * std::max(shift.saturation, 0.0), mostChroma(lightness));
    s.black = std::clamp(1 - lightness - 0.5 * s.chroma, 0.0, 1.0);
    s.hue += shift.hue;
    return fromShares(s, colour.opacity);
}

ColourShift shiftBetween(const Colour &from, const Colour &to)
{
    const HueShares a = toShares(from, 0), b = toShares(to, a.hue);
    const double dark = lightnessOf(a), light = lightnessOf(b);
    ColourShift shift;
    if (light > dark)
        shift.lightness = dark < 1 ? (light - dark) / (1 - dark) : 0;
    else
        shift.lightness = dark > 0 ? light / dark - 1 : 0;
    const double diluted = a.chroma * (1 - std::abs(shift.lightness));
    if (a.chroma < leastChroma || diluted <= 0)
        return shift;
    shift.saturation = b.chroma / diluted;
    if (b.chroma >= leastChroma)
        shift.hue = b.hue - a.hue - std::round(b.hue - a.hue);
    return shift;
}

} // namespace suffuse
