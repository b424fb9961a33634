// Rings of a radial gradient that lets through, which lie over each other like shingles.
#pragma once

#include "model/formats/svg/svg_style.h"

#include <vector>

namespace suffuse {

/// A ring of one colour around the focus of a gradient.
struct SvgShingle {
    double from, to; ///< offsets of the gradient; −∞: it is a disc, ∞: it goes on to the end of the shape
    SvgColour colour;
};

/// The rings that together have the colours of the stops, whose offsets rise, from bottom to top. Rings beside each
/// other would let more through where one ends and the next begins, since both cover half a pixel there, and one would
/// see each seam. So each place has six rings over each other, of which only one changes at a time: what is missing
/// there is less than 1/128. There are `finest` steps at most between two stops. With 128 each channel, premultiplied
/// by the opacity, is within 1/64 of the gradient.
std::vector<SvgShingle> svgShingles(const std::vector<SvgStop> &stops, int finest);

} // namespace suffuse
