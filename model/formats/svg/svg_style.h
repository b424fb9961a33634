// How an SVG element is painted: attributes, style sheets and what is inherited.
#pragma once

#include "model/formats/svg/svg_matrix.h"
#include "model/formats/svg/svg_tree.h"

#include <array>
#include <optional>
#include <vector>

namespace suffuse {

using SvgColour = std::array<double, 4>; ///< sRGB-encoded red, green, blue and opacity

/// What children inherit, and what holds for one element alone.
struct SvgStyle {
    SvgMatrix matrix;
    QString fill = "black", stroke = "none"; ///< as CSS writes them
    QString markers[3] = {"none", "none", "none"};
    SvgColour current{0, 0, 0, 1};
    double fillOpacity = 1, strokeOpacity = 1, opacity = 1, strokeWidth = 1;
    bool isVisible = true;
    bool isDashed = false;
    // Of this element alone.
    bool isDisplayed = true;
    bool keepsWidth = false; ///< vector-effect: non-scaling-stroke
    QString clipPath, mask, filter;

    /// Of an element, in the style of its parent. What sheets say goes before attributes, the style attribute before
    /// sheets, and what is !important before all; values that are none are passed over.
    static SvgStyle of(const SvgElement &element, const SvgStyle &parent, CssSheet &sheet);
};

/// "#id" of "url(#id) fallback"; empty of other paints.
QString svgReference(const QString &paint);

/// A stroke or a fill as one colour. Of gradients the mean of their stops.
struct SvgPaint {
    std::optional<SvgColour> colour;      ///< none: nothing is painted
    const SvgElement *replaced = nullptr; ///< the gradient or pattern in whose place the colour stands
};
SvgPaint svgPaint(const QString &paint, double opacity, const SvgColour &current, SvgTree &tree);

} // namespace suffuse
