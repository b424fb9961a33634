// Affine maps of strokes, and what becomes of their spread.
#pragma once

#include "model/painting/affine.h"
#include "model/painting/stroke.h"

#include <optional>

namespace suffuse {

/// Whether spread and density follow the shape.
enum class SpreadRule {
    Scales, ///< the picture is mapped: D·k², φ·k; uneven maps make a tensor A·D·Aᵀ
    Stays,  ///< the curve alone is mapped
};

/// The mapped stroke. Translations move the origin alone. Under uneven maps that scale the spread, φ′ = φ·|det A|·l/l′
/// by lengths, and segments are split (exactly) into as few as keep the dry density within half a per cent: |dl|/|dl′|
/// varies by at most 1 % in a part that is longer than the spread s, by 0.07·s/l in a shorter one of length l.
/// `sources`: for each segment of the result, the index of that it came from. None if the map is not invertible or a
/// value leaves its domain.
std::optional<Stroke> tryTransformed(const Stroke &stroke, const Affine &map, SpreadRule rule,
                                     std::vector<int> *sources = nullptr);
/// The same; the stroke itself where it cannot be.
Stroke transformed(const Stroke &stroke, const Affine &map, SpreadRule rule);

/// The curves' own box, exact; without their spread. Canvas units.
Rect curveBox(const Cubic &cubic);
Rect curveBox(const Stroke &stroke);
/// Around all control points, which is quicker; canvas units.
Rect controlBox(const Stroke &stroke);

} // namespace suffuse
