// RYB and RGB (Sugita & Takahashi), mixing (eq 22, 23) and straight alpha, in double precision.
#pragma once

#include "model/painting/style.h"

#include <array>

namespace suffuse::reference {

using Ryb = std::array<double, 3>; ///< red, yellow, blue; white (0, 0, 0), black (1, 1, 1)
using Rgb = std::array<double, 3>; ///< sRGB-encoded

/// Exact inverses of each other on [0, 1]³. Public copies of the formulas print g′ = y + 2m in the second; only
/// g′ = y + m inverts the first.
Ryb rybOfRgb(const Rgb &rgb);
Rgb rgbOfRyb(const Ryb &ryb);

/// One stroke's paint on one spot: opacity w and colour C̄.
struct Paint {
    double opacity = 0;
    Ryb colour{};
};

/// The canvas at one spot.
struct Spot {
    Ryb colour{};        ///< B
    double coverage = 0; ///< a, kept for transparent export
};

/// A spot of the bare canvas: the background over white, or nothing at all over white.
Spot bareSpot(const Colour &background, bool transparent);

/// Alpha (22): B ← w·C̄ + (1 − w)B. Beta (23): B ← min(1, w·C̄ + (1 − w(1 − β))B). a ← w + (1 − w)a in both.
void mix(Spot &spot, const Mix &how, const Paint &paint);

/// What is stored: RGB of B with alpha 1; transparent: straight colour clamp((RGB(B) − (1 − a))/a) and a, all 0 where
/// a = 0.
std::array<double, 4> storedColour(const Spot &spot, bool transparent);

} // namespace suffuse::reference
