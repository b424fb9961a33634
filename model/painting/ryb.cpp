#include "model/painting/ryb.h"

#include <algorithm>

namespace suffuse {

namespace {

using Triple = std::array<double, 3>;

double greatest(const Triple &c)
{
    return std::max({c[0], c[1], c[2]});
}

/// Converts in either direction: it takes white out, turns the hue, keeps the greatest value, and puts black in.
template <typename Turn>
Triple convert(const Triple &c, Turn turn)
{
    const double white = std::min({c[0], c[1], c[2]});
    const double black = std::min({1 - c[0], 1 - c[1], 1 - c[2]});
    const Triple pure{c[0] - white, c[1] - white, c[2] - white};
    Triple turned = turn(pure);
    const double before = greatest(pure), after = greatest(turned);
    const double scale = after > 0 ? before / after : 1;
    for (double &v : turned)
        v = std::clamp(v * scale + black, 0.0, 1.0);
    return turned;
}

} // namespace

std::array<double, 3> rybFromSrgb(const std::array<double, 3> &rgb)
{
    return convert(rgb, [](const Triple &c) {
        const double m = std::min(c[0], c[1]);
        return Triple{c[0] - m, (c[1] + m) / 2, (c[2] + c[1] - m) / 2};
    });
}

std::array<double, 3> srgbFromRyb(const std::array<double, 3> &ryb)
{
    return convert(ryb, [](const Triple &c) {
        const double m = std::min(c[1], c[2]);
        return Triple{c[0] + c[1] - m, c[1] + m, 2 * (c[2] - m)};
    });
}

Colour rybFromSrgb(double red, double green, double blue, double opacity)
{
    const auto unit = [](double v) { return std::clamp(v, 0.0, 1.0); };
    const Triple c = rybFromSrgb(Triple{unit(red), unit(green), unit(blue)});
    return {float(c[0]), float(c[1]), float(c[2]), float(unit(opacity))};
}

std::array<double, 3> srgbFromRyb(const Colour &colour)
{
    return srgbFromRyb(Triple{double(colour.red), double(colour.yellow), double(colour.blue)});
}

} // namespace suffuse
