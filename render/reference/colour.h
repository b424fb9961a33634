// RYB and RGB (Sugita & Takahashi), mixing (eq 22, 23) and straight alpha, in double precision.
#pragma once

#include "model/painting/style.h"

#include <array>

namespace suffuse::reference {

using Ryb = std::array<double, 3>; ///< red, yellow, blue; white (0, 0, 0), black (1, 1, 1)
using Rgb = std::array<double, 3>; ///< sRGB-encoded

/// These are exact inverses of each other on [0, 1]³. Public copies of the formulas print g′ = y + 2m in the second
/// one, but only g′ = y + m inverts the first.
Ryb rybOfRgb(const Rgb &rgb);
Rgb rgbOfRyb(const Ryb &ryb);

/// The paint of one stroke at one spot: opacity w and colour C̄.
struct Paint {
    double opacity = 0;
    Ryb colour{};
};

/// The canvas at one spot.
struct Spot {
    Ryb colour{};        ///< B
    double coverage = 0; ///< a, kept for transparent export
};

/// A spot of the bare canvas: the background over white, or nothing over white.
Spot bareSpot(const Colour &background, bool transparent);

/// Mixes by alpha (22): B ← w·C̄ + (1 − w)B, or by beta (23): B ← min(1, w·C̄ + (1 − w(1 − β))B). In both, a ← w + (1 −
/// w)a.
void mix(Spot &spot, const Mix &how, const Paint &paint);

/// The colour that is stored: RGB of B with alpha 1 or, if transparent, the straight colour clamp((RGB(B) − (1 − a))/a)
/// and a, which are all 0 where a = 0.
std::array<double, 4> storedColour(const Spot &spot, bool transparent);

} // namespace suffuse::reference
