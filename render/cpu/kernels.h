// The inner loops, compiled for several SIMD instruction sets; the best one for this machine is chosen at run time.
#pragma once

#include "render/cpu/blocks.h"

namespace suffuse::cpu {

struct Kernels {
    const char *name;
    /// The boxes that meet `area`; conservative, what is left out adds exactly nothing. `runs`: the first of each boxRun
    /// boxes with one that meets; their number is returned.
    int (*findRuns)(const NodeBoxes &in, int count, const Area &area, std::uint32_t *runs, Meeting &meeting);
    /// The same for each cell of a grid (row by row), of the boxes in some runs. The nodes of cell i, in order, lie in
    /// `nodes` from i·runCount·boxRun on.
    void (*listNodes)(const NodeBoxes &in, int count, const std::uint32_t *runs, int runCount, const Grid &grid,
                      std::uint32_t *nodes, Meeting *cells);
    /// The sums of the nodes that are listed, of which the first `separable` have b = 0; with `add`, on top of what
    /// `sums` holds. `values`: `channels` floats a row.
    void (*accumulate)(const Block &block, const ViewNode *nodes, const std::uint32_t *listed, int count, int separable,
                       const float *values, int channels, bool add, Sums &sums);
    /// `eta`: paper texture at the samples, or null for 1. `step`: size of a sample in pixels.
    void (*shade)(const ShadeParams &params, const Sums &sums, const float *eta, float step, Shaded &out);
    /// The same, mixed into the block at once, and put on top of `map` if there is one.
    void (*shadeInto)(const ShadeParams &params, const Sums &sums, const float *eta, float step, float keep,
                      Backdrop &backdrop, OverMap *map);
    /// Mixes one stroke into the block (eq 22 with keep = 1, eq 23 with keep = 1 − β).
    void (*mix)(const Shaded &stroke, float keep, Backdrop &backdrop);
    /// Puts one stroke on top of a map.
    void (*compose)(const Shaded &stroke, float keep, OverMap &map);
    void (*apply)(const OverMap &map, Backdrop &backdrop);
    /// To straight RGBA, rows `stride` pixels apart. `transparent`: uncover the colour from its white background.
    void (*finish)(const Backdrop &backdrop, bool transparent, float *rgba, int stride);
    /// RGBA in [0, 1] to 8 bits as 0xAARRGGBB, `count` pixels.
    void (*toArgb)(const float *rgba, int count, std::uint32_t *argb);
};

/// The best set for this machine. SUFFUSE_SIMD names another one that it supports ("SSE2", "AVX2", …).
const Kernels &kernels();

} // namespace suffuse::cpu
