#include "model/colour/perceived.h"

#include "model/painting/ryb.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

/// Light of an sRGB-encoded channel.
double linearLight(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

} // namespace

Perceived perceivedOf(const Colour &colour)
{
    const std::array<double, 3> rgb = srgbFromRyb(colour);
    const double r = linearLight(rgb[0]), g = linearLight(rgb[1]), b = linearLight(rgb[2]);
    // Björn Ottosson, "A perceptual color space for image processing" (2020).
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

double distanceOf(const Perceived &a, const Perceived &b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

bool looksLike(const Perceived &a, const Perceived &b)
{
    constexpr double apart = 0.06; // three times what is just seen side by side
    return distanceOf(a, b) < apart;
}

ColourPalette::ColourPalette(std::vector<Colour> colours) : m_colours(std::move(colours))
{
    for (const Colour &colour : m_colours)
        m_perceived.push_back(perceivedOf(colour));
}

const Colour &ColourPalette::nearest(const Colour &colour) const
{
    const Perceived wanted = perceivedOf(colour);
    const auto far = [&](const Perceived &each) { return distanceOf(each, wanted); };
    return m_colours[std::size_t(std::ranges::min_element(m_perceived, {}, far) - m_perceived.begin())];
}

} // namespace suffuse
