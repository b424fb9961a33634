#include "render/contours/style_levels.h"

#include "model/paint/style_function.h"

#include <algorithm>
#include <cmath>

namespace suffuse::contours {

namespace {

/// A range of densities in which F only rises or only falls.
struct Slope {
    double from, to;
};

std::vector<Slope> slopesOf(const Style &style)
{
    const double xi1 = style.xi[0], xi2 = style.xi[1];
    switch (style.kind) {
    case StyleKind::Uniform:
        return {{std::max(0.0, xi1 - 8 * xi2), xi1 + 40 * xi2}};
    case StyleKind::Feathering:
        return {{0, xi1}};
    case StyleKind::Edge:
        break;
    }
    const double start = visibleCut(style), lowest = std::cbrt(2.0) * xi1 * xi1 / xi2;
    return lowest > start ? std::vector<Slope>{{start, lowest}, {lowest, 1e4 * lowest}}
                          : std::vector<Slope>{{start, 1e4 * start}};
}

/// Just behind a jump.
double behind(double density)
{
    return density * (1 + 1e-12);
}

/// Where F meets a level that it meets within a range.
double meets(const Style &style, Slope slope, double level)
{
    const bool rises = densityFunction(style, slope.to) >= level;
    double low = slope.from, high = slope.to;
    for (int i = 0; i < 200 && high - low > 1e-14 * high; ++i) {
        const double middle = high > 4 * low && low > 0 ? std::sqrt(low * high) : 0.5 * (low + high);
        ((densityFunction(style, middle) >= level) == rises ? high : low) = middle;
    }
    return high;
}

} // namespace

CoverageCurve::CoverageCurve(const Style &style)
    : m_kind(style.kind), m_xi{double(style.xi[0]), double(style.xi[1]), double(style.xi[2])}, m_start(0)
{
    if (m_kind == StyleKind::Edge)
        m_start = visibleCut(style);
    if (m_kind != StyleKind::Uniform)
        return;
    m_start = std::max(0.0, m_xi[0] - 8 * m_xi[1]);
    m_lowest = 1 / (1 + std::exp(-(m_start - m_xi[0]) / m_xi[1]));
}

CoverageCurve::Value CoverageCurve::at(double density) const
{
    if (!(density > m_start))
        return {};
    const auto [xi1, xi2, xi3] = m_xi;
    switch (m_kind) {
    case StyleKind::Uniform: {
        const double f = 1 / (1 + std::exp(-(density - xi1) / xi2)), gain = 1 / (1 - m_lowest);
        return {gain * (f - m_lowest), gain * f * (1 - f) / xi2};
    }
    case StyleKind::Feathering: {
        if (density >= xi1)
            return {1, 0};
        const double f = std::pow(density / xi1, xi2);
        return {f, xi2 * f / density};
    }
    case StyleKind::Edge:
        break;
    }
    const double a = xi1 / density, b = xi2 / density, a6 = a * a * a * a * a * a, b3 = b * b * b;
    return {std::clamp(xi3 * (a6 - b3 + 1), 0.0, 1.0), xi3 * (3 * b3 - 6 * a6) / density};
}

std::vector<double> crossingsOf(const Style &style, double level)
{
    std::vector<double> out;
    bool above = false;
    for (const Slope &slope : slopesOf(style)) {
        const bool begins = densityFunction(style, behind(slope.from)) >= level;
        if (begins != above)
            out.push_back(slope.from);
        above = densityFunction(style, slope.to) >= level;
        if (begins != above)
            out.push_back(meets(style, slope, level));
    }
    return out;
}

std::vector<CoverageStep> stepsOf(const Style &style, int count)
{
    std::vector<CoverageStep> out;
    const auto stepAt = [&](double density) { return int(std::lround(densityFunction(style, density) * count)); };
    int now = 0;
    for (const Slope &slope : slopesOf(style)) {
        const int begins = stepAt(behind(slope.from)), ends = stepAt(slope.to);
        if (begins != now)
            out.push_back({slope.from, double(begins) / count});
        for (now = begins; now != ends;) {
            const int next = now < ends ? now + 1 : now - 1;
            out.push_back({meets(style, slope, 0.5 * (now + next) / count), double(next) / count});
            now = next;
        }
    }
    return out;
}

} // namespace suffuse::contours
