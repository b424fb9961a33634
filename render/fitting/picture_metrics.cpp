#include "render/fitting/picture_metrics.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::fitting {

namespace {

constexpr int window = 11;
constexpr std::array<double, 5> scaleWeights = {0.0448, 0.2856, 0.3001, 0.2363, 0.1333};

std::array<double, window> gaussWindow()
{
    std::array<double, window> w{};
    double sum = 0;
    for (int i = 0; i < window; ++i)
        sum += w[std::size_t(i)] = std::exp(-(i - window / 2) * (i - window / 2) / (2 * 1.5 * 1.5));
    for (double &v : w)
        v /= sum;
    return w;
}

/// One channel in double precision.
struct Plane {
    int width = 0, height = 0;
    std::vector<double> values;
};

Plane planeOf(const FitPicture &p, int channel)
{
    Plane out{p.width, p.height, std::vector<double>(p.pixels())};
    for (std::size_t i = 0; i < out.values.size(); ++i)
        out.values[i] = double(p.values[i * std::size_t(p.channels) + std::size_t(channel)]);
    return out;
}

/// Windowed means where the window lies within the plane.
Plane windowed(const Plane &p)
{
    static const std::array<double, window> w = gaussWindow();
    const int width = p.width - window + 1, height = p.height - window + 1;
    Plane rows{width, p.height, std::vector<double>(std::size_t(width) * std::size_t(p.height))};
    for (int y = 0; y < p.height; ++y)
        for (int i = 0; i < window; ++i) {
            const double *const in = p.values.data() + std::size_t(y) * p.width + i;
            double *const out = rows.values.data() + std::size_t(y) * width;
            for (int x = 0; x < width; ++x)
                out[x] += w[std::size_t(i)] * in[x];
        }
    Plane out{width, height, std::vector<double>(std::size_t(width) * std::size_t(height))};
    for (int y = 0; y < height; ++y)
        for (int i = 0; i < window; ++i) {
            const double *const in = rows.values.data() + std::size_t(y + i) * width;
            double *const to = out.values.data() + std::size_t(y) * width;
            for (int x = 0; x < width; ++x)
                to[x] += w[std::size_t(i)] * in[x];
        }
    return out;
}

Plane product(const Plane &a, const Plane &b)
{
    Plane out = a;
    for (std::size_t i = 0; i < out.values.size(); ++i)
        out.values[i] *= b.values[i];
    return out;
}

Plane halved(const Plane &p)
{
    Plane out{p.width / 2, p.height / 2, {}};
    out.values.reserve(std::size_t(out.width) * std::size_t(out.height));
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const double *const v = p.values.data() + std::size_t(2 * y) * p.width + 2 * x;
            out.values.push_back((v[0] + v[1] + v[p.width] + v[p.width + 1]) / 4);
        }
    return out;
}

/// The means of contrast and structure, and of these with luminance, at one scale.
struct ScaleSimilarity {
    double structure = 0, all = 0;
};

ScaleSimilarity similarityOf(const Plane &a, const Plane &b)
{
    constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
    const Plane ma = windowed(a), mb = windowed(b), aa = windowed(product(a, a)), bb = windowed(product(b, b)),
                ab = windowed(product(a, b));
    ScaleSimilarity sum;
    for (std::size_t i = 0; i < ma.values.size(); ++i) {
        const double u = ma.values[i], v = mb.values[i];
        const double structure = (2 * (ab.values[i] - u * v) + c2) / (aa.values[i] - u * u + bb.values[i] - v * v + c2);
        sum.structure += structure;
        sum.all += structure * (2 * u * v + c1) / (u * u + v * v + c1);
    }
    sum.structure /= double(ma.values.size());
    sum.all /= double(ma.values.size());
    return sum;
}

} // namespace

double meanSquare(const FitPicture &a, const FitPicture &b, const FitPicture &weight)
{
    double sum = 0, weights = 0;
    const auto channels = std::size_t(a.channels);
    for (std::size_t p = 0; p < a.pixels(); ++p) {
        double here = 0;
        for (std::size_t c = 0; c < channels; ++c) {
            const double d = double(a.values[p * channels + c]) - double(b.values[p * channels + c]);
            here += d * d;
        }
        const double w = weight.isEmpty() ? 1 : double(weight.values[p]);
        sum += w * here;
        weights += w;
    }
    return weights > 0 ? sum / (weights * a.channels) : 0;
}

double peakRatio(double meanSquare)
{
    return -10 * std::log10(std::max(meanSquare, 1.2589254117941673e-10));
}

SimilarityAtScales multiScaleSimilarity(const FitPicture &a, const FitPicture &b)
{
    int scales = 0;
    while (scales < int(scaleWeights.size()) && std::min(a.width, a.height) >> scales >= window)
        ++scales;
    if (scales == 0)
        return {a.values == b.values ? 1.0 : 0.0, 0};
    double weights = 0;
    for (int k = 0; k < scales; ++k)
        weights += scaleWeights[std::size_t(k)];
    double sum = 0;
    for (int channel = 0; channel < a.channels; ++channel) {
        Plane u = planeOf(a, channel), v = planeOf(b, channel);
        double value = 1;
        for (int k = 0; k < scales; ++k) {
            const ScaleSimilarity s = similarityOf(u, v);
            value *=
                std::pow(std::max(0.0, k + 1 < scales ? s.structure : s.all), scaleWeights[std::size_t(k)] / weights);
            if (k + 1 < scales)
                u = halved(u), v = halved(v);
        }
        sum += value;
    }
    return {sum / a.channels, scales};
}

} // namespace suffuse::fitting
