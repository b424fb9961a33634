#include "model/paint/derived_figures.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

CurveDiffusion curveDiffusion(const Segment &segment)
{
    const double D = segment.diffusion;
    if (segment.isIsotropic())
        return {D, D};
    const Point tangent = tangentAt({{Point() + segment.bezier[0], Point() + segment.bezier[1],
                                      Point() + segment.bezier[2], Point() + segment.bezier[3]}},
                                    0.5);
    return {diffusionAcross(segment, {-tangent.y, tangent.x}), diffusionAcross(segment, tangent)};
}

DerivedFigures derivedFigures(const Segment &segment, const Style &style)
{
    DerivedFigures figures;
    const auto [along, across] = curveDiffusion(segment);
    const double phi = segment.density, cut = visibleCut(style), age = segment.maxAge;
    figures.spread = spreadAt(across, age);
    figures.along = spreadAt(along, age);
    figures.peak = peakDensity(phi, figures.spread);
    figures.halfWidth = halfWidth(across, phi, age, cut);
    const double t = fadingAge(across, phi, cut);
    if (t < age)
        figures.driesOut = t;
    return figures;
}

double takenShare(const Segment &segment)
{
    const double spread = spreadAt(curveDiffusion(segment).across, segment.maxAge);
    return -std::expm1(-peakDensity(segment.density, spread));
}

void setTakenShare(Segment &segment, double share)
{
    constexpr double mostPeak = 11; // It leaves a 60,000th.
    const double spread = spreadAt(curveDiffusion(segment).across, segment.maxAge);
    const double peak = std::min(-std::log1p(-share), mostPeak);
    segment.density = float(std::min(densityOfPeak(peak, spread), 1e12));
}

} // namespace suffuse
