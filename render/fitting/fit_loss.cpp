#include "render/fitting/fit_loss.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::fitting {

namespace {

using Triple = std::array<float, 3>;

constexpr std::array<Triple, 3> conesOfLinear = {{{0.4122214708f, 0.5363325363f, 0.0514459929f},
                                                  {0.2119034982f, 0.6806995451f, 0.1073969566f},
                                                  {0.0883024619f, 0.2817188376f, 0.6299787005f}}};
constexpr std::array<Triple, 3> labOfRoots = {{{0.2104542553f, 0.7936177850f, -0.0040720468f},
                                               {1.9779984951f, -2.4285922050f, 0.4505937099f},
                                               {0.0259040371f, 0.7827717662f, -0.8086757660f}}};
constexpr float greyShare = 3;     ///< A difference of grey counts in three channels, and in one of OKLab.
constexpr float leastCone = 1e-4f; ///< Below, the cube root is too steep.

/// Linear light of an encoded value, and its derivative.
std::array<float, 2> linearOf(float v)
{
    if (v <= 0.04045f)
        return {v / 12.92f, 1 / 12.92f};
    const float base = (v + 0.055f) / 1.055f, power = std::pow(base, 1.4f);
    return {power * base, 2.4f / 1.055f * power};
}

/// OKLab (Ottosson 2020) of encoded R, G, B, and its derivatives by these.
struct PerceivedSlopes {
    Triple lab{};
    std::array<Triple, 3> by{}; ///< by[i][c]: of component i by channel c
};

PerceivedSlopes perceivedSlopes(const float *rgb)
{
    std::array<std::array<float, 2>, 3> linear{};
    for (std::size_t c = 0; c < 3; ++c)
        linear[c] = linearOf(std::clamp(rgb[c], 0.0f, 1.0f));
    PerceivedSlopes out;
    for (std::size_t k = 0; k < 3; ++k) {
        float cone = 0;
        for (std::size_t c = 0; c < 3; ++c)
            cone += conesOfLinear[k][c] * linear[c][0];
        cone = std::max(cone, leastCone);
        const float root = std::cbrt(cone), slope = root / (3 * cone);
        for (std::size_t i = 0; i < 3; ++i) {
            out.lab[i] += labOfRoots[i][k] * root;
            for (std::size_t c = 0; c < 3; ++c)
                out.by[i][c] += labOfRoots[i][k] * slope * conesOfLinear[k][c] * linear[c][1];
        }
    }
    return out;
}

} // namespace

FitLoss::FitLoss(FitPicture target, FitPicture weight, double perceptual)
    : m_target(std::move(target)), m_weight(std::move(weight)), m_perceptual(float(perceptual))
{
    if (m_perceptual <= 0)
        return;
    m_perceived = FitPicture(m_target.width, m_target.height, 3);
    for (std::size_t p = 0; p < m_target.pixels(); ++p) {
        const Triple lab = perceivedSlopes(m_target.values.data() + 3 * p).lab;
        std::copy(lab.begin(), lab.end(), m_perceived.values.begin() + std::ptrdiff_t(3 * p));
    }
}

void FitLoss::differentiate(std::size_t first, std::size_t count, const float *rgb, float *byRgb) const
{
    for (std::size_t i = 0; i < count; ++i, rgb += 3, byRgb += 3) {
        const std::size_t pixel = first + i;
        const float weight = 2 * (m_weight.isEmpty() ? 1 : m_weight.values[pixel]);
        for (std::size_t c = 0; c < 3; ++c)
            byRgb[c] = weight * (1 - m_perceptual) * (rgb[c] - m_target.values[3 * pixel + c]);
        if (m_perceptual <= 0)
            continue;
        const PerceivedSlopes is = perceivedSlopes(rgb);
        for (std::size_t k = 0; k < 3; ++k) {
            const float by = weight * m_perceptual * greyShare * (is.lab[k] - m_perceived.values[3 * pixel + k]);
            for (std::size_t c = 0; c < 3; ++c)
                byRgb[c] += by * is.by[k][c];
        }
    }
}

double FitLoss::at(std::size_t pixel, const float *rgb) const
{
    double squares = 0, perceived = 0;
    for (std::size_t c = 0; c < 3; ++c)
        squares += std::pow(double(rgb[c] - m_target.values[3 * pixel + c]), 2);
    if (m_perceptual > 0) {
        const Triple lab = perceivedSlopes(rgb).lab;
        for (std::size_t k = 0; k < 3; ++k)
            perceived += std::pow(double(lab[k] - m_perceived.values[3 * pixel + k]), 2);
    }
    return (m_weight.isEmpty() ? 1 : double(m_weight.values[pixel])) *
           ((1 - double(m_perceptual)) * squares + double(m_perceptual * greyShare) * perceived);
}

} // namespace suffuse::fitting
