#include "render/reference/style.h"

#include "render/reference/quadrature.h"

#include <algorithm>
#include <cmath>

namespace suffuse::reference {

namespace {

double logistic(double z)
{
    return z >= 0 ? 1 / (1 + std::exp(-z)) : std::exp(z) / (1 + std::exp(z));
}

double uniform(const Xi &xi, double density)
{
    const double cut = uniformCut(xi);
    if (density <= cut)
        return 0;
    const double floor = logistic((cut - xi[0]) / xi[1]);
    return std::max(0.0, (logistic((density - xi[0]) / xi[1]) - floor) / (1 - floor));
}

double feathering(const Xi &xi, double density)
{
    return density <= 0 ? 0 : density >= xi[0] ? 1 : std::pow(density / xi[0], xi[1]);
}

/// (19) without its cut, at u = ln φ.
double edgeAt(const Xi &xi, double u)
{
    const double sixth = std::exp(6 * (std::log(xi[0]) - u));
    const double third = std::exp(3 * (std::log(xi[1]) - u));
    return xi[2] * (sixth - third + 1);
}

/// ½ ∫ f(t) dt over [from, to] ⊂ [−1, 1], f smooth.
template <typename F>
double halfIntegral(double from, double to, F f)
{
    const GaussRule &rule = gauss10();
    double sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        sum += rule.weights[i] * f(from + (to - from) * rule.nodes[i]);
    return 0.5 * (to - from) * sum;
}

/// ln(1 + e^b) − ln(1 + e^a), b − a given exactly.
double softplusDifference(double a, double b, double difference)
{
    if (a > 0 && b > 0)
        return difference + std::log1p(std::exp(-b)) - std::log1p(std::exp(-a));
    const auto softplus = [](double z) { return std::max(z, 0.0) + std::log1p(std::exp(-std::abs(z))); };
    return softplus(b) - softplus(a);
}

double uniformMean(const Xi &xi, double density, double h)
{
    const double cut = uniformCut(xi);
    const double from = std::clamp((cut - density) / h, -1.0, 1.0);
    const double width = h * (1 - from);
    if (width <= 0.25 * xi[1])
        return halfIntegral(from, 1, [&](double t) { return uniform(xi, density + h * t); });
    const double floor = logistic((cut - xi[0]) / xi[1]);
    const double a = (density + h * from - xi[0]) / xi[1], b = (density + h - xi[0]) / xi[1];
    return (xi[1] * softplusDifference(a, b, width / xi[1]) - floor * width) / (1 - floor) / (2 * h);
}

double featheringMean(const Xi &xi, double density, double h)
{
    const double from = std::clamp(-density / h, -1.0, 1.0);
    const double full = std::clamp((xi[0] - density) / h, -1.0, 1.0); // F = 1 from here on
    const double a = std::max(0.0, density + h * from), b = std::max(0.0, density + h * full);
    double below = 0;
    if (full > from) {
        if ((xi[1] + 1) * h * (full - from) <= 0.5 * a) {
            below = halfIntegral(from, full, [&](double t) { return feathering(xi, density + h * t); });
        } else {
            const double power = xi[1] + 1;
            below = xi[0] / power * (std::pow(b / xi[0], power) - std::pow(a / xi[0], power)) / (2 * h);
        }
    }
    return below + 0.5 * (1 - full);
}

double edgeMean(const Xi &xi, double density, double h)
{
    if (density <= 0)
        return 0;
    const double u = std::log(density);
    const double q = std::min(h / density, 2.0);
    const double from = std::clamp((std::log(edgeCut(xi)) - u) / q, -1.0, 1.0);
    const double width = q * (1 - from);
    if (width <= 0)
        return 0;
    if (width <= 0.1)
        return halfIntegral(from, 1, [&](double t) { return edgeAt(xi, u + q * t); });
    const double a = u + q * from, b = u + q;
    const auto third = [&](double v) { return std::exp(3 * (std::log(xi[1]) - v)); };
    const auto sixth = [&](double v) { return std::exp(6 * (std::log(xi[0]) - v)); };
    return xi[2] * (width + (third(b) - third(a)) / 3 - (sixth(b) - sixth(a)) / 6) / (2 * q);
}

/// The mean of (19) over densities, not over their logarithms.
double edgeMeanOverDensity(const Xi &xi, double density, double h)
{
    const double low = std::max(edgeCut(xi), density - h), high = density + h;
    if (high <= low)
        return 0;
    // The antiderivative loses digits if the range is short relative to the density.
    if (high - low <= 0.05 * low)
        return halfIntegral((low - density) / h, 1, [&](double t) { return edgeAt(xi, std::log(density + h * t)); });
    const auto antiderivative = [&](double v) {
        return v + xi[1] * std::pow(xi[1] / v, 2) / 2 - xi[0] * std::pow(xi[0] / v, 5) / 5;
    };
    return xi[2] * (antiderivative(high) - antiderivative(low)) / (2 * h);
}

} // namespace

double uniformCut(const Xi &xi)
{
    return std::max(0.0, xi[0] - 8 * xi[1]);
}

double edgeCut(const Xi &xi)
{
    // With y = (ξ1/φ)³, F = 1 is y² − (ξ2/ξ1)³ y + 1 − 1/ξ3 = 0; the larger root is the first from inside.
    const double ratio = std::pow(xi[1] / xi[0], 3);
    const double y = 0.5 * (ratio + std::sqrt(ratio * ratio - 4 * (1 - 1 / xi[2])));
    return xi[0] * std::pow(y, -1.0 / 3);
}

double densityFunction(StyleKind kind, const Xi &xi, double density)
{
    switch (kind) {
    case StyleKind::Uniform:
        return uniform(xi, density);
    case StyleKind::Feathering:
        return feathering(xi, density);
    case StyleKind::Edge:
        break;
    }
    return density < edgeCut(xi) ? 0 : std::clamp(edgeAt(xi, std::log(density)), 0.0, 1.0);
}

double densityFunctionMean(StyleKind kind, const Xi &xi, double density, double h, double lifted)
{
    if (h <= 1e-15 * std::abs(density) || h <= 0)
        return reference::densityFunction(kind, xi, density);
    double mean = 0;
    switch (kind) {
    case StyleKind::Uniform:
        mean = uniformMean(xi, density, h);
        break;
    case StyleKind::Feathering:
        mean = featheringMean(xi, density, h);
        break;
    case StyleKind::Edge:
        mean = edgeMean(xi, density, h);
        if (const double share = std::min(1.0, 2 * lifted); share > 0)
            mean += share * (std::clamp(edgeMeanOverDensity(xi, density, h), 0.0, 1.0) - std::clamp(mean, 0.0, 1.0));
        break;
    }
    return std::clamp(mean, 0.0, 1.0);
}

} // namespace suffuse::reference
