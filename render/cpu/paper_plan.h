// The procedural paper η of a view, ready to be computed at blocks of samples (docs/paper.md).
#pragma once

#include "model/painting/painting.h"
#include "render/view.h"

#include <cstdint>
#include <vector>

namespace suffuse::cpu {

/// One layer of gradient noise. The picture's point (x, y) lies at (u0 + ux·x + uy·y, v0 + vx·x + vy·y) on its lattice.
struct PaperLayer {
    double u0 = 0, ux = 0, uy = 0;
    double v0 = 0, vx = 0, vy = 0;
    std::uint32_t base = 0; ///< what the hashes of its lattice points begin with
    float share = 1;        ///< how much of it counts
};

/// All that η needs at samples of one size.
struct PaperPlan {
    std::vector<PaperLayer> octaves; ///< shares without the factor of the grain
    std::vector<PaperLayer> fibres;  ///< the five directions, or empty
    std::vector<PaperLayer> weave;   ///< the two waves of the threads and the lattice of the threads, or empty
    float octavesFactor = 1;
    float weaveFactor = 0;
    float strength = 0;
};

/// Plans a procedural paper for samples that are `step` pixels apart.
PaperPlan planPaper(const Paper &paper, const View &view, double step);

} // namespace suffuse::cpu
