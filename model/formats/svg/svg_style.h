// How an SVG element is painted, by attributes, style sheets and inheritance.
#pragma once

#include "model/area/pen_outline.h"
#include "model/formats/svg/svg_length.h"
#include "model/formats/svg/svg_matrix.h"
#include "model/formats/svg/svg_tree.h"
#include "model/formats/svg/text/svg_font.h"
#include "model/painting/blend.h"

#include <array>
#include <optional>
#include <vector>

namespace suffuse {

using SvgColour = std::array<double, 4>; ///< sRGB-encoded red, green, blue and opacity

/// The properties that children inherit, and those that count for one element alone.
struct SvgStyle {
    SvgMatrix matrix;
    SvgUnits units;
    QString fill = "black", stroke = "none";              ///< as written in CSS
    QString contextFill = "none", contextStroke = "none"; ///< what context-fill and context-stroke mean
    QString order;                                        ///< paint-order: what is painted first
    QString markers[3] = {"none", "none", "none"};
    SvgColour current{0, 0, 0, 1};
    double fillOpacity = 1, strokeOpacity = 1;
    Pen pen; ///< of strokes, in user units
    SvgFont font;
    bool isVisible = true;
    bool isFaded = false;       ///< whether the element or something around it has an opacity below 1
    bool isEvenOdd = false;     ///< fill-rule
    bool isClipEvenOdd = false; ///< clip-rule
    // What follows counts for this element alone.
    double opacity = 1;
    bool isDisplayed = true;
    bool keepsWidth = false;             ///< vector-effect: non-scaling-stroke
    BlendMode blend = BlendMode::Normal; ///< mix-blend-mode
    bool isBlendUnknown = false;         ///< whether that is none that is known
    bool isIsolated = false;             ///< isolation
    bool overflows = false;              ///< overflow: whether a nested drawing shows what lies beyond its viewport
    QString clipPath, mask, filter;

    /// The style of an element, within that of its parent. Style sheets override attributes, the style attribute
    /// overrides style sheets, and !important overrides all. Values that make no sense are ignored.
    static SvgStyle of(const SvgElement &element, const SvgStyle &parent, CssSheet &sheet);
    /// That of an element where it stands, within the styles of all elements around it.
    static SvgStyle ofDefinition(const SvgElement &element, CssSheet &sheet);

    /// A paint, or what it stands for if it is that of the element which uses this one.
    QString inContext(const QString &paint) const;
};

/// The "#id" of "url(#id) fallback"; empty for other paints.
QString svgReference(const QString &paint);

/// A place on a gradient's way, and its colour there.
struct SvgStop {
    double offset = 0; ///< [0, 1]; none is before that of the stop before it
    SvgColour colour{0, 0, 0, 1};
};
/// The stops of a gradient, or of the gradient from which it takes them; empty if there are none. Those whose place is
/// no number are left out.
std::vector<SvgStop> svgStops(const SvgElement *gradient, SvgTree &tree);

/// A stroke or a fill as one colour. For a gradient it is the mean of its stops, and for a pattern the colour that the
/// drawing names to take its place, or else nothing.
struct SvgPaint {
    std::optional<SvgColour> colour;      ///< no value: nothing is painted
    const SvgElement *gradient = nullptr; ///< whose mean it is
    const SvgElement *replaced = nullptr; ///< the gradient or pattern that is lost with that colour, or without one
};
SvgPaint svgPaint(const QString &paint, double opacity, const SvgColour &current, SvgTree &tree);

} // namespace suffuse
