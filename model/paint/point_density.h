// Density at a point (eq 13, 14), quickly: for tools and panels. render/probe.h has the exact figures.
#pragma once

#include "model/painting/stroke.h"

namespace suffuse {

/// How near a segment's curve its straight pieces stay, in spreads; the density is off by about half as much of its
/// peak.
enum class CurveDetail {
    Rough, ///< 0.03: what hit tests ask thousands of times
    Fine   ///< 0.001: figures and plots
};

/// φ_k of a segment of a spread s > 0, at a point as seen from its stroke's origin. The curve counts as straight
/// pieces, whose density has a closed form.
double segmentDensity(const Segment &segment, double spread, Point fromOrigin, CurveDetail detail);

/// Whether the influence of a segment of a spread (`influenceOf`) reaches a point as seen from its stroke's origin.
bool reaches(const Segment &segment, double spread, Point fromOrigin);

/// φ_k of a segment at a canvas point, fine; 0 where it is not there yet, and out of its reach.
double segmentDensityAt(const Stroke &stroke, const Segment &segment, Microseconds time, Point point);
/// φ = max(0, φ⁺ − φ⁻) of the stroke.
double strokeDensityAt(const Stroke &stroke, Microseconds time, Point point);

} // namespace suffuse
