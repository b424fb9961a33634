#include "model/shaping/baseline_curve.h"

#include <utility>

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

double BaselineCurve::besides(Point point, double near) const
{
    // How far the point lies ahead falls along the chain. Its zero is enclosed, and then sought by the Illinois rule.
    constexpr int mostSteps = 60;
    constexpr double grows = 1.5, exact = 1e-10;
    const auto ahead = [&](double along) {
        const Place place = at(along);
        return dot(point - place.point, place.direction);
    };
    double from = near, to = near, atFrom = ahead(near), atTo = atFrom;
    const double scale = suffuse::length(point - at(near).point) + std::abs(near), way = atFrom < 0 ? -1 : 1;
    double step = std::max(std::abs(atFrom), exact * scale);
    for (int i = 0; i < mostSteps && way * atTo > 0; ++i, step *= grows) {
        from = std::exchange(to, to + way * step);
        atFrom = std::exchange(atTo, ahead(to));
    }
    for (int i = 0; i < mostSteps && atTo != 0 && std::abs(to - from) > exact * scale; ++i) {
        const double middle = to - (to - from) * (atTo / (atTo - atFrom)), atMiddle = ahead(middle);
        if ((atMiddle < 0) != (atTo < 0)) {
            from = to;
            atFrom = atTo;
        } else {
            atFrom *= 0.5;
        }
        to = middle;
        atTo = atMiddle;
    }
    return to;
}

} // namespace suffuse
