// Tiles of pictures of any size: JPEG files, and tiles of TIFF files, packed once.
#include "render/image_io/module/formats.h"

#include <libdeflate.h>

#include <memory>
#include <vector>

namespace suffuse {

namespace {

constexpr int level =
    1; ///< Level 3 takes half as long again for a twelfth less, level 6 four times as long for a sixth less.

/// The channels of a row, red first, as TIFF stores them.
void putRow(const ImageModuleTile &tile, int y, std::uint8_t *to)
{
    const std::uint32_t *from = tile.argb + std::size_t(y) * tile.stride;
    for (int x = 0; x < tile.width; ++x, to += tile.channels) {
        to[0] = std::uint8_t(from[x] >> 16);
        to[1] = std::uint8_t(from[x] >> 8);
        to[2] = std::uint8_t(from[x]);
        if (tile.channels == 4)
            to[3] = std::uint8_t(from[x] >> 24);
    }
}

void putRow(const ImageModuleTile &tile, int y, std::uint16_t *to)
{
    const float *from = tile.rgba + std::size_t(y) * tile.stride * 4;
    for (int x = 0; x < tile.width; ++x, from += 4)
        for (int c = 0; c < tile.channels; ++c)
            *to++ = toWhole<std::uint16_t>(from[c], 65535);
}

/// Replaces each value by what it adds to its left neighbour, as TIFF's horizontal predictor does.
template <typename Value>
void takeDifferences(Value *row, std::size_t count, std::size_t channels)
{
    for (std::size_t i = count; i-- > channels;)
        row[i] = Value(row[i] - row[i - channels]);
}

template <typename Value>
std::vector<Value> differences(const ImageModuleTile &tile)
{
    const std::size_t stride = std::size_t(tile.side) * std::size_t(tile.channels);
    std::vector<Value> values(stride * std::size_t(tile.side));
    for (int y = 0; y < tile.height; ++y) {
        Value *row = values.data() + std::size_t(y) * stride;
        putRow(tile, y, row);
        takeDifferences(row, stride, std::size_t(tile.channels));
    }
    return values;
}

bool pack(const ImageModuleTile &tile, const void *values, std::size_t bytes, char *error, std::size_t size)
{
    thread_local const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor *)> compressor(
        libdeflate_alloc_compressor(level), libdeflate_free_compressor);
    if (!compressor)
        return fail(error, size, "there is not enough memory");
    std::vector<unsigned char> packed(libdeflate_zlib_compress_bound(compressor.get(), bytes));
    const std::size_t count = libdeflate_zlib_compress(compressor.get(), values, bytes, packed.data(), packed.size());
    if (count == 0 || tile.file.write(tile.file.context, packed.data(), count, 0) != count)
        return fail(error, size, "the tile could not be packed");
    return true;
}

bool writeTile(const ImageModuleTile &tile, char *error, std::size_t size)
{
    if (tile.kind == ModuleTileJpeg)
        return writeJpegTile(tile, error, size);
    if (tile.depth == ModuleBits8) {
        const std::vector<std::uint8_t> values = differences<std::uint8_t>(tile);
        return pack(tile, values.data(), values.size(), error, size);
    }
    const std::vector<std::uint16_t> values = differences<std::uint16_t>(tile);
    return pack(tile, values.data(), values.size() * sizeof values[0], error, size);
}

} // namespace

} // namespace suffuse

extern "C" __attribute__((visibility("default"))) bool suffuse_image_tile(const suffuse::ImageModuleTile *tile,
                                                                          char *error, std::size_t size)
{
    return suffuse::guarded([&] { return suffuse::writeTile(*tile, error, size); }, error, size);
}
