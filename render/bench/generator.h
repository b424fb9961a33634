// Paintings for measuring: smooth strokes as of a pen, in the sizes of the paper's Table 2. They are the same on every
// machine.
#pragma once

#include "model/painting/painting.h"

#include <span>

namespace suffuse::bench {

/// The properties of a generated painting. Lengths are in canvas units.
struct PaintingOptions {
    int strokes = 778;
    int segments = 17917; ///< in the whole painting; at least one for each stroke
    double width = 1024;
    double height = 768;
    double unit = 1;      ///< scale of the strokes: a segment is 5-12 units long
    double spreadLow = 6; ///< the range of s at full age, in multiples of `unit`
    double spreadHigh = 20;
    std::uint64_t seed = 1;
};

/// The sizes of a painting of the paper's Table 2.
struct Table2Size {
    const char *name; ///< a name such as "figure11f"
    int strokes;
    int segments;
};
std::span<const Table2Size> table2();

/// Makes strokes of wandering curvature with a pen's pressure: 60 % uniform, 24 % feathering, 16 % edge darkening; 30 %
/// change colour along the stroke; 40 % are granulated; 25 % are mixed as pigment (the shares of make_paintings.py). It
/// is a pure function of the options.
Painting makePainting(const PaintingOptions &options);

/// A stroke as it is being drawn, with a sample each 1/60 s from `born` on, in loops over the whole canvas with 200
/// samples each. `spread` is s at full age in canvas units; t_max is 1 s.
Stroke makeLiveStroke(const Canvas &canvas, double spread, int segments, StrokeId id, Microseconds born);

/// Makes `count` copies of strokes of a painting, chosen and placed on its canvas at random, with ids from `firstId`
/// on.
StrokeList repeatedStrokes(const Painting &painting, std::size_t count, StrokeId firstId);

/// Makes a painting of such copies with `segments` in all. The last stroke is cut to fit.
Painting repeatedPainting(const Painting &painting, std::size_t segments);

} // namespace suffuse::bench
