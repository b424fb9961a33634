// Linear gradients of SVG, as colours that change evenly between two points.
#pragma once

#include "model/formats/svg/svg_style.h"

#include <vector>

namespace suffuse {

/// A colour that changes evenly from `first` at `from` to `last` at `to`, and stays as it is there beyond them. Lines
/// of one colour are perpendicular to the way between the points.
struct SvgShade {
    Point from, to;
    SvgColour first, last;
};

/// What a linear gradient paints with, from bottom to top: shades that are painted over each other show its colours
/// within 1/100. `box` is that of the shape in its own units, `matrix` maps these to those of the document, and
/// `viewport` is what per cents count by. Empty where it cannot be shown so: for other gradients, for stops that let
/// through unequally and are more than two, and for gradients that repeat.
std::vector<SvgShade> svgShades(const SvgElement &gradient, const Rect &box, const SvgMatrix &matrix,
                                const Rect &viewport, double opacity, const SvgColour &current, SvgTree &tree);

} // namespace suffuse
