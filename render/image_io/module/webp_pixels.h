// Encodes WebP's pictures and films.
#pragma once

#include <webp/encode.h>

#include <cstdint>
#include <memory>

namespace suffuse {

/// A part of a picture of 8 bit pixels: `pixels` is its first pixel, `stride` the bytes from row to row.
struct WebPPixels {
    const std::uint8_t *pixels = nullptr;
    int stride = 0;
    int width = 0, height = 0;
    int channels = 3; ///< 3, or 4 with alpha
};

using WebPBytes = std::unique_ptr<WebPMemoryWriter, void (*)(WebPMemoryWriter *)>;

/// The pixels as a file of one picture; null, with a message, if libwebp fails. `quality` is 1 … 100, where 100 is
/// lossless.
WebPBytes encodeWebP(const WebPPixels &from, int quality, char *error, std::size_t size);

} // namespace suffuse
