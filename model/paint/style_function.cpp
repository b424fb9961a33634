#include "model/paint/style_function.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

using Xi = std::array<double, 3>;

double uniform(double xi1, double xi2, double density)
{
    const auto logistic = [&](double phi) { return 1 / (1 + std::exp(-(phi - xi1) / xi2)); };
    const double start = std::max(0.0, xi1 - 8 * xi2);
    if (density <= start)
        return 0;
    const double lowest = logistic(start);
    return std::max(0.0, (logistic(density) - lowest) / (1 - lowest));
}

/// φ_e: the density at which (19), coming from inside, first reaches 1.
double edgeStart(const Xi &xi)
{
    const double a = std::pow(xi[1], 3), b = std::pow(xi[0], 6);
    return std::cbrt(2 * b / (a + std::sqrt(a * a - 4 * b * (1 - 1 / xi[2]))));
}

double edge(const Xi &xi, double density)
{
    if (density < edgeStart(xi))
        return 0;
    return std::clamp(xi[2] * (std::pow(xi[0] / density, 6) - std::pow(xi[1] / density, 3) + 1), 0.0, 1.0);
}

Xi xiOf(const Style &style)
{
    return {double(style.xi[0]), double(style.xi[1]), double(style.xi[2])};
}

} // namespace

double densityFunction(StyleKind kind, const std::array<double, 3> &xi, double density)
{
    if (!(density > 0))
        return 0;
    switch (kind) {
    case StyleKind::Uniform:
        return uniform(xi[0], xi[1], density);
    case StyleKind::Feathering:
        return std::min(1.0, std::pow(density / xi[0], xi[1]));
    case StyleKind::Edge:
        return edge(xi, density);
    }
    return 0;
}

double densityFunction(const Style &style, double density)
{
    return densityFunction(style.kind, xiOf(style), density);
}

double visibleCut(const Style &style)
{
    const Xi xi = xiOf(style);
    switch (style.kind) {
    case StyleKind::Uniform:
        return xi[0];
    case StyleKind::Feathering:
        return xi[0] * std::pow(2.0, -1 / xi[1]);
    case StyleKind::Edge:
        return edgeStart(xi);
    }
    return xi[0];
}

double leastInsideRim(const Style &style)
{
    const Xi xi = xiOf(style);
    return xi[2] * (1 - std::pow(xi[1] / xi[0], 6) / 4);
}

double plottedDensity(const Style &style)
{
    const Xi xi = xiOf(style);
    return style.kind == StyleKind::Uniform ? xi[0] + 6 * xi[1] : 2 * xi[0];
}

} // namespace suffuse
