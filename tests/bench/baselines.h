// The methods that Suffuse is compared with, at their best on this machine. For measurements and tests only.
#pragma once

#include "render/renderer.h"
#include "tests/bench/baseline_kernels.h"

namespace suffuse::baseline {

/// The paper's method as its section 6.1 has it: every pixel integrates every segment whose midpoint is within
/// 0.5 l + 0.1 W (W: the picture's width), by a Gauss rule of `nodes` (5 or 8) points. A row of pixels at a time, in
/// SIMD; rows are shared out to `threads` (0: all cores). Of the contract it leaves out: coverage (a pixel shows its
/// centre), paper, segments' own styles, anisotropy. 4 floats a pixel.
std::vector<float> paperMethod(const RenderRequest &request, int nodes, int threads);

/// Finite differences: each stroke's line density is laid on the pixel grid and diffused by `steps` implicit Euler
/// steps, direction by direction, in its own bounding box and 4 s around it; strokes side by side on `threads`. Leaves
/// out what `paperMethod` does. 4 floats a pixel.
std::vector<float> finiteDifferences(const RenderRequest &request, int steps, int threads);

/// Milliseconds that libmypaint takes for dabs along the same points, radius 1.2 s (6 to 24 px), on one core. Negative
/// where this program was built without libmypaint.
double myPaintReplay(const RenderRequest &request);

/// What both field methods share.
StrokeShade shadeOf(const Stroke &stroke);
/// Planes of one row: a backdrop or sums.
struct RowPlanes {
    std::vector<float> values;
    std::vector<float *> plane;
    RowPlanes(RowPlanes &&) = default;
    RowPlanes(int planes, int width)
        : values(std::size_t(planes) * std::size_t(width + padding), 0.0f), plane(std::size_t(planes))
    {
        for (std::size_t i = 0; i < plane.size(); ++i)
            plane[i] = values.data() + i * std::size_t(width + padding);
    }
};
/// A row of the canvas before strokes: the background over white.
RowPlanes backgroundRow(const Canvas &canvas, int width);

} // namespace suffuse::baseline
