// What a document of SVG shows, as curves with their colours.
#pragma once

#include "model/geometry/geometry.h"
#include "model/painting/blend.h"
#include "model/painting/text.h"

#include <QString>
#include <QStringList>

#include <array>
#include <optional>
#include <vector>

namespace suffuse {

/// What an element paints: the area within its subpaths, or a line along one of them.
struct SvgPath {
    /// Each starts where the one before it ends, unless a chain begins there. There is at least one.
    std::vector<Cubic> curves;
    std::vector<std::size_t> chains;             ///< the curves with which the second and further chains begin
    std::optional<std::array<double, 4>> stroke; ///< sRGB-encoded colour and opacity of a line
    std::optional<std::array<double, 4>> fill;   ///< of an area; one of the two is there
    /// Of an area whose colour changes: from `fill` at the first point to the colour at the second one, and not beyond.
    struct Shade {
        Point from, to;
        std::array<double, 4> colour;
    };
    std::optional<Shade> shade;
    bool isEvenOdd = false; ///< the rule by which an area is inside its curves
    double strokeWidth = 1; ///< user units of the drawing
    int lead = -1;          ///< which of the drawing's leads it is; −1: no text stands along it
    QString name;           ///< Inkscape's label, <title> or id; may be empty
    int group = -1;         ///< the index of a group of the drawing; −1: none
};

/// A <g>, or an element that works like one.
struct SvgGroup {
    QString name;    ///< as that of a path
    int parent = -1; ///< the index of a group before this one; −1: none
    /// Of a <text> that can be typed in again. Its place is in units of the document; `followMap` is from the own units
    /// of the shape along which it stands.
    SharedText text{};
    int follows = -1;        ///< the number of the shape along which such a text stands, if any is painted
    std::size_t letters = 0; ///< how many paths such a text has
    QString words{};         ///< of any <text>, for people
    float opacity = 1;       ///< as Suffuse's groups have these three
    BlendMode blend = BlendMode::Normal;
    bool isIsolated = false;
    bool isHidden = false; ///< as a layer that Inkscape has hidden
};

/// A shape along which texts stand, as it is painted once.
struct SvgLead {
    int shape = 0; ///< its number
    Affine map;    ///< from its own units to those of the document
};

/// How much of a drawing strokes cannot show.
struct SvgLosses {
    int outlines = 0; ///< areas and outlines of pens that take too much work to find
    int texts = 0, images = 0;
    int fixedTexts = 0; ///< that came in as letters alone, and cannot be typed in again
    /// definitions that are used by what is drawn
    int gradients = 0, patterns = 0, clipPaths = 0, masks = 0, filters = 0, markers = 0;
    int blendModes = 0; ///< that are not known, or of groups too deep within each other
    QStringList fonts;  ///< families that are not installed, so that others stand in
    int cycles = 0;     ///< <use> elements that contain themselves
    int rules = 0;      ///< selectors of style sheets that were not understood
    bool isCut = false; ///< whether there was more than is read
};

/// The paths of a document, and the size that it gives itself.
struct SvgDrawing {
    std::vector<SvgPath> paths;
    /// The groups with more than one thing in them, and those that blend. The paths of a group, including those of
    /// groups within it, stand together.
    std::vector<SvgGroup> groups;
    std::vector<SvgLead> leads;
    SvgLosses losses;
    /// what is to be seen, in the units of the document (viewBox, or width and height); empty if the document does not
    /// say
    Rect area;
    double scale = 1; ///< CSS pixels for each unit, by width and height
};

} // namespace suffuse
