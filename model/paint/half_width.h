// How wide a long straight stroke is to the eye, and the values that make it so wide (closed forms).
#pragma once

#include "model/paint/style_function.h"
#include "model/painting/stroke.h"

namespace suffuse {

/// s = √(4Dt), units.
double spreadAt(double diffusion, double age);
/// The peak pk = φˢ/(√π s) of a long straight stroke's density, and the φˢ of a peak.
double peakDensity(double density, double spread);
double densityOfPeak(double peak, double spread);

/// The curve's direction at a parameter, of length 1; where it stands still there, that of its middle, else of its
/// chord, and to the right for a point.
Point tangentAt(const Cubic &cubic, double t);

/// D across a line along `tangent` (any length but 0): nᵀDn for its normal n.
double diffusionAcross(const Segment &segment, Point tangent);

/// w = s √ln(φˢ/(ξ √π s)), s = √(4Dt), for the cut ξ; 0 where the peak density is not above the cut, or t ≤ 0.
double halfWidth(double diffusion, double density, double age, double cut);

/// The greatest half-width that any D gives, φˢ/(ξ √(2πe)), at the age t*/e.
double greatestHalfWidth(double density, double cut);

/// The age t* = φˢ²/(4πDξ²) at which the peak density falls to the cut: the stroke has faded.
double fadingAge(double diffusion, double density, double cut);

struct WidthValues {
    double diffusion = 0;
    double density = 0;
};
/// D as it is and the φˢ that gives the half-width w ≥ 0 at age t > 0; beyond w = 2s, where φˢ would explode, s = w/2
/// and φˢ in proportion to it.
WidthValues valuesForHalfWidth(double halfWidth, double diffusion, double age, double cut);

/// The D that alone gives the half-width w > 0 at age t > 0: the smaller of the two, at which more D is wider still.
/// w is clamped to `greatestHalfWidth`.
double diffusionForHalfWidth(double halfWidth, double density, double age, double cut);

/// Box of what is seen of the dry stroke, canvas units: its curves, the half-widths beside them, and as far beyond the
/// ends of its chains as paint is seen there. What takes paint away is left out of account. Exact for a straight stroke
/// of one width; of a short one all is narrower, by the density that its length lacks.
Rect seenBox(const Stroke &stroke);

/// Lambert's W on its lower branch: the y ≤ −1 with y·e^y = x, for x in [−1/e, 0).
double lowerLambertW(double x);

} // namespace suffuse
