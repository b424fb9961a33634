// A chain of points on a contour becomes a closed path of few cubics.
#pragma once

#include "render/contours/contour_cells.h"

namespace suffuse::contours {

/// Cubics that follow each other and are closed, and whose directions agree where they meet. Each was tried against the
/// field: between the points that it was drawn through the contour passes within the tolerance. Where the field jumps
/// or has a corner they become short lines.
std::vector<Cubic> fittedLoop(const ContourChain &chain, const Field &field, double level, double tolerance);

} // namespace suffuse::contours
