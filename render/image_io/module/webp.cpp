#include "render/image_io/module/formats.h"
#include "render/image_io/module/webp_pixels.h"

#include <webp/decode.h>
#include <webp/mux.h>

#include <vector>

namespace suffuse {

namespace {

/// Sets up the encoder as the simple functions of its makers do, but with two threads.
bool configure(WebPConfig &config, int quality)
{
    if (!WebPConfigInit(&config))
        return false;
    config.thread_level = 1;
    config.quality = float(quality);
    if (quality < 100)
        return true;
    config.lossless = 1;
    config.quality = 70;
    return true;
}

/// Writes the picture with a profile beside it. Returns false if it cannot be put there or written.
bool writeWithProfile(const WebPMemoryWriter &picture, const ImageModuleWrite &job)
{
    const WebPData pixels{picture.mem, picture.size};
    const WebPData profile{static_cast<const std::uint8_t *>(job.profile), job.profileSize};
    const std::unique_ptr<WebPMux, void (*)(WebPMux *)> mux(WebPMuxNew(), WebPMuxDelete);
    WebPData whole{};
    const std::unique_ptr<WebPData, void (*)(WebPData *)> owner(&whole, WebPDataClear);
    return mux && WebPMuxSetImage(mux.get(), &pixels, 0) == WEBP_MUX_OK &&
           WebPMuxSetChunk(mux.get(), "ICCP", &profile, 0) == WEBP_MUX_OK &&
           WebPMuxAssemble(mux.get(), &whole) == WEBP_MUX_OK &&
           job.file.write(job.file.context, whole.bytes, whole.size, 0) == whole.size;
}

} // namespace

WebPBytes encodeWebP(const WebPPixels &from, int quality, char *error, std::size_t size)
{
    WebPBytes bytes(nullptr, [](WebPMemoryWriter *memory) {
        WebPMemoryWriterClear(memory);
        delete memory;
    });
    WebPConfig config;
    WebPPicture picture;
    if (!configure(config, quality) || !WebPPictureInit(&picture)) {
        fail(error, size, "libwebp is of another version");
        return bytes;
    }
    const std::unique_ptr<WebPPicture, void (*)(WebPPicture *)> pictureOwner(&picture, WebPPictureFree);
    bytes.reset(new WebPMemoryWriter);
    WebPMemoryWriterInit(bytes.get());
    picture.use_argb = config.lossless;
    picture.width = from.width;
    picture.height = from.height;
    picture.writer = WebPMemoryWrite;
    picture.custom_ptr = bytes.get();
    const auto take = from.channels == 4 ? WebPPictureImportRGBA : WebPPictureImportRGB;
    if (!take(&picture, from.pixels, from.stride) || !WebPEncode(&config, &picture)) {
        fail(error, size, "libwebp could not encode it");
        bytes.reset();
    }
    return bytes;
}

bool writeWebP(const ImageModuleWrite &job, char *error, std::size_t size)
{
    const int stride = job.width * job.channels;
    std::vector<std::uint8_t> pixels(std::size_t(stride) * std::size_t(job.height));
    for (int y = 0; y < job.height; ++y) {
        const float *row = job.row(job.context, y);
        if (!row)
            return fail(error, size, "stopped");
        std::transform(row, row + stride, pixels.data() + std::size_t(y) * std::size_t(stride),
                       [](float v) { return toWhole<std::uint8_t>(v, 255); });
    }
    const WebPBytes bytes =
        encodeWebP({pixels.data(), stride, job.width, job.height, job.channels}, job.quality, error, size);
    if (!bytes)
        return false;
    const bool written = job.profile ? writeWithProfile(*bytes, job)
                                     : job.file.write(job.file.context, bytes->mem, bytes->size, 0) == bytes->size;
    return written || fail(error, size, "the file could not be written");
}

bool readWebP(const ImageModuleRead &job, char *error, std::size_t size)
{
    const auto *bytes = static_cast<const std::uint8_t *>(job.bytes);
    int width = 0, height = 0;
    if (!WebPGetInfo(bytes, job.size, &width, &height))
        return fail(error, size, "it is damaged");
    if (width < 1 || height < 1 || width > job.maxSide || height > job.maxSide ||
        std::int64_t(width) * height > job.maxPixels)
        return fail(error, size, "it declares " + std::to_string(width) + " x " + std::to_string(height) + " pixels");
    const std::unique_ptr<std::uint8_t, void (*)(void *)> pixels(WebPDecodeRGBA(bytes, job.size, &width, &height),
                                                                 WebPFree);
    if (!pixels)
        return fail(error, size, "it is damaged or animated");
    job.begin(job.context, width, height, 4, false, false);
    std::vector<float> row(std::size_t(width) * 4);
    for (int y = 0; y < height; ++y) {
        const std::uint8_t *from = pixels.get() + std::size_t(y) * row.size();
        std::transform(from, from + row.size(), row.begin(), [](std::uint8_t v) { return float(v) / 255; });
        job.row(job.context, y, row.data());
    }
    return true;
}

} // namespace suffuse
