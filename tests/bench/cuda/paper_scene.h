// A painting as the paper's kernels on the device take it, and what they have to compute.
#pragma once

#include "render/renderer.h"
#include "tests/bench/cuda/paper_device.h"

namespace suffuse::baseline {

/// `points` of the quadrature: 5 or 8. What the paper's method leaves out of the contract: see baselines.h.
PaperScene paperScene(const RenderRequest &request, int points);

/// Floating-point operations that a kernel does for a scene; a multiply-add counts as two, an exponential, a root and a
/// quotient as one. Shading and mixing (per mille of it) are left out.
struct PaperWork {
    double pairs = 0;     ///< (pixel, segment) within reach
    double asWritten = 0; ///< operations: those pairs, and each pixel's distance to each segment
    double port = 0;      ///< operations: those pairs
};
PaperWork paperWork(const RenderRequest &request, int points);

} // namespace suffuse::baseline
