// Conversions between the painting's RYB colours and the screen's.
#pragma once

#include "model/painting/style.h"

#include <QColor>

#include <optional>

class QMimeData;

namespace suffuse {

/// The sRGB form of a colour; alpha is its opacity.
QColor toScreen(const Colour &colour);
/// The same, opaque.
QColor toOpaqueScreen(const Colour &colour);
/// The RYB form of a screen colour; the opacity is its alpha.
Colour fromScreen(const QColor &colour);

/// Writes exactly this colour, to the last bit, as a line of text: "red yellow blue opacity".
QString textOf(const Colour &colour);
std::optional<Colour> colourOfText(const QString &text);
/// Makes the data of a drag: the colour itself for our own windows, and a screen colour for other programs. The caller
/// owns it.
QMimeData *dragDataOf(const Colour &colour);
/// The colour that was dragged or copied. It is exact where it comes from one of our windows.
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
/// Greys have no hue; they keep `hueOfGrey`.
HueShares toShares(const Colour &colour, double hueOfGrey);
Colour fromShares(const HueShares &shares, float opacity);

} // namespace suffuse
