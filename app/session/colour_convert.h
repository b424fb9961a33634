// Conversions between the painting's RYB colours and the screen's.
#pragma once

#include "model/colour/hue_shares.h"
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

/// The opaque colour of "#rrggbb" or "#rgb", with or without #, or of what else CSS calls a colour ("rgb(255, 0, 128)",
/// "teal"); nothing for any other text.
std::optional<Colour> typedColour(const QString &text);

/// Writes exactly this colour, to the last bit, as a line of text: "red yellow blue opacity".
QString textOf(const Colour &colour);
std::optional<Colour> colourOfText(const QString &text);
/// Makes the data of a drag: the colour itself for our own windows, and a screen colour for other programs. The caller
/// owns it.
QMimeData *dragDataOf(const Colour &colour);
/// The colour that was dragged or copied. It is exact where it comes from one of our windows.
std::optional<Colour> colourOf(const QMimeData &data);

} // namespace suffuse
