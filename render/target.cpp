#include "render/target.h"

#include "render/cpu/kernels.h"

#include <algorithm>
#include <atomic>
#include <cstring>

namespace suffuse {

std::uint64_t Target::nextSerial()
{
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

namespace {

/// Moves rows of `stride` values, `perPixel` of them a pixel, within a picture. What comes into view keeps what was
/// there.
template <class Values>
void moveRows(Values &values, int width, int height, int perPixel, int dx, int dy)
{
    const auto kept = std::size_t(std::max(0, width - std::abs(dx)) * perPixel);
    const auto at = [&](int x, int y) {
        return values.data() + (std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(perPixel);
    };
    const int rows = std::max(0, height - std::abs(dy)), fromX = std::max(0, -dx), fromY = std::max(0, -dy);
    for (int i = 0; i < rows; ++i) {
        const int y = fromY + (dy > 0 ? rows - 1 - i : i); // Rows that are still needed are not overwritten.
        std::memmove(at(fromX + dx, y + dy), at(fromX, y), kept * sizeof(*values.data()));
    }
}

} // namespace

bool FloatPicture::move(int dx, int dy)
{
    moveRows(rgba, width, height, 4, dx, dy);
    return true;
}

bool Picture8::move(int dx, int dy)
{
    moveRows(argb, width, height, 1, dx, dy);
    return true;
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
