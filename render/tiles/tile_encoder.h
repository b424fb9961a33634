// Tiles as bytes of files.
#pragma once

#include "render/image_io/image_io.h"

namespace suffuse {

enum class TileFormat { Jpeg, Png, Tiff };

struct TileEncoding {
    TileFormat format = TileFormat::Jpeg;
    int side = 256; ///< of TIFF's tiles, which are never smaller
    ImageOptions image;

    int bits() const { return image.depth == ImageDepth::Bits16 ? 16 : 8; }
};

/// A drawn sheet: of 8 bits, or of floats for more. Tiles of 8 bits have the bits of the whole picture in a file.
struct SheetPicture {
    Picture8 bits8;
    FloatPicture floats;
    bool isDeep = false;

    Target &target() { return isDeep ? static_cast<Target &>(floats) : bits8; }
};

/// Encodes a rectangle of the sheet. Any thread may call it.
Result<QByteArray> encodeTile(const SheetPicture &sheet, const PixelRect &at, const TileEncoding &encoding);

} // namespace suffuse
