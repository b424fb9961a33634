// The region of the picture that paint bounds.
#pragma once

#include "model/painting/painting.h"

#include <atomic>
#include <vector>

namespace suffuse {

/// What belongs to a region.
struct RegionWish {
    double tolerance = 0.1; ///< by how much colours may differ from that at the point, a share of a channel, [0, 1]
    double gap = 0;         ///< openings of the bounds that are narrower are closed, canvas units
    double grow = 1;        ///< how far the region then reaches under its bounds, canvas units; negative: less far
};

/// The outlines, in canvas units, of the region of the canvas around a point in which the picture at time T has about
/// the colour that it has there. `scale` is the resolution that is wanted, pixels a unit, at least 1; large canvases
/// are looked at with fewer. Empty where the point is beyond the canvas, nothing is left, or nothing can be drawn,
/// and soon after `cancel` becomes true. Takes as long as drawing two million pixels and some more: up to half a
/// second. Any thread.
std::vector<std::vector<Cubic>> paintRegion(const PaintingPtr &painting, Microseconds T, Point at,
                                            const RegionWish &wish, double scale,
                                            const std::atomic<bool> *cancel = nullptr);

} // namespace suffuse
