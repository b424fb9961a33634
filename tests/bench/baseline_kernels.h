// Inner loops of the baselines, compiled for several SIMD instruction sets as the renderer's own are.
#pragma once

#include "model/painting/style.h"

namespace suffuse::baseline {

/// Planes of a row or grid have room for so many floats past their end.
inline constexpr int padding = 16;

/// A segment's quadrature along one row of pixels: φ_k(x) = Σ 2^(exponent_i − (scale·x + offset_i)²).
struct RowQuadrature {
    int nodes = 0; ///< 5 or 8
    float scale = 0;
    float offset[8] = {};
    float exponent[8] = {}; ///< weight and distance across the row
    int first = 0;          ///< pixels [first, last)
    int last = 0;
};

/// How density becomes opacity, and how that is mixed: one style a stroke, no paper.
struct StrokeShade {
    Style style;
    Colour colour;       ///< of all its segments, where `varies` is false
    bool varies = false; ///< colours are sums
    float keep = 1;      ///< eq 23: 1 − β
};

/// Sums of a stroke along a row: φ, then Σφ_kC_k for R, Y, B, opacity where they vary.
inline constexpr int sumPlanes = 5;

struct BaselineKernels {
    const char *name;
    /// Adds a segment to the sums of a row; `colour` (4 values) is null for strokes of one colour.
    void (*addSegment)(const RowQuadrature &row, const float *colour, float *const *sums);
    /// Eq 17-23 for pixels [first, last) of a row: mixes the stroke into the RYB planes of the backdrop.
    void (*mixStroke)(const StrokeShade &shade, const float *const *sums, int first, int last, float *const *backdrop);
    /// RYB planes to straight RGBA, 4 floats a pixel.
    void (*finishRow)(const float *const *backdrop, int width, float *rgba);
    /// `steps` implicit Euler steps of u ← (1 − r ∂²)⁻¹u down the columns of a grid; u = 0 outside. `factors`: 2·rows
    /// floats of work space.
    void (*diffuseColumns)(float *grid, int stride, int columns, int rows, float r, int steps, float *factors);
    /// `rounds` times 12 independent vector multiply-adds from registers; returns how many lanes were added.
    long long (*multiplyAdds)(long long rounds, float *sink);
};

/// The best set for this machine.
const BaselineKernels &baselineKernels();

} // namespace suffuse::baseline
