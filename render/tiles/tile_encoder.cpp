#include "render/tiles/tile_encoder.h"

#include "render/image_io/image_module.h"

#include <QCoreApplication>

#include <array>
#include <vector>

namespace suffuse {

namespace {

/// A file that only grows.
ImageModuleFile growing(QByteArray &bytes)
{
    ImageModuleFile out{};
    out.context = &bytes;
    out.write = [](void *c, const void *from, std::size_t n, std::int64_t) {
        static_cast<QByteArray *>(c)->append(static_cast<const char *>(from), qsizetype(n));
        return n;
    };
    return out;
}

/// PNG goes the way of whole pictures.
Result<QByteArray> encodePng(const SheetPicture &sheet, const PixelRect &at, const ImageOptions &options)
{
    std::vector<float> row(std::size_t(at.width) * 4);
    const PictureRows rows(at.width, at.height, [&](int y) -> const float * {
        if (sheet.isDeep)
            return sheet.floats.at(at.x, at.y + y);
        const std::uint32_t *from =
            sheet.bits8.argb.data() + std::size_t(at.y + y) * std::size_t(sheet.bits8.width) + std::size_t(at.x);
        for (std::size_t i = 0; i < row.size(); ++i)
            row[i] = float(from[i / 4] >> std::array{16, 8, 0, 24}[i % 4] & 255) / 255;
        return row.data();
    });
    return encodeImage(ImageFormat::Png, rows, options, QStringLiteral("tile.png"));
}

} // namespace

Result<QByteArray> encodeTile(const SheetPicture &sheet, const PixelRect &at, const TileEncoding &encoding)
{
    if (encoding.format == TileFormat::Png)
        return encodePng(sheet, at, encoding.image);
    const Result<ImageModule> &module = writingModule(ImageFormat::Jpeg, 0);
    if (!module)
        return Error{module.error()};
    QByteArray bytes;
    ImageModuleTile tile{};
    tile.kind = encoding.format == TileFormat::Jpeg ? ModuleTileJpeg : ModuleTileTiff;
    tile.file = growing(bytes);
    tile.width = at.width;
    tile.height = at.height;
    tile.side = encoding.side;
    tile.channels = encoding.image.alpha ? 4 : 3;
    tile.depth = sheet.isDeep ? ModuleBits16 : ModuleBits8;
    if (sheet.isDeep)
        tile.rgba = sheet.floats.at(at.x, at.y);
    else
        tile.argb = sheet.bits8.argb.data() + std::size_t(at.y) * std::size_t(sheet.bits8.width) + std::size_t(at.x);
    tile.stride = std::size_t(sheet.isDeep ? sheet.floats.width : sheet.bits8.width);
    tile.quality = encoding.image.quality;
    std::array<char, 512> error{};
    if (module->tile && module->tile(&tile, error.data(), error.size()))
        return bytes;
    return Error{
        QCoreApplication::translate("Tiles", "a tile cannot be encoded: %1").arg(QString::fromUtf8(error.data()))};
}

} // namespace suffuse
