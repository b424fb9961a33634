#include "render/image_io/module_proxy.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <dlfcn.h>

namespace suffuse {

namespace {

/// The part of libwebp's simple API that is needed (webp/encode.h, webp/decode.h: stable since 0.1). OpenImageIO
/// depends on the library, so it is there without its headers being.
struct WebP {
    std::size_t (*encodeRgb)(const std::uint8_t *, int, int, int, float, std::uint8_t **) = nullptr;
    std::size_t (*encodeRgba)(const std::uint8_t *, int, int, int, float, std::uint8_t **) = nullptr;
    std::size_t (*encodeLosslessRgb)(const std::uint8_t *, int, int, int, std::uint8_t **) = nullptr;
    std::size_t (*encodeLosslessRgba)(const std::uint8_t *, int, int, int, std::uint8_t **) = nullptr;
    std::uint8_t *(*decodeRgba)(const std::uint8_t *, std::size_t, int *, int *) = nullptr;
    int (*getInfo)(const std::uint8_t *, std::size_t, int *, int *) = nullptr;
    void (*free)(void *) = nullptr;

    WebP()
    {
        void *library = dlopen("libwebp.so.7", RTLD_NOW | RTLD_LOCAL);
        if (!library)
            return;
        resolve(library, "WebPEncodeRGB", encodeRgb);
        resolve(library, "WebPEncodeRGBA", encodeRgba);
        resolve(library, "WebPEncodeLosslessRGB", encodeLosslessRgb);
        resolve(library, "WebPEncodeLosslessRGBA", encodeLosslessRgba);
        resolve(library, "WebPDecodeRGBA", decodeRgba);
        resolve(library, "WebPGetInfo", getInfo);
        resolve(library, "WebPFree", free);
    }
    bool isComplete() const
    {
        return encodeRgb && encodeRgba && encodeLosslessRgb && encodeLosslessRgba && decodeRgba && getInfo && free;
    }

private:
    template <typename Function>
    static void resolve(void *library, const char *name, Function &function)
    {
        function = reinterpret_cast<Function>(dlsym(library, name));
    }
};

const WebP *webp()
{
    static const WebP library;
    return library.isComplete() ? &library : nullptr;
}

const char *const missing = "the library libwebp.so.7 is missing: install libwebp7";

} // namespace

bool writeWebP(const ImageModuleWrite &job, char *error, std::size_t size)
{
    if (!webp())
        return fail(error, size, missing);
    const int stride = job.width * job.channels;
    std::vector<std::uint8_t> pixels(std::size_t(stride) * job.height);
    for (int y = 0; y < job.height; ++y) {
        const float *row = job.row(job.context, y);
        if (!row)
            return fail(error, size, "stopped");
        std::transform(row, row + stride, pixels.data() + std::size_t(y) * stride,
                       [](float v) { return std::uint8_t(std::lround(255 * std::clamp(v, 0.0f, 1.0f))); });
    }
    std::uint8_t *encoded = nullptr;
    std::size_t bytes = 0;
    if (job.quality == 100)
        bytes = (job.channels == 4 ? webp()->encodeLosslessRgba
                                   : webp()->encodeLosslessRgb)(pixels.data(), job.width, job.height, stride, &encoded);
    else
        bytes = (job.channels == 4 ? webp()->encodeRgba : webp()->encodeRgb)(pixels.data(), job.width, job.height,
                                                                             stride, float(job.quality), &encoded);
    const std::unique_ptr<std::uint8_t, void (*)(void *)> owner(encoded, webp()->free);
    if (bytes == 0)
        return fail(error, size, "libwebp could not encode it");
    return job.file.write(job.file.context, encoded, bytes, 0) == bytes ||
           fail(error, size, "the file could not be written");
}

bool readWebP(const ImageModuleRead &job, char *error, std::size_t size)
{
    if (!webp())
        return fail(error, size, missing);
    const auto *bytes = static_cast<const std::uint8_t *>(job.bytes);
    int width = 0, height = 0;
    if (!webp()->getInfo(bytes, job.size, &width, &height))
        return fail(error, size, "it is damaged");
    if (width < 1 || height < 1 || width > job.maxSide || height > job.maxSide ||
        std::int64_t(width) * height > job.maxPixels)
        return fail(error, size, "it declares " + std::to_string(width) + " x " + std::to_string(height) + " pixels");
    const std::unique_ptr<std::uint8_t, void (*)(void *)> pixels(webp()->decodeRgba(bytes, job.size, &width, &height),
                                                                 webp()->free);
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
