#include "render/target.h"

#include "render/cpu/kernels.h"

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
    for (int y = 0; y < rect.height; ++y)
        cpu::kernels().toArgb(pixels + std::size_t(y) * stride * 4, rect.width,
                              argb.data() + std::size_t(rect.y + y) * width + rect.x);
}

void Picture8::storeArgb(const PixelRect &rect, const std::uint32_t *pixels, int stride)
{
    for (int y = 0; y < rect.height; ++y)
        std::copy_n(pixels + std::size_t(y) * stride, rect.width,
                    argb.data() + std::size_t(rect.y + y) * width + rect.x);
}

} // namespace suffuse
