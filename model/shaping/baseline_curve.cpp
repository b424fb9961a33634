#include "model/shaping/baseline_curve.h"

namespace suffuse {

namespace {

constexpr int curveSteps = 32; ///< of each curve; between them the length is taken for even

/// The length of a part of a curve, by Gauss's rule with five points.
double lengthBetween(const Cubic &curve, double from, double to)
{
    constexpr std::array<std::pair<double, double>, 5> rule{{{0, 128.0 / 225},
                                                             {0.5384693101056831, 0.47862867049936647},
                                                             {-0.5384693101056831, 0.47862867049936647},
                                                             {0.906179845938664, 0.23692688505618908},
                                                             {-0.906179845938664, 0.23692688505618908}}};
    double sum = 0;
    for (const auto &[x, weight] : rule)
        sum += weight * length(curve.derivative(0.5 * (from + to) + 0.5 * (to - from) * x));
    return 0.5 * (to - from) * sum;
}

} // namespace

BaselineCurve::BaselineCurve(const std::vector<Cubic> &curves)
{
    for (const Cubic &curve : curves)
        if (polygonLength(curve) > 0)
            m_curves.push_back(curve);
    double along = 0;
    for (std::size_t k = 0; k < m_curves.size(); ++k) {
        m_at.push_back({along, k, 0});
        for (int i = 0; i < curveSteps; ++i) {
            along += lengthBetween(m_curves[k], double(i) / curveSteps, double(i + 1) / curveSteps);
            m_at.push_back({along, k, double(i + 1) / curveSteps});
        }
    }
}

BaselineCurve::Place BaselineCurve::placeOn(std::size_t curve, double t) const
{
    const Cubic &c = m_curves[curve];
    Point way = c.derivative(t);
    // Where a handle lies on its node, the direction is that towards the next point.
    for (const auto &[from, to] : {std::pair(t < 0.5 ? 0 : 1, t < 0.5 ? 2 : 3), std::pair(0, 3)})
        if (!(suffuse::length(way) > 1e-9 * polygonLength(c)))
            way = c.p[std::size_t(to)] - c.p[std::size_t(from)];
    const double norm = suffuse::length(way);
    return {c.at(t), norm > 0 ? (1 / norm) * way : Point{1, 0}};
}

BaselineCurve::Place BaselineCurve::at(double along) const
{
    if (m_at.empty())
        return {{along, 0}, {1, 0}};
    const bool isBefore = along <= 0;
    if (isBefore || along >= length()) {
        Place end = isBefore ? placeOn(0, 0) : placeOn(m_curves.size() - 1, 1);
        end.point = end.point + (isBefore ? along : along - length()) * end.direction;
        return end;
    }
    const auto next = std::upper_bound(m_at.begin(), m_at.end(), along,
                                       [](double value, const Step &step) { return value < step.length; });
    const Step &to = *next, &from = *(next - 1);
    double t = from.t + (to.t - from.t) * (along - from.length) / (to.length - from.length);
    // One step of Newton's rule.
    if (const double speed = suffuse::length(m_curves[to.curve].derivative(t)); speed > 0)
        t = std::clamp(t - (from.length + lengthBetween(m_curves[to.curve], from.t, t) - along) / speed, from.t, to.t);
    return placeOn(to.curve, t);
}

} // namespace suffuse
