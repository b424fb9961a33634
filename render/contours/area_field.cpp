#include "render/contours/area_field.h"

#include "model/area/boundary.h"
#include "model/area/outline.h"
#include "model/painting/tensor.h"
#include "render/nodes/level0.h"

#include <numbers>

namespace suffuse::contours {

namespace {

constexpr int panelPoints = 7;         // of Gauss-Legendre, on each panel
constexpr double longestAreaPanel = 1; // in spreads
constexpr int mostArcHalvings = 40;

struct Entry {
    std::int64_t row, column;
    std::uint32_t node;
    friend auto operator<=>(const Entry &, const Entry &) = default;
};

} // namespace

AreaField::AreaField(const Stroke &stroke, Microseconds T, double reach)
{
    const Fill &fill = *stroke.fill;
    const Tensor tensor = 4 * fill.age(T) * tensorOf(fill);
    const double determinant = tensor.xx * tensor.yy - tensor.xy * tensor.xy;
    m_a = std::sqrt(tensor.yy / determinant);
    m_b = -tensor.xy / determinant / m_a;
    m_c = std::sqrt(1 / tensor.yy);
    m_density = double(fill.density);
    m_narrowest = fill.spread(T) * std::sqrt(std::min(1.0, double(fill.anisotropyRatio)));
    m_width = 1 / m_a, m_height = 1 / m_c;
    const AreaBoundary boundary = boundaryOf(closedOutline(stroke), fill.rule);
    for (const BoundaryArc &part : boundary.arcs)
        addArc(part.arc.curve, part.enters, 0);
    // What is level adds nothing, but the density changes beside it, too.
    for (const BoundaryFlat &flat : boundary.flats) {
        const Point from{flat.left, flat.y}, third{(flat.right - flat.left) / 3, 0};
        addArc({{from, from + third, from + 2 * third, {flat.right, flat.y}}}, flat.jump, 0);
    }
    for (const Node &node : m_nodes)
        m_box.include(node.at);
    const double larger = fill.spread(T) * std::sqrt(std::max(1.0, double(fill.anisotropyRatio)));
    m_box = m_box.grown((reach + longestAreaPanel) * larger);
    makeRows(reach);
}

void AreaField::addArc(const Cubic &curve, int enters, int depth)
{
    const auto white = [this](Point d) { return length({m_a * d.x + m_b * d.y, m_c * d.y}); };
    const double size =
        white(curve.p[1] - curve.p[0]) + white(curve.p[2] - curve.p[1]) + white(curve.p[3] - curve.p[2]);
    if (size > longestAreaPanel && depth < mostArcHalvings) {
        const auto [before, after] = curve.split(0.5);
        addArc(before, enters, depth + 1);
        addArc(after, enters, depth + 1);
        return;
    }
    const QuadratureRule &rule = gaussLegendre(panelPoints);
    const double gain = m_density * enters * m_c / std::sqrt(std::numbers::pi);
    for (std::size_t i = 0; i < std::size_t(panelPoints); ++i)
        m_nodes.push_back({curve.at(rule.x[i]), gain * rule.weight[i] * curve.derivative(rule.x[i]).y});
}

void AreaField::makeRows(double reach)
{
    std::vector<Entry> near, far;
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
        const Point at = m_nodes[i].at;
        const auto last = std::int64_t(std::floor((at.y + reach * m_height) / m_height));
        for (auto row = std::int64_t(std::floor((at.y - reach * m_height) / m_height)); row <= last; ++row) {
            const double b0 = m_b * (double(row) * m_height - at.y), b1 = b0 + m_b * m_height;
            const double left = at.x + (-reach - std::max(b0, b1)) / m_a;
            const double right = at.x + (reach - std::min(b0, b1)) / m_a;
            const auto end = std::int64_t(std::floor(right / m_width)) + 1;
            for (auto column = std::int64_t(std::floor(left / m_width)); column < end; ++column)
                near.push_back({row, column, std::uint32_t(i)});
            far.push_back({row, end, std::uint32_t(i)});
        }
    }
    std::sort(near.begin(), near.end());
    std::sort(far.begin(), far.end());
    m_near.reserve(near.size());
    std::size_t next = 0;
    Polynomial left{};
    for (std::size_t i = 0; i < near.size();) {
        const std::int64_t row = near[i].row, column = near[i].column;
        std::vector<Bin> &bins = m_rows[row];
        if (bins.empty()) {
            left = {};
            while (next < far.size() && far[next].row < row)
                ++next;
        }
        for (; next < far.size() && far[next].row == row && far[next].column <= column; ++next) {
            // e^(−(v + t)²) as a series of t
            const Node &node = m_nodes[far[next].node];
            const double v = m_c * ((double(row) + 0.5) * m_height - node.at.y);
            double before = 0, term = node.weight * std::exp(-v * v);
            for (std::size_t k = 0; k < terms; ++k) {
                left[k] += term;
                const double after = (-2 * v * term - 2 * before) / double(k + 1);
                before = term, term = after;
            }
        }
        Bin bin{column, std::uint32_t(m_near.size()), 0, left};
        for (; i < near.size() && near[i].row == row && near[i].column == column; ++i)
            m_near.push_back(near[i].node);
        bin.end = std::uint32_t(m_near.size());
        bins.push_back(bin);
    }
}

Sloped AreaField::at(Point p) const
{
    const auto row = m_rows.find(std::int64_t(std::floor(p.y / m_height)));
    if (row == m_rows.end())
        return {};
    const auto column = std::int64_t(std::floor(p.x / m_width));
    const auto after = std::upper_bound(row->second.begin(), row->second.end(), column,
                                        [](std::int64_t c, const Bin &bin) { return c < bin.column; });
    if (after == row->second.begin())
        return {};
    // Between bins nothing is near: all of the bin before lies left.
    const Bin &bin = *std::prev(after);
    const double t = p.y / m_height - double(row->first) - 0.5;
    double value = 0, slope = 0;
    for (std::size_t k = terms; k-- > 0;) {
        slope = slope * t + value;
        value = value * t + bin.left[k];
    }
    Sloped sum{value, {0, slope * m_c}};
    for (std::uint32_t i = bin.begin; i < bin.end; ++i) {
        const Node &node = m_nodes[m_near[i]];
        const Point d = p - node.at;
        const double u = m_a * d.x + m_b * d.y, v = m_c * d.y;
        const double level = node.weight * std::exp(-v * v), inside = 0.5 * std::erfc(-u);
        const double edge = std::exp(-u * u) / std::sqrt(std::numbers::pi);
        sum.value += level * inside;
        sum.slope.x += level * m_a * edge;
        sum.slope.y += level * (m_b * edge - 2 * v * m_c * inside);
    }
    return sum;
}

bool AreaField::isNear(const Rect &box) const
{
    if (!box.intersects(m_box))
        return false;
    const auto first = std::int64_t(std::floor(box.left / m_width)),
               last = std::int64_t(std::floor(box.right / m_width));
    auto row = m_rows.lower_bound(std::int64_t(std::floor(box.top / m_height)));
    const auto bottom = std::int64_t(std::floor(box.bottom / m_height));
    for (; row != m_rows.end() && row->first <= bottom; ++row) {
        const auto bin = std::lower_bound(row->second.begin(), row->second.end(), first,
                                          [](const Bin &b, std::int64_t c) { return b.column < c; });
        if (bin != row->second.end() && bin->column <= last)
            return true;
    }
    return false;
}

} // namespace suffuse::contours
