// RYB, the pigment-like colour space that the painting lives in (Sugita & Takahashi), against sRGB-encoded values.
#pragma once

#include "model/painting/style.h"

#include <array>

namespace suffuse {

/// RYB of an sRGB-encoded colour, all in [0, 1]. White is (0, 0, 0), black (1, 1, 1); green is (0, 1, 1).
std::array<double, 3> rybFromSrgb(const std::array<double, 3> &rgb);
/// The exact inverse. Public copies of the formulas print g′ = y + 2m; only y + m inverts the other half.
std::array<double, 3> srgbFromRyb(const std::array<double, 3> &ryb);

/// As a colour of the model; values outside [0, 1] are clamped.
Colour rybFromSrgb(double red, double green, double blue, double opacity = 1);
/// sRGB-encoded red, green, blue of a colour, without its opacity.
std::array<double, 3> srgbFromRyb(const Colour &colour);

} // namespace suffuse
