// How wide a long straight stroke is to the eye, and the values that make it so wide (closed forms).
#pragma once

#include "model/paint/style_function.h"
#include "model/painting/stroke.h"

namespace suffuse {

/// s = √(4Dt), units.
double spreadAt(double diffusion, double age);
/// The peak pk = φˢ/(√π s) of the density of a long straight stroke, and the φˢ that has a peak.
double peakDensity(double density, double spread);
double densityOfPeak(double peak, double spread);

/// The direction of a curve at a parameter, of length 1. Where the curve stands still there, it is the direction in the
/// middle, else that of the chord; for a point it is to the right.
Point tangentAt(const Cubic &cubic, double t);

/// D across a line along `tangent` (any length but 0): nᵀDn for its normal n.
double diffusionAcross(const Segment &segment, Point tangent);

/// w = s √ln(φˢ/(ξ √π s)), s = √(4Dt), for the cut ξ; 0 where the peak density is not above the cut, or t ≤ 0.
double halfWidth(double diffusion, double density, double age, double cut);

/// The greatest half-width over all D, φˢ/(ξ √(2πe)), which is reached at the age t*/e.
double greatestHalfWidth(double density, double cut);

/// The age t* = φˢ²/(4πDξ²) at which the peak density has fallen to the cut, so that the stroke has faded.
double fadingAge(double diffusion, double density, double cut);

struct WidthValues {
    double diffusion = 0;
    double density = 0;
};
/// The values that give the half-width w ≥ 0 at age t > 0: D as it is, and the φˢ for it. Beyond w = 2s, where φˢ would
/// explode, s = w/2 and φˢ is in proportion to it.
WidthValues valuesForHalfWidth(double halfWidth, double diffusion, double age, double cut);

/// The D that gives the half-width w > 0 at age t > 0 with the same φˢ. Of the two solutions it is the smaller, at
/// which more D makes the stroke wider. w is clamped to `greatestHalfWidth`.
double diffusionForHalfWidth(double halfWidth, double density, double age, double cut);

/// The box of what is seen of the dry stroke, canvas units: its curves, the half-widths beside them, and what is seen
/// beyond the ends of its chains. Segments that take paint away do not count. It is exact for a straight stroke of one
/// width. A short stroke is narrower, since its density lacks the rest of the line.
Rect seenBox(const Stroke &stroke);

/// Lambert's W on its lower branch: the y ≤ −1 with y·e^y = x, for x in [−1/e, 0).
double lowerLambertW(double x);

} // namespace suffuse
