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

std::size_t paddedCount(std::size_t count)
{
    return (count + gaussRun - 1) / gaussRun * gaussRun;
}

constexpr double widestInFloats = 256; // of spreads, canvas units

} // namespace

GaussBins::GaussBins(std::vector<Gauss> all, const std::vector<ChannelGains> &gains, int channels)
    : m_all(std::move(all)), m_gains(gains), m_channels(channels)
{
    double narrowest = std::numeric_limits<double>::infinity();
    for (const Gauss &g : m_all)
        narrowest = std::min(narrowest, g.spread), m_wide = m_wide || g.spread > widestInFloats;
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
        Bin &bin = m_bins.try_emplace(entries[i].first, Bin{std::uint32_t(i), 0, 0}).first->second;
        bin.end = std::uint32_t(i + 1);
        m_indices.push_back(entries[i].second);
    }
    if (m_channels > 0 && !m_wide)
        makeColumns();
}

void GaussBins::makeColumns()
{
    constexpr double perLog2 = -1.4426950408889634;
    for (auto &[key, bin] : m_bins) {
        const std::size_t count = paddedCount(bin.end - bin.begin);
        bin.column = std::uint32_t(m_columns.size());
        m_columns.resize(m_columns.size() + std::size_t(5 + m_channels) * count);
        float *at = m_columns.data() + bin.column;
        const Point centre{(std::int32_t(key >> 32) + 0.5) * m_side, (std::int32_t(std::uint32_t(key)) + 0.5) * m_side};
        for (std::uint32_t i = bin.begin; i < bin.end; ++i, ++at) {
            const Gauss &g = m_all[m_indices[i]];
            const double values[5] = {g.at.x - centre.x, g.at.y - centre.y, perLog2 * g.a, perLog2 * g.b,
                                      perLog2 * g.c};
            for (std::size_t k = 0; k < 5; ++k)
                at[k * count] = float(values[k]);
            for (std::size_t k = 0; k < std::size_t(m_channels); ++k)
                at[(5 + k) * count] = float(g.weight * m_gains[g.row][k]);
        }
    }
}

const GaussBins::Bin *GaussBins::binAt(Point p) const
{
    const auto bin = m_bins.find(keyOf(cellOf(p.x, m_side), cellOf(p.y, m_side)));
    return bin == m_bins.end() ? nullptr : &bin->second;
}

std::span<const std::uint32_t> GaussBins::near(Point p) const
{
    const Bin *bin = binAt(p);
    return bin ? std::span(m_indices).subspan(bin->begin, bin->end - bin->begin) : std::span<const std::uint32_t>();
}

void GaussBins::addSums(Point p, ChannelSums &sums) const
{
    const Bin *bin = binAt(p);
    if (!bin)
        return;
    if (m_wide) {
        for (std::uint32_t i = bin->begin; i < bin->end; ++i) {
            const Gauss &g = m_all[m_indices[i]];
            const Sloped s = valueAt(g, p);
            for (std::size_t k = 0; k < std::size_t(m_channels); ++k)
                sums[k].add(m_gains[g.row][k], s);
        }
        return;
    }
    const std::size_t count = paddedCount(bin->end - bin->begin);
    const float *columns = m_columns.data() + bin->column;
    GaussColumns from{columns, columns + count, columns + 2 * count, columns + 3 * count, columns + 4 * count, {},
                      count};
    for (std::size_t k = 0; k < std::size_t(m_channels); ++k)
        from.weight[k] = columns + (5 + k) * count;
    const Point local{p.x - (double(cellOf(p.x, m_side)) + 0.5) * m_side,
                      p.y - (double(cellOf(p.y, m_side)) + 0.5) * m_side};
    const GaussSums found = gaussSums(from, m_channels, float(local.x), float(local.y));
    for (std::size_t k = 0; k < std::size_t(m_channels); ++k)
        sums[k].add(1, {double(found[k][0]), {double(found[k][1]), double(found[k][2])}});
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
