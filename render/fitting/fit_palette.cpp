#include "render/fitting/fit_palette.h"

#include "model/brush/random_values.h"
#include "model/colour/perceived.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::fitting {

namespace {

constexpr int rounds = 50;

Colour colourOf(const FitStroke &stroke)
{
    return {float(stroke[Red]), float(stroke[Yellow]), float(stroke[Blue]), 1};
}

double areaOf(const FitStroke &stroke, StyleKind style)
{
    double length = 0;
    for (std::size_t i = 1; i < strokePoints; ++i)
        length += std::hypot(stroke[2 * i] - stroke[2 * i - 2], stroke[2 * i + 1] - stroke[2 * i - 1]);
    const double width = widthOf(stroke, style);
    return width * (length + width) / (1 + std::exp(-stroke[Opacity]));
}

double square(double v)
{
    return v * v;
}

/// k-means of weighted points.
class Clusters {
public:
    Clusters(const std::vector<Perceived> &points, const std::vector<double> &weights)
        : m_points(points), m_weights(weights), m_of(points.size())
    {}

    /// Begins with points that are far from those before them (k-means++).
    void begin(int count, std::uint64_t seed)
    {
        std::vector<double> gap(m_points.size(), 1e9);
        for (int k = 0; k < count; ++k) {
            double sum = 0;
            for (std::size_t i = 0; i < gap.size(); ++i)
                sum += m_weights[i] * gap[i];
            if (!(sum > 0))
                return;
            double at = randomAt(seed, 0, k) * sum;
            std::size_t chosen = 0;
            for (std::size_t i = 0; i < gap.size(); ++i)
                if (gap[i] > 0) {
                    chosen = i;
                    at -= m_weights[i] * gap[i];
                    if (at <= 0)
                        break;
                }
            m_centres.push_back(m_points[chosen]);
            for (std::size_t i = 0; i < gap.size(); ++i)
                gap[i] = std::min(gap[i], square(distanceOf(m_points[i], m_centres.back())));
        }
    }

    void settle()
    {
        for (int round = 0; round < rounds; ++round) {
            assign();
            std::vector<Perceived> sums(m_centres.size(), Perceived{});
            std::vector<double> weights(m_centres.size());
            for (std::size_t i = 0; i < m_points.size(); ++i) {
                for (std::size_t c = 0; c < 3; ++c)
                    sums[m_of[i]][c] += m_weights[i] * m_points[i][c];
                weights[m_of[i]] += m_weights[i];
            }
            for (std::size_t k = 0; k < m_centres.size(); ++k)
                if (weights[k] > 0)
                    for (std::size_t c = 0; c < 3; ++c)
                        m_centres[k][c] = sums[k][c] / weights[k];
        }
        assign();
    }

    std::size_t count() const { return m_centres.size(); }
    const std::vector<std::size_t> &of() const { return m_of; }

private:
    void assign()
    {
        for (std::size_t i = 0; i < m_points.size(); ++i) {
            double least = 1e9;
            for (std::size_t k = 0; k < m_centres.size(); ++k)
                if (const double d = distanceOf(m_points[i], m_centres[k]); d < least)
                    least = d, m_of[i] = k;
        }
    }

    const std::vector<Perceived> &m_points;
    const std::vector<double> &m_weights;
    std::vector<std::size_t> m_of;
    std::vector<Perceived> m_centres;
};

} // namespace

FitPalette::FitPalette(std::vector<FitStroke> &strokes, StyleKind style, int paints, std::uint64_t seed)
{
    std::vector<Perceived> points;
    std::vector<double> weights;
    for (const FitStroke &stroke : strokes) {
        points.push_back(perceivedOf(colourOf(stroke)));
        weights.push_back(areaOf(stroke, style));
    }
    Clusters clusters(points, weights);
    clusters.begin(paints, seed);
    if (clusters.count() == 0)
        return;
    clusters.settle();
    m_paintOf = clusters.of();
    // A paint is the mean of its strokes' colours as they mix.
    m_paints.assign(clusters.count(), {});
    std::vector<double> sums(clusters.count());
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c)
            m_paints[m_paintOf[i]][c] += weights[i] * strokes[i][Red + c];
        sums[m_paintOf[i]] += weights[i];
    }
    for (std::size_t k = 0; k < m_paints.size(); ++k)
        for (double &v : m_paints[k])
            v = sums[k] > 0 ? v / sums[k] : v;
    for (std::size_t i = 0; i < strokes.size(); ++i)
        std::copy(m_paints[m_paintOf[i]].begin(), m_paints[m_paintOf[i]].end(), strokes[i].begin() + Red);
}

std::vector<Colour> FitPalette::paints() const
{
    std::vector<std::size_t> uses(m_paints.size()), order(m_paints.size());
    for (const std::size_t paint : m_paintOf)
        ++uses[paint];
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return uses[a] > uses[b]; });
    std::vector<Colour> out;
    for (const std::size_t k : order)
        if (uses[k] > 0)
            out.push_back({float(m_paints[k][0]), float(m_paints[k][1]), float(m_paints[k][2]), 1});
    return out;
}

void FitPalette::share(std::vector<StrokeSlope> &slopes) const
{
    std::vector<std::array<double, 3>> sums(m_paints.size(), std::array<double, 3>{});
    for (std::size_t i = 0; i < slopes.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            sums[m_paintOf[i]][c] += slopes[i][Red + c];
    for (std::size_t i = 0; i < slopes.size(); ++i)
        std::copy(sums[m_paintOf[i]].begin(), sums[m_paintOf[i]].end(), slopes[i].begin() + Red);
}

void FitPalette::apply(std::vector<FitStroke> &strokes)
{
    // Strokes of a paint have the same slopes by it, but may have begun to move at different times.
    std::vector<std::array<double, 3>> sums(m_paints.size(), std::array<double, 3>{});
    std::vector<double> counts(m_paints.size());
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c)
            sums[m_paintOf[i]][c] += strokes[i][Red + c];
        ++counts[m_paintOf[i]];
    }
    for (std::size_t k = 0; k < m_paints.size(); ++k)
        for (std::size_t c = 0; c < 3 && counts[k] > 0; ++c)
            m_paints[k][c] = std::clamp(sums[k][c] / counts[k], 0.0, 1.0);
    for (std::size_t i = 0; i < strokes.size(); ++i)
        std::copy(m_paints[m_paintOf[i]].begin(), m_paints[m_paintOf[i]].end(), strokes[i].begin() + Red);
}

void FitPalette::keep(const std::vector<std::size_t> &kept)
{
    if (isEmpty())
        return;
    std::vector<std::size_t> paintOf;
    for (const std::size_t i : kept)
        paintOf.push_back(m_paintOf[i]);
    m_paintOf = std::move(paintOf);
}

} // namespace suffuse::fitting
