// Colours as a pure hue with white and black in it, as the colour wheel shows them.
#pragma once

#include "model/painting/style.h"

namespace suffuse {

/// A pure hue of the RYB circle, hue in [0, 1): red 0, yellow 1/3, blue 2/3.
Colour pureHue(double hue);

/// A colour as its pure hue and its shares of white and black: C = chroma·pure + black·(1, 1, 1), all in [0, 1],
/// chroma + white + black = 1.
struct HueShares {
    double hue = 0;
    double chroma = 0;
    double black = 0;
};
/// Greys have no hue; they keep `hueOfGrey`.
HueShares toShares(const Colour &colour, double hueOfGrey);
Colour fromShares(const HueShares &shares, float opacity);

} // namespace suffuse
