// Changes of colour that keep colours apart which were apart.
#pragma once

#include "model/painting/style.h"

namespace suffuse {

/// A change of hue, saturation and lightness. Colours under one shift keep their differences, as far as there is room
/// for them. Opacity stays as it is.
struct ColourShift {
    double hue = 0;        ///< turns around the circle of RYB hues, in the sense of red, yellow, blue
    double saturation = 1; ///< factor of the colourfulness, 0 and above; greys have none and stay grey
    double lightness = 0;  ///< [-1, 1]: share of the way to white, or below 0 to black
    friend bool operator==(const ColourShift &, const ColourShift &) = default;
};

/// The colour under the shift. A shift that changes nothing gives exactly the colour itself.
Colour shifted(const Colour &colour, const ColourShift &shift);

/// The shift that leads from one colour to another, but for rounding and for the opacity. A grey has no hue: from it,
/// only the lightness is shifted.
ColourShift shiftBetween(const Colour &from, const Colour &to);

/// Whether red, yellow and blue are exactly the same, whatever the opacities are.
inline bool samePaint(const Colour &a, const Colour &b)
{
    return a.red == b.red && a.yellow == b.yellow && a.blue == b.blue;
}
/// The red, yellow and blue of one colour with the opacity of another.
inline Colour withOpacity(const Colour &paint, float opacity)
{
    return {paint.red, paint.yellow, paint.blue, opacity};
}
/// Whether the colour is a grey, white and black included: one without a hue.
bool isGrey(const Colour &colour);

} // namespace suffuse
