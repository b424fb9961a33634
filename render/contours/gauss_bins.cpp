#include "render/contours/gauss_bins.h"

namespace suffuse::contours {

namespace {

std::uint64_t keyOf(std::int64_t column, std::int64_t row)
{
    return std::uint64_t(std::uint32_t(column)) << 32 | std::uint32_t(row);
}

std::int64_t cellOf(double at, double side)
{
    return std::int64_t(std::floor(at / side));
}

} // namespace

GaussBins::GaussBins(std::vector<Gauss> all) : m_all(std::move(all))
{
    double narrowest = std::numeric_limits<double>::infinity();
    for (const Gauss &g : m_all)
        narrowest = std::min(narrowest, g.spread);
    m_side = 2 * narrowest;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> entries;
    for (std::size_t i = 0; i < m_all.size(); ++i) {
        const Gauss &g = m_all[i];
        const std::int64_t right = cellOf(g.at.x + g.halfWidth, m_side), bottom = cellOf(g.at.y + g.halfHeight, m_side);
        for (std::int64_t y = cellOf(g.at.y - g.halfHeight, m_side); y <= bottom; ++y)
            for (std::int64_t x = cellOf(g.at.x - g.halfWidth, m_side); x <= right; ++x)
                entries.emplace_back(keyOf(x, y), std::uint32_t(i));
    }
    std::sort(entries.begin(), entries.end());
    m_indices.reserve(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        auto &range = m_bins.try_emplace(entries[i].first, std::uint32_t(i), 0).first->second;
        range.second = std::uint32_t(i + 1);
        m_indices.push_back(entries[i].second);
    }
}

std::uint64_t GaussBins::keyAt(double x, double y) const
{
    return keyOf(cellOf(x, m_side), cellOf(y, m_side));
}

std::span<const std::uint32_t> GaussBins::near(Point p) const
{
    const auto bin = m_bins.find(keyAt(p.x, p.y));
    if (bin == m_bins.end())
        return {};
    return std::span(m_indices).subspan(bin->second.first, bin->second.second - bin->second.first);
}

Sloped valueAt(const Gauss &gauss, Point p)
{
    const Point d = p - gauss.at;
    const double u = gauss.a * d.x + gauss.b * d.y, v = gauss.b * d.x + gauss.c * d.y;
    const double exponent = u * d.x + v * d.y;
    if (exponent > gauss.cut)
        return {};
    const double value = gauss.weight * std::exp(-exponent);
    return {value, {-2 * value * u, -2 * value * v}};
}

} // namespace suffuse::contours
