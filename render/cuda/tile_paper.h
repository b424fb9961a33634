// This finds the paper texture at a sample (16).
#pragma once

#include "render/cuda/records.h"
#include "render/cuda/warp.h"
#include "render/math/paper.h"

namespace suffuse::cuda {

/// Converts pixels of the picture to canvas units.
SUFFUSE_PROGRAM void toCanvas(const Frame &frame, double X, double Y, double &x, double &y)
{
    const ToCanvas &m = frame.toCanvas;
    x = m.x0 + m.xx * X + m.xy * Y;
    y = m.y0 + m.yx * X + m.yy * Y;
}

/// Returns η of a sample at (X, Y) that is `step` wide, all in pixels.
SUFFUSE_CALL float etaAt(const Frame &frame, double X, double Y, float step)
{
    const PaperParams &p = frame.paper;
    double x, y;
    toCanvas(frame, X, Y, x, y);
    const double strength = double(p.strength);
    if (p.kind == 1)
        return float(math::proceduralPaper(x, y, double(step) * frame.toCanvas.px, p.grain, p.seed, p.scale, strength));
    return p.grey ? float(math::imagePaper(x, y, p.grey, p.width, p.height, p.scale, strength)) : 1.0f;
}

} // namespace suffuse::cuda
