// Maps strokes by affine maps, with their spread or without it.
#pragma once

#include "model/geometry/affine.h"
#include "model/painting/stroke.h"

#include <optional>

namespace suffuse {

/// Whether spread and density follow the map.
enum class SpreadRule {
    Scales, ///< The picture is mapped: D·k², φ·k; uneven maps make a tensor A·D·Aᵀ.
    Stays,  ///< Only the curve is mapped.
};

/// The mapped stroke. Translations move only the origin. If an uneven map scales the spread, φ′ = φ·|det A|·l/l′ by
/// lengths, and segments are split (exactly) into as few parts as keep the dry density right to half a per cent:
/// |dl|/|dl′| varies by at most 1 % in a part that is longer than the spread s, and by 0.07·s/l in a shorter one of
/// length l. `sources` gets, for each segment of the result, the index of the segment that it came from. No value if
/// the map is not invertible or a value would leave its domain.
std::optional<Stroke> tryTransformed(const Stroke &stroke, const Affine &map, SpreadRule rule,
                                     std::vector<int> *sources = nullptr);
/// The mapped stroke, or the stroke itself where the result would have no value.
Stroke transformed(const Stroke &stroke, const Affine &map, SpreadRule rule);

/// The exact box of the curves, without their spread. Canvas units.
Rect curveBox(const Cubic &cubic);
Rect curveBox(const Stroke &stroke);
/// The box of all control points, which is quicker and never smaller. Canvas units.
Rect controlBox(const Stroke &stroke);

} // namespace suffuse
