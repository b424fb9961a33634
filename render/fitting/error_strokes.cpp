#include "render/fitting/error_strokes.h"

#include "model/brush/random_values.h"
#include "model/painting/ryb.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace suffuse::fitting {

namespace {

constexpr double mostPixels = 50'000; ///< at which errors are looked at: wider ones hardly need more
constexpr double leastGain = 1e-7;    ///< Less than that of a square error per pixel is rounding.

/// An error as wide as `deviation`.
struct Blob {
    double gain = 0;
    int x = 0, y = 0;
    std::size_t width = 0; ///< which of the deviations
};

/// Which way a ridge of the error runs, and how much of one it is.
struct Ridge {
    double x = 1, y = 0;
    double coherence = 0; ///< 0: none, 1: all slopes stand across it
};

class ErrorSearch {
public:
    ErrorSearch(const ErrorView &view, const FitLimits &limits, std::uint64_t seed)
        : m_scale(view.scale), m_limits(limits), m_seed(seed)
    {
        const double shrink = std::min(1.0, std::sqrt(mostPixels / double(view.target.pixels())));
        const int width = std::max(1, int(view.target.width * shrink)),
                  height = std::max(1, int(view.target.height * shrink));
        m_scale *= double(width) / view.target.width;
        m_drawn = averaged(view.drawn, width, height);
        m_error = averaged(view.target, width, height);
        if (!view.weight.isEmpty())
            m_weight = averaged(view.weight, width, height);
        for (std::size_t p = 0; p < m_error.pixels(); ++p)
            for (std::size_t c = 0; c < 3; ++c)
                m_error.values[3 * p + c] = (m_error.values[3 * p + c] - m_drawn.values[3 * p + c]) * weightAt(p);
        for (double d = 1; d < std::max(1.5, std::min(width, height) / 5.0); d *= 1.5)
            m_deviations.push_back(d);
    }

    /// Adds up to `quota` strokes whose places do not overlap. Returns how many.
    std::size_t find(std::size_t quota, std::vector<FitStroke> &out)
    {
        std::vector<FitPicture> errors;
        errors.reserve(m_deviations.size());
        for (const double d : m_deviations)
            errors.push_back(blurred(m_error, d));
        std::vector<char> taken(m_error.pixels());
        std::size_t found = 0;
        for (const Blob &blob : blobsOf(errors)) {
            if (found == quota)
                break;
            if (taken[std::size_t(blob.y) * std::size_t(m_error.width) + std::size_t(blob.x)])
                continue;
            out.push_back(strokeAt(blob, errors[blob.width], out.size()));
            take(blob, errors[blob.width], taken);
            ++found;
        }
        return found;
    }

private:
    float weightAt(std::size_t pixel) const { return m_weight.isEmpty() ? 1.0f : m_weight.values[pixel]; }

    /// All that are worth it, the greatest gain first: with a Gaussian of the deviation d, the error e blurred by d
    /// takes 4π d² |e|² from the sum of squares.
    std::vector<Blob> blobsOf(const std::vector<FitPicture> &errors) const
    {
        std::vector<Blob> out;
        for (std::size_t k = 0; k < errors.size(); ++k) {
            const double d = m_deviations[k];
            const int step = std::max(1, int(d));
            for (int y = step / 2; y < m_error.height; y += step)
                for (int x = step / 2; x < m_error.width; x += step) {
                    const float *const e = errors[k].at(x, y);
                    const double gain = double(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) * d * d;
                    if (gain > leastGain)
                        out.push_back({gain, x, y, k});
                }
        }
        std::stable_sort(out.begin(), out.end(), [](const Blob &a, const Blob &b) { return a.gain > b.gain; });
        return out;
    }

    int reachOf(const Blob &blob) const { return int(std::ceil(2 * m_deviations[blob.width])); }

    Ridge ridgeAt(const Blob &blob, const FitPicture &error) const
    {
        const int reach = reachOf(blob);
        double xx = 0, xy = 0, yy = 0;
        for (int y = std::max(1, blob.y - reach); y < std::min(error.height - 1, blob.y + reach + 1); ++y)
            for (int x = std::max(1, blob.x - reach); x < std::min(error.width - 1, blob.x + reach + 1); ++x)
                for (int c = 0; c < 3; ++c) {
                    const double gx = double(error.at(x + 1, y)[c]) - double(error.at(x - 1, y)[c]),
                                 gy = double(error.at(x, y + 1)[c]) - double(error.at(x, y - 1)[c]);
                    xx += gx * gx, xy += gx * gy, yy += gy * gy;
                }
        if (!(xx + yy > 0))
            return {};
        const double angle = 0.5 * std::atan2(2 * xy, xx - yy) + std::numbers::pi / 2;
        return {std::cos(angle), std::sin(angle), std::hypot(xx - yy, 2 * xy) / (xx + yy)};
    }

    FitStroke strokeAt(const Blob &blob, const FitPicture &error, std::size_t number) const
    {
        const Ridge ridge = ridgeAt(blob, error);
        const double d = m_deviations[blob.width], length = d * (2 + 3 * ridge.coherence);
        FitStroke out{};
        for (std::size_t i = 0; i < strokePoints; ++i) {
            // Points that lie exactly on a line would never leave it.
            const double along = (double(i) / (strokePoints - 1) - 0.5) * length;
            const double aside = 0.2 * d * (randomAt(m_seed, int(i), std::int64_t(number)) - 0.5);
            out[2 * i] = (blob.x + 0.5 + along * ridge.x - aside * ridge.y) / m_scale;
            out[2 * i + 1] = (blob.y + 0.5 + along * ridge.y + aside * ridge.x) / m_scale;
        }
        out[LogSpread] = std::log(1.3 * d / m_scale);
        out[LogPeak] = std::log(m_limits.style == StyleKind::Feathering ? 1.2 : 2.5);
        out[LogSteepness] = std::log(m_limits.style == StyleKind::Feathering ? 1.3
                                     : m_limits.style == StyleKind::Uniform  ? 0.25
                                                                             : 0.9);
        out[Opacity] = 1;
        setColour(blob, error, out);
        keepWithin(out, m_limits);
        return out;
    }

    /// The Gaussian shows less than all of its colour, which therefore goes beyond the target's.
    void setColour(const Blob &blob, const FitPicture &error, FitStroke &out) const
    {
        const float *const drawn = m_drawn.at(blob.x, blob.y), *const lack = error.at(blob.x, blob.y);
        std::array<double, 3> rgb{};
        for (std::size_t c = 0; c < 3; ++c)
            rgb[c] = std::clamp(double(drawn[c] + 1.5f * lack[c]), 0.0, 1.0);
        const std::array<double, 3> ryb = rybFromSrgb(rgb);
        std::copy(ryb.begin(), ryb.end(), out.begin() + Red);
    }

    void take(const Blob &blob, const FitPicture &error, std::vector<char> &taken)
    {
        const Ridge ridge = ridgeAt(blob, error);
        const double d = m_deviations[blob.width], length = d * (2 + 3 * ridge.coherence);
        const std::array<float, 3> lack{error.at(blob.x, blob.y)[0], error.at(blob.x, blob.y)[1],
                                        error.at(blob.x, blob.y)[2]};
        const int reach = reachOf(blob);
        for (int y = std::max(0, blob.y - reach); y < std::min(m_error.height, blob.y + reach + 1); ++y)
            for (int x = std::max(0, blob.x - reach); x < std::min(m_error.width, blob.x + reach + 1); ++x) {
                const double dx = x - blob.x, dy = y - blob.y;
                if (dx * dx + dy * dy > reach * reach)
                    continue;
                const std::size_t pixel = std::size_t(y) * std::size_t(m_error.width) + std::size_t(x);
                taken[pixel] = 1;
                const double along = (dx * ridge.x + dy * ridge.y) / (1.4 * d + 0.3 * length),
                             across = (dy * ridge.x - dx * ridge.y) / (1.4 * d);
                const float share = float(std::exp(-along * along - across * across)) * weightAt(pixel);
                for (std::size_t c = 0; c < 3; ++c)
                    m_error.values[3 * pixel + c] -= share * lack[c];
            }
    }

    FitPicture m_error, m_drawn, m_weight;
    std::vector<double> m_deviations; ///< widths that are looked for, pixels
    double m_scale;
    const FitLimits &m_limits;
    std::uint64_t m_seed;
};

} // namespace

std::vector<FitStroke> strokesForError(const ErrorView &view, std::size_t count, const FitLimits &limits,
                                       std::uint64_t seed, const std::atomic<bool> *cancel)
{
    ErrorSearch search(view, limits, seed);
    std::vector<FitStroke> out;
    while (out.size() < count && !(cancel && *cancel)) {
        const std::size_t left = count - out.size(), quota = left <= 4 ? left : (left + 1) / 2;
        if (search.find(quota, out) == 0)
            break;
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const FitStroke &a, const FitStroke &b) { return a[LogSpread] > b[LogSpread]; });
    return out;
}

} // namespace suffuse::fitting
