// The diffusion tensor of a segment or a fill: D·ratio along its angle, D across it.
#pragma once

#include "model/geometry/affine.h"
#include "model/painting/fill.h"

namespace suffuse {

/// A symmetric tensor (xx xy; xy yy), unit²/s.
struct Tensor {
    double xx = 0, xy = 0, yy = 0;
    friend Tensor operator+(const Tensor &a, const Tensor &b) { return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy}; }
    friend Tensor operator*(double k, const Tensor &t) { return {k * t.xx, k * t.xy, k * t.yy}; }
};

Tensor tensorOf(const Segment &segment);
Tensor tensorOf(const Fill &fill);
/// Sets diffusion, ratio (≥ 1) and angle (of the longer axis) from the tensor's eigenvalues.
void setTensor(Segment &segment, const Tensor &tensor);
void setTensor(Fill &fill, const Tensor &tensor);
/// M·T·Mᵀ.
Tensor mapped(const Tensor &tensor, const Affine &map);

} // namespace suffuse
