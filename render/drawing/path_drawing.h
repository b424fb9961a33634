// A painting as a drawing of paths: what other programs cut, plot, and show without knowing how paint spreads.
#pragma once

#include "model/painting/painting.h"
#include "render/contours/contours.h"
#include "render/drawing/drawn_paint.h"

#include <atomic>
#include <functional>
#include <map>

namespace suffuse {

enum class DrawingKind {
    Outlines, ///< a path for each stroke, around what is at least half covered
    Bands,    ///< contours within each other, each as opaque as what it shows
    Hybrid    ///< the exact picture, and over it the outlines, unpainted
};

enum class DrawingFormat { Svg, Pdf };

struct DrawingOptions {
    DrawingKind kind = DrawingKind::Bands;
    DrawingFormat format = DrawingFormat::Svg;
    int bands = 16;        ///< how many steps full opacity is drawn in, 1 … mostBands
    Microseconds time = 0; ///< document time T
    int threads = 0;       ///< 0: all cores
    const std::atomic<bool> *cancel = nullptr;
    std::function<void(int done, int all)> progress; ///< called on any thread
};
inline constexpr int mostBands = 256;

/// A stroke as paths. Each of its bands lies within the one before it and takes its place there.
struct DrawnStroke {
    StrokePtr stroke; ///< as it is drawn: the strokes of a wash are one
    std::vector<contours::Band> bands;
    DrawnPaint paint;        ///< of a stroke with a picture the colour that is not seen
    bool multiplies = false; ///< whether it is pigment rather than opaque paint
};

/// What a group is seen through: where these strokes are, and as much as they cover.
struct DrawnBound {
    std::vector<DrawnStroke> strokes; ///< white, from bottom to top
    double opacity = 1;
};

struct PathDrawing {
    PaintingPtr painting; ///< as it is drawn
    DrawingFormat format = DrawingFormat::Svg;
    std::vector<DrawnStroke> strokes; ///< the visible ones that have a path, from bottom to top
    /// What groups that hold masks or are clipped are seen through, by their ids; several multiply. 0: all strokes.
    std::map<GroupId, std::vector<DrawnBound>> bounds;
    int bandCount = 16;     ///< in how many steps full opacity is drawn
    bool unpainted = false; ///< whether paths are there to be selected only
    int thin = 0;           ///< how many strokes have no path, since they are nowhere half covered
    int plain = 0;          ///< how many groups erase (in PDF: add), which a drawing has nothing for: they are plain
};

/// Draws a painting as it is exported: without drafts. Nothing of a drawing that was cancelled is of use.
PathDrawing drawingOf(const PaintingPtr &painting, const DrawingOptions &options);

/// Whether a group's paths come together before they are put on what lies below.
bool comesTogether(const PathDrawing &drawing, const Group &group);

} // namespace suffuse
