// The inner loops, compiled for several SIMD instruction sets. The best one for this machine is chosen at run time.
#pragma once

#include "render/cpu/blocks.h"
#include "render/cpu/paper_plan.h"
#include "render/math/layer_put.h"

namespace suffuse::cpu {

/// A layer's picture, and how it is put.
struct KeptLayer {
    LayerPut how;
    const LayerPicture *picture = nullptr;
};

struct Kernels {
    const char *name;
    /// Finds the boxes that meet `area`. It is conservative: what is left out adds exactly nothing. `runs` gets the
    /// first box of each run of boxRun boxes of which one meets the area. Returns the number of runs.
    int (*findRuns)(const NodeBoxes &in, int count, const Area &area, std::uint32_t *runs, Meeting &meeting);
    /// Does the same for each cell of a grid (row by row), for the boxes in some runs. The nodes of cell i, in order,
    /// stand in `nodes` from i·runCount·boxRun on.
    void (*listNodes)(const NodeBoxes &in, int count, const std::uint32_t *runs, int runCount, const Grid &grid,
                      std::uint32_t *nodes, Meeting *cells);
    /// Computes the sums of the listed nodes. With `add` they are added to what `sums` has, which are sums of nodes
    /// that come before them in the stroke.
    void (*accumulate)(const Block &block, const ListedNodes &listed, bool add, Sums &sums);
    /// Sums up a fill in a cell.
    void (*fillCell)(const FillCell &cell, FillCellSums &out);
    /// Shades the pixels of level 0, and those of level 1 (`marks`: levelQuarters times the level, plus the quarter)
    /// whose four samples can be told from sums at the centres around: their marks become 0. The densities are lost.
    /// `etaOfSamples` is η at the samples (left and right ones above, then below), or null for 1. If one sample does
    /// for all of them it mixes the block as shadeInto does; else `out` gets opacity and colour.
    ToldBlock (*shadeBent)(const ShadeParams &params, int channels, Sums &sums, const float *eta,
                           const float (*etaOfSamples)[blockSize], std::uint8_t *marks, float keep, Backdrop &backdrop,
                           OverMap *map, Shaded &out);
    /// Computes opacity and colour. `eta` is the paper texture at the samples, or null for 1. `step` is the size of a
    /// sample in pixels.
    void (*shade)(const ShadeParams &params, const Sums &sums, const float *eta, float step, Shaded &out);
    /// Does the same, but mixes the result into the block at once, and puts it on top of `map` if there is one.
    void (*shadeInto)(const ShadeParams &params, const Sums &sums, const float *eta, float step, float keep,
                      Backdrop &backdrop, OverMap *map);
    /// The same for a block whose samples all have the sums of the first ones, without paper.
    void (*shadeLevelInto)(const ShadeParams &params, const Sums &sums, float step, float keep, Backdrop &backdrop,
                           OverMap *map);
    /// Computes opacity and colour of such a block.
    void (*shadeLevel)(const ShadeParams &params, const Sums &sums, float step, Shaded &out);
    /// Mixes one stroke into the block (eq 22 with keep = 1, eq 23 with keep = 1 − β).
    void (*mix)(const Shaded &stroke, float keep, Backdrop &backdrop);
    /// Puts one stroke on top of a map.
    void (*compose)(const Shaded &stroke, float keep, OverMap &map);
    void (*apply)(const OverMap &map, Backdrop &backdrop);
    /// Puts the picture of a layer on what lies below it. `share`: what its bounds let through; null for all.
    void (*put)(const LayerPut &how, const float *share, const Backdrop &layer, Backdrop &below);
    /// Makes a picture to keep of what a layer shows. Returns false if it shows nothing at all.
    bool (*keep)(const Backdrop &layer, LayerPicture &out);
    /// Turns the RYB of a block into RGB, in which the next two work, and back. Their bits differ from those of `put`.
    void (*toRgb)(Backdrop &backdrop);
    void (*toRyb)(Backdrop &backdrop);
    /// Puts kept layers on what lies below them, one after another.
    void (*putKept)(const KeptLayer *layers, int count, Backdrop &below);
    /// Puts a layer that has ended.
    void (*putEnded)(const LayerPut &how, const float *share, const Backdrop &layer, Backdrop &below);
    /// Converts to straight RGBA, in rows that are `stride` pixels apart. `isRgb`: whether the block is RGB by now.
    /// `transparent` removes the white background from the colour.
    void (*finish)(const Backdrop &backdrop, bool isRgb, bool transparent, float *rgba, int stride);
    /// Converts `count` pixels of RGBA in [0, 1] to 8 bits as 0xAARRGGBB.
    void (*toArgb)(const float *rgba, int count, std::uint32_t *argb);
    /// Computes η of a procedural paper at the samples of a block, whose cells lie on the grid of such cells. The plan
    /// is for samples of this size.
    void (*paper)(const PaperPlan &plan, const Block &block, float *eta);
};

/// The loops for the best set of this machine. SUFFUSE_SIMD can name another one that it supports ("SSE2", "AVX2", …).
const Kernels &kernels();

} // namespace suffuse::cpu
