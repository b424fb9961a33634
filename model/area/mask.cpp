#include "model/area/mask.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace suffuse {

namespace {

constexpr double noDistance = std::numeric_limits<double>::infinity();

/// Replaces values along a line by the lower envelope of the parabolas above them: min over q of (p − q)² + value(q).
class LowerEnvelope {
public:
    explicit LowerEnvelope(int longest)
        : m_values(std::size_t(longest)), m_places(std::size_t(longest)), m_from(std::size_t(longest) + 1)
    {}

    void apply(double *first, int count, std::size_t step)
    {
        int last = -1;
        for (int q = 0; q < count; ++q) {
            const double value = m_values[std::size_t(q)] = first[std::size_t(q) * step];
            if (value == noDistance)
                continue;
            double from = -noDistance;
            while (last >= 0) {
                const int other = m_places[std::size_t(last)];
                from = (value + double(q) * q - m_values[std::size_t(other)] - double(other) * other) / (2.0 * (q - other));
                if (from > m_from[std::size_t(last)])
                    break;
                --last;
                from = -noDistance;
            }
            ++last;
            m_places[std::size_t(last)] = q;
            m_from[std::size_t(last)] = from;
        }
        if (last < 0)
            return;
        int k = 0;
        for (int p = 0; p < count; ++p) {
            while (k < last && m_from[std::size_t(k) + 1] <= p)
                ++k;
            const int q = m_places[std::size_t(k)];
            first[std::size_t(p) * step] = double(p - q) * (p - q) + m_values[std::size_t(q)];
        }
    }

private:
    std::vector<double> m_values;
    std::vector<int> m_places;
    std::vector<double> m_from; ///< where each parabola begins to be the lowest one
};

Mask inverted(Mask mask)
{
    for (std::uint8_t &pixel : mask.pixels)
        pixel = pixel == 0;
    return mask;
}

Mask flooded(const Mask &open, int x, int y)
{
    Mask region(open.width, open.height);
    if (!open.at(x, y))
        return region;
    std::vector<std::pair<int, int>> next{{x, y}};
    region.pixels[region.index(x, y)] = 1;
    while (!next.empty()) {
        const auto [cx, cy] = next.back();
        next.pop_back();
        const std::pair<int, int> sides[] = {{cx + 1, cy}, {cx - 1, cy}, {cx, cy + 1}, {cx, cy - 1}};
        for (const auto &[sx, sy] : sides)
            if (open.at(sx, sy) && region.pixels[region.index(sx, sy)] == 0) {
                region.pixels[region.index(sx, sy)] = 1;
                next.emplace_back(sx, sy);
            }
    }
    return region;
}

} // namespace

std::size_t Mask::count() const
{
    return std::size_t(std::count(pixels.begin(), pixels.end(), std::uint8_t(1)));
}

std::vector<double> squaredDistances(const Mask &mask)
{
    std::vector<double> distances(mask.pixels.size());
    for (std::size_t i = 0; i < distances.size(); ++i)
        distances[i] = mask.pixels[i] ? 0 : noDistance;
    LowerEnvelope envelope(std::max(mask.width, mask.height));
    for (int x = 0; x < mask.width; ++x)
        envelope.apply(distances.data() + x, mask.height, std::size_t(mask.width));
    for (int y = 0; y < mask.height; ++y)
        envelope.apply(distances.data() + mask.index(0, y), mask.width, 1);
    return distances;
}

Mask grown(const Mask &mask, double by)
{
    if (by == 0)
        return mask;
    const bool shrinks = by < 0;
    const std::vector<double> distances = squaredDistances(shrinks ? inverted(mask) : mask);
    Mask result(mask.width, mask.height);
    for (std::size_t i = 0; i < distances.size(); ++i)
        result.pixels[i] = shrinks ? distances[i] > by * by : distances[i] <= by * by;
    return result;
}

Mask regionAround(const Mask &mask, int x, int y, double gap)
{
    if (!(gap > 0) || !mask.at(x, y))
        return flooded(mask, x, y);
    const std::vector<double> distances = squaredDistances(inverted(mask));
    // The pixel itself is within.
    const double radius = std::min(0.5 * gap, 0.99 * std::sqrt(distances[mask.index(x, y)]));
    Mask wide(mask.width, mask.height);
    for (std::size_t i = 0; i < distances.size(); ++i)
        wide.pixels[i] = distances[i] > radius * radius;
    Mask region = grown(flooded(wide, x, y), radius);
    for (std::size_t i = 0; i < distances.size(); ++i)
        region.pixels[i] = region.pixels[i] && mask.pixels[i];
    return region;
}

} // namespace suffuse
