// Paintings to measure on: smooth pen-like strokes of the sizes of the paper's Table 2, the same on every machine.
#pragma once

#include "model/painting/painting.h"

#include <span>

namespace suffuse::bench {

/// What a generated painting is like. Lengths in canvas units.
struct PaintingOptions {
    int strokes = 778;
    int segments = 17917; ///< in all; at least one a stroke
    double width = 1024;
    double height = 768;
    double unit = 1;      ///< scale of the strokes: a segment is 5-12 units long
    double spreadLow = 6; ///< range of s at full age, in `unit`
    double spreadHigh = 20;
    std::uint64_t seed = 1;
};

/// The sizes of a painting of the paper's Table 2.
struct Table2Size {
    const char *name; ///< "figure11f"
    int strokes;
    int segments;
};
std::span<const Table2Size> table2();

/// Strokes of wandering curvature with a pen's pressure: 60 % uniform, 24 % feathering, 16 % edge darkening; 30 %
/// change colour along the stroke; 40 % granulated; 25 % mixed as pigment (make_paintings.py's shares). A pure function
/// of the options.
Painting makePainting(const PaintingOptions &options);

/// A stroke as it is being drawn: a sample each 1/60 s from `born` on, along loops over the whole canvas, 200 each.
/// `spread`: s at full age, canvas units; t_max 1 s.
Stroke makeLiveStroke(const Canvas &canvas, double spread, int segments, StrokeId id, Microseconds born);

/// `count` copies of strokes of a painting, picked and laid over its canvas at random, with ids from `firstId` on.
StrokeList repeatedStrokes(const Painting &painting, std::size_t count, StrokeId firstId);

/// A painting of such copies with `segments` in all; the last one is cut to fit.
Painting repeatedPainting(const Painting &painting, std::size_t segments);

} // namespace suffuse::bench
