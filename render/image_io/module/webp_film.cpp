// Animated WebP. A frame has what changed, encoded like a still picture, and libwebp's multiplexer makes the file. Its
// WebPAnimEncoder would choose what changed, too, but leaves out small differences from the frame before. So whatever
// changes slowly, as wet paint does, would stand still.
#include "render/image_io/module/entry.h"
#include "render/image_io/module/webp_pixels.h"

#include <webp/mux.h>

#include <vector>

namespace suffuse {

namespace {

/// The pixels from (left, top) up to right and bottom, which are outside.
struct Changed {
    int left = 0, top = 0, right = 0, bottom = 0;
};

/// Where two pictures differ, from even coordinates on, as the format demands; empty if they are equal.
Changed difference(const std::uint8_t *a, const std::uint8_t *b, const ImageModuleFilm &film)
{
    Changed out{film.width, film.height, 0, 0};
    const std::ptrdiff_t stride = std::ptrdiff_t(film.width) * film.channels;
    for (int y = 0; y < film.height; ++y, a += stride, b += stride) {
        const std::ptrdiff_t first = std::mismatch(a, a + stride, b).first - a;
        if (first == stride)
            continue;
        std::ptrdiff_t last = stride - 1;
        while (a[last] == b[last])
            --last;
        out = {std::min(out.left, int(first / film.channels)), std::min(out.top, y),
               std::max(out.right, int(last / film.channels) + 1), y + 1};
    }
    out.left &= ~1;
    out.top &= ~1;
    return out;
}

/// The frames so far, and the one whose duration is not known yet.
struct FilmWork {
    std::unique_ptr<WebPMux, void (*)(WebPMux *)> mux{WebPMuxNew(), WebPMuxDelete};
    std::vector<std::uint8_t> before; ///< the picture of the frame that waits
    WebPBytes waiting{nullptr, nullptr};
    Changed place;
    std::int64_t begun = 0; ///< when the frame that waits has begun, in milliseconds

    /// Ends the frame that waits.
    bool push(std::int64_t end)
    {
        WebPMuxFrameInfo frame{};
        frame.bitstream = {waiting->mem, waiting->size};
        frame.x_offset = place.left;
        frame.y_offset = place.top;
        frame.duration = int(std::min<std::int64_t>(end - begun, 0xFFFFFF));
        frame.id = WEBP_CHUNK_ANMF;
        frame.dispose_method = WEBP_MUX_DISPOSE_NONE;
        frame.blend_method = WEBP_MUX_NO_BLEND;
        begun = end;
        return WebPMuxPushFrame(mux.get(), &frame, 1) == WEBP_MUX_OK;
    }
};

bool add(ImageModuleFilm &film, const std::uint8_t *pixels, std::int64_t milliseconds, char *error, std::size_t size)
{
    if (!film.work)
        film.work = new FilmWork;
    auto &work = *static_cast<FilmWork *>(film.work);
    Changed place{0, 0, film.width, film.height};
    if (work.waiting) {
        place = difference(work.before.data(), pixels, film);
        if (place.right == 0) // It is still shown.
            return true;
        if (!work.push(milliseconds))
            return fail(error, size, "libwebp could not take a frame");
    }
    const std::size_t stride = std::size_t(film.width) * std::size_t(film.channels);
    const std::uint8_t *first =
        pixels + std::size_t(place.top) * stride + std::size_t(place.left) * std::size_t(film.channels);
    work.waiting = encodeWebP({first, int(stride), place.right - place.left, place.bottom - place.top, film.channels},
                              film.quality, error, size);
    if (!work.waiting)
        return false;
    work.place = place;
    work.before.assign(pixels, pixels + stride * std::size_t(film.height));
    film.bytes += std::int64_t(work.waiting->size);
    return true;
}

bool finish(ImageModuleFilm &film, const ImageModuleFile *file, std::int64_t milliseconds, char *error,
            std::size_t size)
{
    const std::unique_ptr<FilmWork> work(static_cast<FilmWork *>(film.work));
    film.work = nullptr;
    if (!file)
        return true;
    const WebPMuxAnimParams shown{0, film.loops ? 0 : 1}; // on a transparent ground
    WebPData bytes{};
    const std::unique_ptr<WebPData, void (*)(WebPData *)> owner(&bytes, WebPDataClear);
    if (!work || !work->waiting || !work->push(milliseconds) ||
        WebPMuxSetCanvasSize(work->mux.get(), film.width, film.height) != WEBP_MUX_OK ||
        WebPMuxSetAnimationParams(work->mux.get(), &shown) != WEBP_MUX_OK ||
        WebPMuxAssemble(work->mux.get(), &bytes) != WEBP_MUX_OK)
        return fail(error, size, "libwebp could not join the frames");
    return file->write(file->context, bytes.bytes, bytes.size, 0) == bytes.size ||
           fail(error, size, "the file could not be written");
}

} // namespace

} // namespace suffuse

extern "C" {
__attribute__((visibility("default"))) bool suffuse_image_film_add(suffuse::ImageModuleFilm *film,
                                                                   const std::uint8_t *pixels,
                                                                   std::int64_t milliseconds, char *error,
                                                                   std::size_t size)
{
    return suffuse::guarded([&] { return suffuse::add(*film, pixels, milliseconds, error, size); }, error, size);
}
__attribute__((visibility("default"))) bool suffuse_image_film_end(suffuse::ImageModuleFilm *film,
                                                                   const suffuse::ImageModuleFile *file,
                                                                   std::int64_t milliseconds, char *error,
                                                                   std::size_t size)
{
    return suffuse::guarded([&] { return suffuse::finish(*film, file, milliseconds, error, size); }, error, size);
}
}
