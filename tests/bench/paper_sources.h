// A painting as the paper's method reads it: segments in pixels with their quadrature points. For all its baselines.
#pragma once

#include "render/renderer.h"
#include "tests/bench/baseline_kernels.h"

namespace suffuse::baseline {

/// A Gauss-Legendre rule on [0, 1] of up to 8 points.
struct Rule {
    double x[8];
    double weight[8];
};
Rule gaussRule(int points);

/// A segment in pixels.
struct Source {
    Cubic cubic;
    double x = 0, y = 0; ///< midpoint
    double reach = 0;    ///< 0.5 l + 0.1 W
    double spread = 0;   ///< s
    double density = 0;  ///< φˢ
    float scale = 0;     ///< √(log₂e)/s
    float nodeX[8];
    float nodeY[8];
    float exponent[8]; ///< log₂ of the node's density
    float colour[4];
};

struct SourceStroke {
    StrokeShade shade;
    std::vector<Source> sources;
    Rect reach; ///< of all of them
};

/// All visible strokes in document order, segments that are there at the request's time; a rule of `nodes` points (5 or
/// 8); on `threads` (0: all cores).
std::vector<SourceStroke> paperSources(const RenderRequest &request, int nodes, int threads);

/// Pixels [first, last) of a row whose centres lie within the segment's reach; none: first = last.
struct RowSpan {
    int first = 0;
    int last = 0;
};
RowSpan reachOnRow(const Source &source, int row, int width);

} // namespace suffuse::baseline
