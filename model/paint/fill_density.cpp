#include "model/paint/fill_density.h"

#include "model/area/outline.h"
#include "model/painting/influence.h"
#include "model/painting/tensor.h"

#include <numbers>

namespace suffuse {

namespace {

/// Outlines with fewer curves are searched as a whole, wherever the point is.
constexpr std::size_t manyCurves = 1000;

/// The boundary as far as it matters at a point.
AreaBoundary boundaryAround(const Stroke &stroke, Microseconds T, Point point)
{
    const std::vector<std::vector<Cubic>> loops = closedOutline(stroke);
    std::size_t curves = 0;
    for (const std::vector<Cubic> &loop : loops)
        curves += loop.size();
    if (curves < manyCurves)
        return boundaryOf(loops, stroke.fill->rule);
    const Rect reach = influenceOfFill(stroke, T), box = outlineBox(stroke);
    const double far = 1.01 * (reach.width() - box.width()) / 2; // on each side
    return boundaryOf(shortenedAround(Rect{point.x, point.y, point.x, point.y}.grown(far), loops), stroke.fill->rule);
}

} // namespace

DensityOfFill::DensityOfFill(const Stroke &stroke, Microseconds T)
    : DensityOfFill(stroke, T, boundaryOf(closedOutline(stroke), stroke.fill->rule))
{}

DensityOfFill::DensityOfFill(const Stroke &stroke, Microseconds T, Point near)
    : DensityOfFill(stroke, T, boundaryAround(stroke, T, near))
{}

DensityOfFill::DensityOfFill(const Stroke &stroke, Microseconds T, AreaBoundary boundary)
    : m_fill(stroke.fill->spreading(T)), m_boundary(std::move(boundary))
{
    // M = D⁻¹/4t = (u, v)ᵀ(u, v).
    const Tensor tensor = 4 * m_fill.age(T) * tensorOf(m_fill);
    const double determinant = tensor.xx * tensor.yy - tensor.xy * tensor.xy;
    m_a = std::sqrt(tensor.yy / determinant);
    m_b = -tensor.xy / determinant / m_a;
    m_c = std::sqrt(1 / tensor.yy);
    m_reach = influenceOfFill(stroke, T);
    const Point o = stroke.origin;
    m_reach = {m_reach.left - o.x, m_reach.top - o.y, m_reach.right - o.x, m_reach.bottom - o.y};
    for (const BoundaryArc &part : m_boundary.arcs) {
        m_ends.push_back(part.arc.top());
        m_ends.push_back(part.arc.bottom());
    }
    std::sort(m_ends.begin(), m_ends.end());
    m_ends.erase(std::unique(m_ends.begin(), m_ends.end()), m_ends.end());
}

DensityOfFill::Value DensityOfFill::operator()(Point x) const
{
    constexpr double reach = reachInSpreads, longest = 0.5; // in spreads
    constexpr std::array<double, 3> places{0.1127016653792583, 0.5, 0.8872983346207417};
    constexpr std::array<double, 3> weights{5.0 / 18, 8.0 / 18, 5.0 / 18};
    Value value;
    if (!m_reach.contains(x))
        return value;
    double sum = 0, along = 0, down = 0; // of the density, and of its slopes by u and v
    const double top = x.y - reach / m_c, bottom = x.y + reach / m_c;
    const auto addPanel = [&](double from, double to) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double y = from + (to - from) * places[i], v = m_c * (x.y - y);
            const double weight = m_c * (to - from) * weights[i] * std::exp(-v * v) / std::sqrt(std::numbers::pi);
            double inside = 0, slope = 0;
            for (const BoundaryArc &part : m_boundary.arcs) {
                if (!(part.arc.top() <= y && y < part.arc.bottom()))
                    continue;
                const double u = m_a * (x.x - part.arc.xAt(y)) + m_b * (x.y - y);
                inside += u > reach ? part.enters : u < -reach ? 0 : part.enters * 0.5 * std::erfc(-u);
                slope += part.enters * std::exp(-u * u) / std::sqrt(std::numbers::pi);
            }
            sum += weight * inside;
            along += weight * slope;
            down += -2 * v * weight * inside;
        }
    };
    double from = top;
    const auto goTo = [&](double to) {
        const int parts = int(std::ceil(m_c * (to - from) / longest));
        for (int k = 0; k < parts; ++k)
            addPanel(from + (to - from) * k / parts, from + (to - from) * (k + 1) / parts);
        from = to;
    };
    for (auto end = std::upper_bound(m_ends.begin(), m_ends.end(), top); end != m_ends.end() && *end < bottom; ++end)
        goTo(*end);
    goTo(bottom);
    sum = std::clamp(sum, 0.0, 1.0);
    value.density = double(m_fill.density) * sum;
    if (!m_fill.gradient || !(sum > 0))
        return value;
    const Point begin = Point() + m_fill.gradient->from, way = Point() + m_fill.gradient->to - begin;
    const Point slope = 1 / dot(way, way) * way; // of the place; ½M⁻¹ of the density's slope pulls the mean there
    const double su = slope.x / m_a, sv = (slope.y - m_b * su) / m_c;
    value.place = std::clamp(dot(slope, x - begin) + 0.5 * (su * along + sv * down) / sum, 0.0, 1.0);
    return value;
}

double fillDensityAt(const Stroke &stroke, Microseconds T, Point point)
{
    if (!stroke.fill || !(stroke.fill->age(T) > 0) || !influenceOfFill(stroke, T).contains(point))
        return 0;
    const Point at = point - stroke.origin;
    return DensityOfFill(stroke, T, at)(at).density;
}

} // namespace suffuse
