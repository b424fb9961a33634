#include "app/panels/density_function.h"

#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

double uniform(double xi1, double xi2, double density)
{
    const auto logistic = [&](double phi) { return 1 / (1 + std::exp(-(phi - xi1) / xi2)); };
    const double start = std::max(0.0, xi1 - 8 * xi2);
    if (density <= start)
        return 0;
    const double lowest = logistic(start);
    return std::max(0.0, (logistic(density) - lowest) / (1 - lowest));
}

} // namespace

double densityFunction(const Style &style, double density)
{
    const double xi1 = style.xi[0], xi2 = style.xi[1], xi3 = style.xi[2];
    if (!(density > 0))
        return 0;
    switch (style.kind) {
    case StyleKind::Uniform:
        return uniform(xi1, xi2, density);
    case StyleKind::Feathering:
        return std::min(1.0, std::pow(density / xi1, xi2));
    case StyleKind::Edge:
        if (density < visibleCut(style))
            return 0;
        return std::clamp(xi3 * (std::pow(xi1 / density, 6) - std::pow(xi2 / density, 3) + 1), 0.0, 1.0);
    }
    return 0;
}

CurveDiffusion curveDiffusion(const Segment &segment)
{
    const double D = segment.diffusion;
    if (segment.isIsotropic())
        return {D, D};
    const Cubic curve{{Point() + segment.bezier[0], Point() + segment.bezier[1], Point() + segment.bezier[2],
                       Point() + segment.bezier[3]}};
    Point tangent = curve.derivative(0.5);
    if (tangent == Point())
        tangent = curve.p[3] - curve.p[0];
    if (tangent == Point())
        tangent = {1, 0};
    return {diffusionAcross(segment, {-tangent.y, tangent.x}), diffusionAcross(segment, tangent)};
}

DerivedFigures derivedFigures(const Segment &segment, const Style &style)
{
    DerivedFigures figures;
    const auto [along, D] = curveDiffusion(segment);
    const double phi = segment.density, cut = visibleCut(style);
    figures.spread = std::sqrt(4 * D * double(segment.maxAge));
    figures.along = std::sqrt(4 * along * double(segment.maxAge));
    figures.peak = phi / (std::sqrt(std::numbers::pi) * figures.spread);
    figures.halfWidth = halfWidth(D, phi, double(segment.maxAge), cut);
    const double t = fadingAge(D, phi, cut);
    if (t < double(segment.maxAge))
        figures.driesOut = t;
    return figures;
}

double densityForPeak(double peak, double diffusion, double maxAge)
{
    return peak * std::sqrt(std::numbers::pi * 4 * diffusion * maxAge);
}

} // namespace suffuse
