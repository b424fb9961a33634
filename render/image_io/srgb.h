#pragma once

#include <cmath>

namespace suffuse {

/// Convert a sRGB-encoded value to linear light (IEC 61966-2-1), and back. Below 0 both continue straight.
inline float linearFromSrgb(float v)
{
    return v <= 0.04045f ? v / 12.92f : float(std::pow((double(v) + 0.055) / 1.055, 2.4));
}
inline float srgbFromLinear(float v)
{
    return v <= 0.0031308f ? v * 12.92f : float(1.055 * std::pow(double(v), 1 / 2.4) - 0.055);
}

} // namespace suffuse
