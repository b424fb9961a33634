// Small pictures to fit.
#pragma once

#include "render/fitting/fitting.h"

#include <cmath>

namespace suffuse {

/// A target of `width` × `height` pixels; `value` gives R, G, B at the middle of a pixel, in [0, 1] across and down.
template <typename Value>
fitting::FitTarget targetOf(int width, int height, Value value)
{
    fitting::FitTarget target;
    target.picture = fitting::FitPicture(width, height, 3);
    target.canvasWidth = width, target.canvasHeight = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::array<double, 3> rgb = value((x + 0.5) / width, (y + 0.5) / height);
            for (std::size_t c = 0; c < 3; ++c)
                target.picture.at(x, y)[c] = float(rgb[c]);
        }
    return target;
}

/// A sky that darkens upwards, a hill, and a red sun with a soft rim.
inline fitting::FitTarget landscape(int width = 64, int height = 48)
{
    return targetOf(width, height, [](double x, double y) {
        const double sun = 1 / (1 + std::exp((std::hypot((x - 0.7) * 1.33, y - 0.3) - 0.12) * 60));
        const double hill = 1 / (1 + std::exp((0.65 + 0.12 * std::sin(6 * x) - y) * 50));
        std::array<double, 3> rgb{0.45 + 0.4 * y, 0.6 + 0.3 * y, 0.85};
        const std::array<double, 3> red{0.85, 0.2, 0.1}, green{0.2, 0.35, 0.15};
        for (std::size_t c = 0; c < 3; ++c) {
            rgb[c] += sun * (red[c] - rgb[c]);
            rgb[c] += hill * (green[c] - rgb[c]);
        }
        return rgb;
    });
}

inline void runToEnd(fitting::Fitting &fit)
{
    while (fit.step())
        ;
}

} // namespace suffuse
