// What the inner loops read and write: blocks of samples, and the areas for which nodes are chosen.
#pragma once

#include "render/math/shade_params.h"
#include "render/scene/node_boxes.h"

#include <cstdint>
#include <cstring>
#include <span>

namespace suffuse::cpu {

/// Samples are evaluated in blocks of 16 × 16.
inline constexpr int blockSide = 16;
inline constexpr int blockSize = blockSide * blockSide;
/// The distances of nodes are measured from the centres of cells of 8 × 8 samples, whose corners lie on the picture's
/// 8-pixel grid. So the bits of a sample do not depend on the tile in which it is evaluated.
inline constexpr int cellSide = 8;
inline constexpr int cellSize = cellSide * cellSide;

/// A rectangle of pixels, as its centre and half-sizes.
struct Area {
    double x = 0, y = 0;
    double halfWidth = 0, halfHeight = 0;
};

/// Square cells side by side, the first one at (x, y). A grid has at most gridSide columns and rows.
inline constexpr int gridSide = 4;
struct Grid {
    double x = 0, y = 0;
    double side = blockSide; ///< of a cell
    int columns = 1, rows = 1;
};

/// How many nodes meet an area, and upper bounds of their φ and |∇φ| (per pixel) in it.
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

/// Nodes of a stroke whose sums are wanted, as indices that rise: separable ones that lay paint, that lift it, that
/// fade it; oblique ones.
struct ListedNodes {
    const ViewNode *nodes = nullptr;
    const std::uint32_t *at = nullptr;
    int laying = 0, painted = 0, separable = 0,
        count = 0;                 ///< of `at`, how many come before the lifting, the fading, the oblique ones; all
    const float *values = nullptr; ///< rows of `channels` floats
    int channels = 0;
    int painting = 0;  ///< how many channels come before φ_f, which is the last one if it is there
    bool laid = false; ///< whether the last of these is φ⁺
};

/// Sample (i, j) lies at (x + (i+½)·step, y + (j+½)·step), in pixels.
struct Block {
    double x = 0, y = 0;
    double step = 1;
};

/// Sums at the samples of a block (render/math/shade_params.h).
struct Sums {
    alignas(64) float v[fixedSums + maxChannels][blockSize];

    /// Takes over the first rows, which follow each other. There may be none.
    void take(std::span<const float> rows)
    {
        if (!rows.empty())
            std::memcpy(v, rows.data(), rows.size_bytes());
    }
    void give(std::span<float> rows) const { std::memcpy(rows.data(), v, rows.size_bytes()); }
};

/// What is needed to sum up a fill of density 1 in a cell, relative to its centre (render/scene/scene_fill.h).
struct FillCell {
    float a = 1, b = 0, c = 1; ///< u = a·dx + b·dy, v = c·dy
    float step = 1;            ///< size of a sample, pixels
    float entered = 0;         ///< what lies inside at the corner left above all that counts
    const float *eventY = nullptr, *eventJump = nullptr;
    int events = 0;
    const float *x = nullptr, *y = nullptr, *weight = nullptr; ///< nodes
    int nodes = 0;
};

/// The density, between 0 and 1, and its slopes per pixel.
struct FillCellSums {
    alignas(64) float density[cellSize];
    alignas(64) float slopeX[cellSize];
    alignas(64) float slopeY[cellSize];
};

/// What is done of a block whose pixels are told from centres: all, and it is mixed; all, but not mixed; or some
/// samples are still to be evaluated.
enum class ToldBlock { Mixed, Shaded, SomeLeft };

/// Opacity w = F·C̄_opacity and colour C̄ at the samples of a block.
struct Shaded {
    alignas(64) float w[blockSize];
    alignas(64) float colour[3][blockSize];
};

/// A block of the picture while strokes are mixed into it: RYB backdrop, and coverage if it is asked for.
struct Backdrop {
    alignas(64) float ryb[3][blockSize];
    alignas(64) float coverage[blockSize];
    bool hasCoverage = false; ///< whether the coverage counts: in transparent pictures, and where there are layers
};

/// The picture of a layer, kept to be put again and again: straight RGB and coverage, in steps of 1/65535. It is half
/// of a backdrop's bytes, since reading them is what putting it costs, and nothing is to be converted.
struct LayerPicture {
    std::uint32_t shown = 0; ///< the rows in which it covers anything, a bit each
    /// Rows of the block, each of which has its reds, greens, blues and coverages: it is read from end to end.
    alignas(64) std::uint16_t rows[blockSide][4][blockSide];

    /// A channel (red, green, blue, coverage) of sample `sample` and those after it in its row.
    std::uint16_t *at(int channel, int sample) { return &rows[sample / blockSide][channel][sample % blockSide]; }
    const std::uint16_t *at(int channel, int sample) const
    {
        return &rows[sample / blockSide][channel][sample % blockSide];
    }
};

/// A run of strokes as one map of the backdrop: B ← min(limit, keep·B + add), coverage a ← hold·a + gain. Such maps can
/// be composed (docs/solver.md, "Layers").
struct OverMap {
    alignas(64) float keep[3][blockSize];
    alignas(64) float add[3][blockSize];
    alignas(64) float limit[3][blockSize];
    alignas(64) float hold[blockSize];
    alignas(64) float gain[blockSize];

    /// Makes it the map of no strokes.
    void clear()
    {
        for (int c = 0; c < 3; ++c) {
            std::fill_n(keep[c], blockSize, 1.0f);
            std::fill_n(add[c], blockSize, 0.0f);
            std::fill_n(limit[c], blockSize, 1.0f);
        }
        std::fill_n(hold, blockSize, 1.0f);
        std::fill_n(gain, blockSize, 0.0f);
    }
};

} // namespace suffuse::cpu
