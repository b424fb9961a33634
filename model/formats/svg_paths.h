// Curves from SVG: paths and basic shapes with their colours, under transforms.
#pragma once

#include "model/painting/geometry.h"
#include "model/result.h"

#include <QByteArray>

#include <array>
#include <optional>
#include <vector>

namespace suffuse {

/// One subpath of a <path>, or a shape.
struct SvgPath {
    std::vector<Cubic> curves;                   ///< each starts where the one before it ends; at least one
    std::optional<std::array<double, 4>> stroke; ///< sRGB-encoded colour and opacity
    std::optional<std::array<double, 4>> fill;
    double strokeWidth = 1; ///< user units of the drawing
};

/// A document's paths and the size that it gives itself.
struct SvgDrawing {
    std::vector<SvgPath> paths;
    int leftOut = 0; ///< texts and images that it shows
    int fills = 0;   ///< paths of which it paints the inside
    Rect area;       ///< what is to be seen, in the units of the document (viewBox, or width and height); empty: unsaid
    double scale = 1; ///< CSS pixels a unit, as width and height want it
};

/// The subpaths of path data ("M 0 0 C …"): all commands of SVG, lines and arcs as cubics. What comes after a mistake
/// is left out, as browsers do; curves that are points or not finite are, too.
std::vector<std::vector<Cubic>> parsePathData(const QString &data);

/// All paths and basic shapes of a document in their order, in the units of the document after transforms; what <use>
/// refers to counts where it is used. Elements that are only defined, not drawn (<defs>, <clipPath>, …), and invisible
/// ones are left out. Errors name the line.
Result<SvgDrawing> readSvgDrawing(const QByteArray &bytes);
/// Its paths alone.
Result<std::vector<SvgPath>> readSvgPaths(const QByteArray &bytes);

} // namespace suffuse
