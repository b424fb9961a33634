// The inner loops, compiled for several SIMD instruction sets; the best one for this machine is chosen at run time.
#pragma once

#include "render/scene/node_boxes.h"
#include "render/math/shade_params.h"

#include <cstdint>
#include <cstring>
#include <span>

namespace suffuse::cpu {

/// Samples are evaluated in blocks of 16 × 16.
inline constexpr int blockSide = 16;
inline constexpr int blockSize = blockSide * blockSide;
/// Node distances are taken from the centres of cells of 8 × 8 samples whose corners lie on the picture's 8-pixel grid,
/// so that a sample's bits do not depend on the tile it is evaluated in.
inline constexpr int cellSide = 8;

/// A node in pixels of the picture. Separable: b = 0.
struct ViewNode {
    double x = 0, y = 0;
    float a = 0, b = 0, c = 0; ///< metric, px⁻²
    float weight = 0;          ///< density at its centre
    float cut = 0;             ///< e^(−R²)
    std::uint32_t row = 0;     ///< of the stroke's channel values
    friend bool operator==(const ViewNode &, const ViewNode &) = default;
};

/// A rectangle of pixels as centre and half-sizes.
struct Area {
    double x = 0, y = 0;
    double halfWidth = 0, halfHeight = 0;
};

/// Square cells side by side, the first at (x, y): at most gridSide columns and rows.
inline constexpr int gridSide = 4;
struct Grid {
    double x = 0, y = 0;
    double side = blockSide; ///< of a cell
    int columns = 1, rows = 1;
};

/// How many nodes meet an area, and upper bounds of their φ and |∇φ| (per pixel) over it.
struct Meeting {
    int count = 0;
    float density = 0;
    float slope = 0;

    Meeting &operator+=(const Meeting &other)
    {
        count += other.count, density += other.density, slope += other.slope;
        return *this;
    }
};

/// Sample (i, j) lies at (x + (i+½)·step, y + (j+½)·step), in pixels.
struct Block {
    double x = 0, y = 0;
    double step = 1;
};

/// Sums at the samples of a block (render/math/shade_params.h).
struct Sums {
    alignas(64) float v[fixedSums + maxChannels][blockSize];

    /// The first rows, one after the other; there may be none.
    void take(std::span<const float> rows)
    {
        if (!rows.empty())
            std::memcpy(v, rows.data(), rows.size_bytes());
    }
    void give(std::span<float> rows) const { std::memcpy(rows.data(), v, rows.size_bytes()); }
};

/// Opacity w = F·C̄_opacity and colour C̄ at the samples of a block.
struct Shaded {
    alignas(64) float w[blockSize];
    alignas(64) float colour[3][blockSize];
};

/// A block of the picture while strokes are mixed into it: RYB backdrop, and coverage where the picture is transparent.
struct Backdrop {
    alignas(64) float ryb[3][blockSize];
    alignas(64) float coverage[blockSize];
    bool transparent = false;
};

/// A run of strokes as one map of the backdrop: B ← min(limit, keep·B + add), coverage a ← hold·a + gain. Such maps
/// compose (docs/solver.md, "Layers").
struct OverMap {
    alignas(64) float keep[3][blockSize];
    alignas(64) float add[3][blockSize];
    alignas(64) float limit[3][blockSize];
    alignas(64) float hold[blockSize];
    alignas(64) float gain[blockSize];
};

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
