// Gradients of SVG, as fills that lie over or beside each other.
#pragma once

#include "model/formats/svg/svg_style.h"
#include "model/geometry/geometry.h"

#include <optional>
#include <vector>

namespace suffuse {

/// A colour that changes evenly from `first` at `from` to `last` at `to`, and stays as it is there beyond them. Lines
/// of one colour are perpendicular to the way between the points.
struct SvgShade {
    Point from, to;
    SvgColour first, last;
    /// The area where alone it is painted, as closed loops by the even-odd rule; none: everywhere.
    std::vector<std::vector<Cubic>> within;
};

/// What a gradient paints with.
struct SvgGradientUse {
    const SvgElement &gradient;
    Rect box;         ///< of the shape, in its own units
    SvgMatrix matrix; ///< maps these to units of the document
    SvgUnits units;   ///< of the shape
    Rect seen;        ///< the box of all that is painted, in units of the document
    double opacity = 1;
    bool isApart = false; ///< whether shades must not lie over each other
    /// The greatest number of steps between two stops around a point, where colours let through; 0: coarse ones, in
    /// rings beside each other.
    int finest = 128;
};

/// The shades that show a gradient, from bottom to top: colours along a line within 1/100, those around a point within
/// 1/64. They lie over each other where all colours are opaque, or in rings around a point, and else beside each other.
/// Empty where a gradient paints nothing; no value if it takes too many, or one cannot reckon with them.
std::optional<std::vector<SvgShade>> svgShades(const SvgGradientUse &use, SvgTree &tree);

} // namespace suffuse
