// Conversions between RYB, the pigment-like colour space of paintings (Sugita & Takahashi), and sRGB-encoded values.
#pragma once

#include "model/painting/style.h"

#include <array>

namespace suffuse {

/// The RYB values of an sRGB-encoded colour; all are in [0, 1]. White is (0, 0, 0), black (1, 1, 1), green (0, 1, 1).
std::array<double, 3> rybFromSrgb(const std::array<double, 3> &rgb);
/// The exact inverse. Public copies of the formulas print g′ = y + 2m, but only y + m inverts the other half.
std::array<double, 3> srgbFromRyb(const std::array<double, 3> &ryb);

/// The same as a colour of the model. Values outside [0, 1] are clamped.
Colour rybFromSrgb(double red, double green, double blue, double opacity = 1);
/// The sRGB-encoded red, green and blue of a colour, without its opacity.
std::array<double, 3> srgbFromRyb(const Colour &colour);

} // namespace suffuse
