// Markers: little drawings at the nodes of lines.
#pragma once

#include "model/area/pen_outline.h"
#include "model/formats/svg/svg_style.h"

#include <optional>
#include <vector>

namespace suffuse {

/// A node of a shape at which a marker may stand.
struct SvgMarkerPlace {
    enum class Kind { Start, Mid, End } kind = Kind::Mid; ///< as the indices of SvgStyle::markers
    Point at;                                             ///< user units
    Point direction{1, 0};                                ///< halfway between the ways in which the line comes and goes
};
std::vector<SvgMarkerPlace> svgMarkerPlaces(const std::vector<PenLine> &lines);

/// How a <marker> is drawn at a place of a shape.
struct SvgMarkerView {
    SvgStyle style; ///< of what is in it
    Rect port;      ///< what of that is seen, in its units
};
/// No value if the marker has no size.
std::optional<SvgMarkerView> svgMarkerView(const SvgElement &marker, const SvgMarkerPlace &place, const SvgStyle &shape,
                                           CssSheet &sheet);

} // namespace suffuse
