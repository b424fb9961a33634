#include "render/target.h"

#include <algorithm>
#include <atomic>

namespace suffuse {

std::uint64_t Target::nextSerial()
{
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

void FloatPicture::store(const PixelRect &rect, const float *pixels, int stride)
{
    for (int y = 0; y < rect.height; ++y)
        std::copy_n(pixels + std::size_t(y) * stride * 4, std::size_t(rect.width) * 4,
                    rgba.data() + (std::size_t(rect.y + y) * width + rect.x) * 4);
}

void Picture8::store(const PixelRect &rect, const float *pixels, int stride)
{
    const auto level = [](float v) { return std::uint32_t(v * 255.0f + 0.5f); };
    for (int y = 0; y < rect.height; ++y) {
        const float *in = pixels + std::size_t(y) * stride * 4;
        std::uint32_t *out = argb.data() + std::size_t(rect.y + y) * width + rect.x;
        for (int x = 0; x < rect.width; ++x, in += 4)
            out[x] = level(in[3]) << 24 | level(in[0]) << 16 | level(in[1]) << 8 | level(in[2]);
    }
}

} // namespace suffuse
