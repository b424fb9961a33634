#include "render/reference/colour.h"

#include <algorithm>

namespace suffuse::reference {

namespace {

double least(const std::array<double, 3> &v)
{
    return std::min({v[0], v[1], v[2]});
}

double greatest(const std::array<double, 3> &v)
{
    return std::max({v[0], v[1], v[2]});
}

/// Divides `to` by max(to)/max(from), 1 where that is 0/0, and adds `offset`.
std::array<double, 3> rescaled(const std::array<double, 3> &to, const std::array<double, 3> &from, double offset)
{
    const double n = greatest(from) > 0 && greatest(to) > 0 ? greatest(to) / greatest(from) : 1;
    return {to[0] / n + offset, to[1] / n + offset, to[2] / n + offset};
}

} // namespace

Ryb rybOfRgb(const Rgb &rgb)
{
    const double white = least(rgb);
    const double black = least({1 - rgb[0], 1 - rgb[1], 1 - rgb[2]});
    const double r = rgb[0] - white, g = rgb[1] - white, b = rgb[2] - white;
    const double m = std::min(r, g);
    return rescaled({r - m, (g + m) / 2, (b + g - m) / 2}, {r, g, b}, black);
}

Rgb rgbOfRyb(const Ryb &ryb)
{
    const double white = least(ryb);
    const double black = least({1 - ryb[0], 1 - ryb[1], 1 - ryb[2]});
    const double r = ryb[0] - white, y = ryb[1] - white, b = ryb[2] - white;
    const double m = std::min(y, b);
    return rescaled({r + y - m, y + m, 2 * (b - m)}, {r, y, b}, black);
}

Spot bareSpot(const Colour &background, bool transparent)
{
    if (transparent)
        return {};
    const double opacity = background.opacity; // White is 0 in RYB, so "over white" is a product.
    return {{opacity * background.red, opacity * background.yellow, opacity * background.blue}, 1};
}

void mix(Spot &spot, const Mix &how, const Paint &paint)
{
    const double w = paint.opacity;
    for (std::size_t i = 0; i < 3; ++i) {
        if (how.mode == MixMode::Alpha)
            spot.colour[i] = w * paint.colour[i] + (1 - w) * spot.colour[i];
        else
            spot.colour[i] = std::min(1.0, w * paint.colour[i] + (1 - w * (1 - double(how.beta))) * spot.colour[i]);
    }
    spot.coverage = w + (1 - w) * spot.coverage;
}

std::array<double, 4> storedColour(const Spot &spot, bool transparent)
{
    const Rgb rgb = rgbOfRyb(spot.colour);
    std::array<double, 4> stored{0, 0, 0, transparent ? std::clamp(spot.coverage, 0.0, 1.0) : 1};
    for (std::size_t i = 0; i < 3; ++i) {
        if (!transparent)
            stored[i] = std::clamp(rgb[i], 0.0, 1.0);
        else if (stored[3] > 0)
            stored[i] = std::clamp((rgb[i] - (1 - stored[3])) / stored[3], 0.0, 1.0);
    }
    return stored;
}

} // namespace suffuse::reference
