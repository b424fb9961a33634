// What programs of the gradient have in common: a segment's curve in pixels, and the weights of its nodes.
#pragma once

#include "render/cuda/gradient/gradient_records.h"
#include "render/cuda/warp.h"

#include <cmath>

namespace suffuse::cuda {

/// Nodes are looked for in tiles that are farther away by so many pixels, since places are rounded.
inline constexpr float gradientMargin = 0.02f;

struct GradientVector {
    double x, y;
};

/// The control points of a segment in pixels.
struct GradientCurve {
    double x[4], y[4];

    SUFFUSE_PROGRAM GradientCurve(const GradientSegment &s, const GradientView &view)
    {
        for (int i = 0; i < 4; ++i) {
            x[i] = view.xx * s.x[i] + view.xy * s.y[i] + view.shiftX;
            y[i] = view.yx * s.x[i] + view.yy * s.y[i] + view.shiftY;
        }
    }
    SUFFUSE_PROGRAM GradientVector sum(const double (&weights)[4]) const
    {
        GradientVector at{0, 0};
        for (int i = 0; i < 4; ++i)
            at.x += weights[i] * x[i], at.y += weights[i] * y[i];
        return at;
    }
};

/// What the weight of a segment's nodes is for φˢ = 1 and a speed of 1 pixel, but for that of the quadrature.
SUFFUSE_PROGRAM double gradientWeightScale(const GradientSegment &s, const GradientView &view)
{
    constexpr double pi = 3.14159265358979323846;
    const double spread = s.spread * view.scale;
    return (s.lift ? -1 : 1) * s.gain * view.scale / (pi * spread * spread);
}

} // namespace suffuse::cuda
