#include "model/colour/hue_shares.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

Colour pureHue(double hue)
{
    const double h = 6 * (hue - std::floor(hue));
    const auto channel = [h](double centre) {
        double d = std::abs(h - centre);
        d = std::min(d, 6 - d);
        return float(std::clamp(2 - d, 0.0, 1.0));
    };
    return {channel(0), channel(2), channel(4), 1};
}

HueShares toShares(const Colour &colour, double hueOfGrey)
{
    const double r = colour.red, y = colour.yellow, b = colour.blue;
    const double high = std::max({r, y, b}), low = std::min({r, y, b});
    HueShares shares{hueOfGrey, high - low, low};
    if (shares.chroma < 1e-6)
        return shares;
    double h = 0;
    if (high == r)
        h = (y - b) / shares.chroma;
    else if (high == y)
        h = 2 + (b - r) / shares.chroma;
    else
        h = 4 + (r - y) / shares.chroma;
    shares.hue = h < 0 ? h / 6 + 1 : h / 6;
    return shares;
}

Colour fromShares(const HueShares &shares, float opacity)
{
    const Colour pure = pureHue(shares.hue);
    const auto channel = [&shares](float p) { return float(std::clamp(shares.chroma * p + shares.black, 0.0, 1.0)); };
    return {channel(pure.red), channel(pure.yellow), channel(pure.blue), opacity};
}

} // namespace suffuse
