// What WebP's pictures and films are encoded by.
#pragma once

#include <webp/encode.h>

#include <cstdint>
#include <memory>

namespace suffuse {

/// Part of a picture of 8 bit pixels: `pixels` is its first one, `stride` the bytes from row to row.
struct WebPPixels {
    const std::uint8_t *pixels = nullptr;
    int stride = 0;
    int width = 0, height = 0;
    int channels = 3; ///< or 4 with alpha
};

using WebPBytes = std::unique_ptr<WebPMemoryWriter, void (*)(WebPMemoryWriter *)>;

/// The pixels as a file of one picture; null, with a message, where libwebp fails. `quality`: 1 … 100, which is
/// lossless.
WebPBytes encodeWebP(const WebPPixels &from, int quality, char *error, std::size_t size);

} // namespace suffuse
