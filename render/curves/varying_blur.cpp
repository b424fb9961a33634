#include "render/curves/varying_blur.h"

#include "render/threads/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::curves {

namespace {

constexpr float leastBlur = 0.25f;   ///< pixels: below, a Gaussian reaches no neighbour
constexpr float greatestOfLevel = 4; ///< pixels of a level: wider ones are taken of a smaller picture
constexpr float reach = 3;           ///< in deviations

struct BlurLevel {
    int width = 0, height = 0;
    std::vector<float> picture; ///< three values a pixel
};

BlurLevel halved(const BlurLevel &from)
{
    BlurLevel out;
    out.width = (from.width + 1) / 2, out.height = (from.height + 1) / 2;
    out.picture.assign(3 * std::size_t(out.width) * std::size_t(out.height), 0);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            for (int part = 0; part < 4; ++part) {
                // Where the last column or row has no partner, it is one twice.
                const int fromX = std::min(2 * x + part % 2, from.width - 1),
                          fromY = std::min(2 * y + part / 2, from.height - 1);
                for (std::size_t c = 0; c < 3; ++c)
                    out.picture[3 * (std::size_t(y) * std::size_t(out.width) + std::size_t(x)) + c] +=
                        0.25f *
                        from.picture[3 * (std::size_t(fromY) * std::size_t(from.width) + std::size_t(fromX)) + c];
            }
    return out;
}

/// The mean around a point of a level.
std::array<float, 3> meanAround(const BlurLevel &level, float x, float y, float deviation)
{
    const float far = reach * deviation, scale = -0.5f / (deviation * deviation);
    const int left = std::max(0, int(std::ceil(x - far - 0.5f))),
              right = std::min(level.width - 1, int(std::floor(x + far - 0.5f)));
    const int top = std::max(0, int(std::ceil(y - far - 0.5f))),
              bottom = std::min(level.height - 1, int(std::floor(y + far - 0.5f)));
    constexpr int most = 2 * int(reach * greatestOfLevel) + 4;
    std::array<float, most> across{};
    for (int i = left; i <= right; ++i) {
        const float d = float(i) + 0.5f - x;
        across[std::size_t(i - left)] = std::exp(scale * d * d);
    }
    std::array<float, 3> sum{};
    float weights = 0;
    for (int j = top; j <= bottom; ++j) {
        const float d = float(j) + 0.5f - y, down = std::exp(scale * d * d);
        const float *v = level.picture.data() + 3 * (std::size_t(j) * std::size_t(level.width) + std::size_t(left));
        for (int i = left; i <= right; ++i, v += 3) {
            const float w = down * across[std::size_t(i - left)];
            weights += w;
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += w * v[c];
        }
    }
    for (float &v : sum)
        v /= weights;
    return sum;
}

} // namespace

std::vector<float> blurredBy(const std::vector<float> &picture, std::span<const float> deviation, int width, int height,
                             int threads, const std::atomic<bool> *cancel)
{
    std::vector<float> out = picture;
    const float widest = *std::max_element(deviation.begin(), deviation.end());
    if (!(widest > leastBlur))
        return out;
    std::vector<BlurLevel> levels{{width, height, picture}};
    for (float d = widest; d > greatestOfLevel && (levels.back().width > 1 || levels.back().height > 1); d /= 2)
        levels.push_back(halved(levels.back()));
    parallelFor(std::size_t(height), Threads(threads), [&](std::size_t y) {
        for (int x = 0; x < width && !(cancel && *cancel); ++x) {
            const std::size_t p = y * std::size_t(width) + std::size_t(x);
            const float d = deviation[p];
            if (!(d > leastBlur))
                continue;
            std::size_t level = 0;
            float size = 1;
            for (; level + 1 < levels.size() && d > greatestOfLevel * size; ++level)
                size *= 2;
            // A pixel of the level is the mean over size² pixels already, which has the variance (size² − 1)/12.
            const float own = std::sqrt(d * d - (size * size - 1) / 12) / size;
            const std::array<float, 3> mean = meanAround(levels[level], (float(x) + 0.5f) / size,
                                                         (float(y) + 0.5f) / size, std::min(own, greatestOfLevel));
            std::copy(mean.begin(), mean.end(), out.begin() + std::ptrdiff_t(3 * p));
        }
    });
    return out;
}

} // namespace suffuse::curves
