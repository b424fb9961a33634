#include "model/shaping/baseline_curve.h"

#include "model/painting/text.h"

#include <algorithm>
#include <utility>

namespace suffuse {

namespace {

constexpr int curveSteps = 32; ///< of each curve; between them the length is taken for even
constexpr int comparedSteps = 32;
constexpr double curveRounding = 3e-6; ///< of the extent of a chain; what float32 can tell
constexpr double alike = 1e-3;         ///< of the extent: chains that are divided otherwise

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
    const Step step = stepAt(along);
    return placeOn(step.curve, step.t);
}

/// `along` lies within the chain.
BaselineCurve::Step BaselineCurve::stepAt(double along) const
{
    const auto next = std::upper_bound(m_at.begin(), m_at.end() - 1, along,
                                       [](double value, const Step &step) { return value < step.length; });
    const Step &to = *next, &from = *(next - 1);
    double t = from.t + (to.t - from.t) * (along - from.length) / (to.length - from.length);
    // One step of Newton's rule.
    if (const double speed = suffuse::length(m_curves[to.curve].derivative(t)); speed > 0)
        t = std::clamp(t - (from.length + lengthBetween(m_curves[to.curve], from.t, t) - along) / speed, from.t, to.t);
    return {along, to.curve, t};
}

std::vector<Cubic> BaselineCurve::between(double from, double to) const
{
    const Step first = stepAt(from), last = stepAt(to);
    std::vector<Cubic> curves;
    for (std::size_t k = first.curve; k <= last.curve; ++k) {
        Cubic curve = m_curves[k];
        if (k == last.curve && last.t < 1)
            curve = curve.split(last.t)[0];
        if (k == first.curve && first.t > 0)
            curve = curve.split(k == last.curve ? first.t / last.t : first.t)[1];
        if (polygonLength(curve) > 0)
            curves.push_back(curve);
    }
    return curves;
}

std::optional<std::pair<double, double>> BaselineCurve::endsOf(const BaselineCurve &part) const
{
    if (m_at.empty() || part.m_at.empty())
        return {};
    Rect reach;
    for (const Cubic &curve : m_curves)
        reach = reach.united(curve.controlBox());
    const double most = alike * std::hypot(reach.width(), reach.height());
    if (part.length() > length() + most)
        return {};
    const Point begin = part.at(0).point;
    const auto away = [&](double along) { return suffuse::length(at(along).point - begin); };
    const auto isAt = [&](double from) {
        for (int i = 0; i <= comparedSteps; ++i) {
            const double along = part.length() * i / comparedSteps;
            if (suffuse::length(part.at(along).point - at(from + along).point) > most)
                return false;
        }
        return true;
    };
    // A chain that crosses itself comes by the point several times. Steps beside the right one end near the point, too.
    std::optional<std::pair<double, double>> ends;
    double nearest = most;
    for (std::size_t k = 0; k + 1 < m_at.size(); ++k) {
        double low = m_at[k].length, high = m_at[k + 1].length;
        if (std::min(away(low), away(high)) > high - low + most)
            continue;
        for (int i = 0; i < 60; ++i) {
            const double a = low + (high - low) / 3, b = high - (high - low) / 3;
            if (away(a) <= away(b))
                high = b;
            else
                low = a;
        }
        const double from = std::min(0.5 * (low + high), std::max(0.0, length() - part.length()));
        const double distance = away(from);
        if (distance > nearest || (ends && distance == nearest) || !isAt(from))
            continue;
        nearest = distance;
        ends = std::pair(from, std::min(length(), from + part.length()));
    }
    return ends;
}

std::vector<Cubic> baselineOf(const Stroke &stroke)
{
    std::vector<Cubic> curves;
    for (std::size_t k = 0; k < stroke.segments.size() && (k == 0 || !stroke.beginsChain(k)); ++k)
        curves.push_back(stroke.cubicOf(stroke.segments[k]));
    if (curves.size() > std::size_t(Text::mostCurves))
        curves.clear();
    return curves;
}

std::vector<Cubic> mapped(std::vector<Cubic> curves, const Affine &map)
{
    for (Cubic &curve : curves)
        for (Point &p : curve.p)
            p = map(p);
    return curves;
}

bool isSameCurve(const std::vector<Cubic> &a, const std::vector<Cubic> &b)
{
    Rect reach;
    for (const Cubic &curve : b)
        reach = reach.united(curve.controlBox());
    const double extent = std::hypot(reach.width(), reach.height()) + 1e-9;
    if (a.size() == b.size())
        return std::ranges::equal(a, b, [most = curveRounding * extent](const Cubic &x, const Cubic &y) {
            return std::ranges::equal(x.p, y.p, [most](Point p, Point q) { return length(p - q) <= most; });
        });
    // Uneven maps split segments.
    const BaselineCurve first(a), second(b);
    for (int i = 0; i <= comparedSteps; ++i) {
        const Point p = first.at(first.length() * i / comparedSteps).point,
                    q = second.at(second.length() * i / comparedSteps).point;
        if (length(p - q) > alike * extent)
            return false;
    }
    return true;
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
