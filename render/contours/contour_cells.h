// Where a field crosses levels, roughly: closed chains of points, found on squares that are as fine as the field asks
// for.
#pragma once

#include "render/contours/stroke_field.h"

#include <atomic>
#include <functional>

namespace suffuse::contours {

/// Some field of a stroke, at a point.
using Field = std::function<Sloped(Point)>;

/// A point of a contour with the slope of the field there.
struct ContourPoint {
    Point at;
    Point slope;
};

/// A closed chain around what lies above a level, which is on its left as (x, y) are written with y up.
using ContourChain = std::vector<ContourPoint>;

struct CellOptions {
    double tolerance = 1.0 / 256; ///< canvas units
    double lowest = 0;            ///< where φ′ stays below it, no level is reached
    const std::atomic<bool> *cancel = nullptr;
};

/// The chains of each of the levels, which ascend. Squares are halved until they are narrow compared with the spread of
/// what counts there and, where a level is near, until the field's slope hardly turns in them. They are cut into
/// triangles so that neighbours of any size fit, and chains are closed. Points lie on the contour but for rounding,
/// except where the field jumps. Nothing, if it was cancelled.
std::vector<std::vector<ContourChain>> contourChains(const StrokeField &stroke, const Field &field,
                                                     const std::vector<double> &levels, const CellOptions &options);

} // namespace suffuse::contours
