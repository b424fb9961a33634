// Between the painting's RYB and the screen's colours.
#pragma once

#include "model/painting/style.h"

#include <QColor>

#include <optional>

class QMimeData;

namespace suffuse {

/// sRGB of a colour; alpha is its opacity.
QColor toScreen(const Colour &colour);
/// The same without its opacity.
QColor toOpaqueScreen(const Colour &colour);
/// RYB of a screen colour; opacity is its alpha.
Colour fromScreen(const QColor &colour);

/// Exactly this colour, to the last bit, as a line of text: "red yellow blue opacity".
QString textOf(const Colour &colour);
std::optional<Colour> colourOfText(const QString &text);
/// What is dragged: the colour itself for our own windows, a screen colour for others. The caller owns it.
QMimeData *dragDataOf(const Colour &colour);
/// The colour that was dragged or copied, exactly where it is one of ours.
std::optional<Colour> colourOf(const QMimeData &data);

/// A pure hue of the RYB circle, hue in [0, 1): red 0, yellow 1/3, blue 2/3.
Colour pureHue(double hue);

/// A colour as its pure hue and its shares of white and black: C = chroma·pure + black·(1, 1, 1), all in [0, 1],
/// chroma + white + black = 1.
struct HueShares {
    double hue = 0;
    double chroma = 0;
    double black = 0;
};
/// Of greys the hue is undefined: `hueOfGrey` is kept.
HueShares toShares(const Colour &colour, double hueOfGrey);
Colour fromShares(const HueShares &shares, float opacity);

} // namespace suffuse
