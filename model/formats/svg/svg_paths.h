// Curves from SVG: paths and basic shapes with their colours, under transforms.
#pragma once

#include "model/painting/geometry.h"
#include "model/result.h"

#include <QByteArray>
#include <QString>

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
    QString name;           ///< Inkscape's label, <title> or id; may be empty
    int group = -1;         ///< of the drawing's groups; −1: none
};

/// A <g>, or what is like one.
struct SvgGroup {
    QString name;    ///< as a path's
    int parent = -1; ///< stands before it; −1: none
};

/// How much of a drawing strokes cannot show.
struct SvgLosses {
    int fills = 0;    ///< shapes whose inside would have been painted
    int outlined = 0; ///< of these, those that have nothing but their fill, which their outline is painted with
    int dashes = 0;   ///< shapes whose strokes are dashed
    int texts = 0, images = 0;
    /// Definitions that are used by what is drawn.
    int gradients = 0, patterns = 0, clipPaths = 0, masks = 0, filters = 0, markers = 0;
    int cycles = 0;     ///< <use> that contain themselves
    int rules = 0;      ///< selectors of style sheets that were not understood
    bool isCut = false; ///< there was more than is read
};

/// A document's paths and the size that it gives itself.
struct SvgDrawing {
    std::vector<SvgPath> paths;
    /// Of those that hold more than one thing. Paths of a group, those of its groups among them, stand together.
    std::vector<SvgGroup> groups;
    SvgLosses losses;
    Rect area; ///< what is to be seen, in the units of the document (viewBox, or width and height); empty: unsaid
    double scale = 1; ///< CSS pixels a unit, as width and height want it
};

/// The subpaths of path data ("M 0 0 C …"): all commands of SVG, lines and arcs as cubics. What comes after a mistake
/// is left out, as browsers do; curves that are points or not finite are, too.
std::vector<std::vector<Cubic>> parsePathData(const QString &data);

/// All paths and basic shapes of a document in their order, in the units of the document after transforms, styled by
/// attributes and style sheets; what <use> refers to counts where it is used. Elements that are only defined, not drawn
/// (<defs>, <clipPath>, …), and invisible ones are left out. Errors name the line.
Result<SvgDrawing> readSvgDrawing(const QByteArray &bytes);
/// Its paths alone, in no groups.
Result<std::vector<SvgPath>> readSvgPaths(const QByteArray &bytes);

} // namespace suffuse
