// Brushes, MyPaint's brushes and GIMP's palettes.
#include "fuzzing.h"

#include "model/formats/brushes/brush_file.h"
#include "model/formats/brushes/gimp_palette.h"
#include "model/formats/brushes/mypaint_brush.h"

using namespace suffuse;

int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const QByteArray bytes = bytesOf(data, size);
    if (const Result<Brush> brush = readBrush(bytes, QStringLiteral("a.json"))) {
        const Result<Brush> again = readBrush(writeBrush(*brush), QStringLiteral("b.json"));
        require(again && *again == *brush, "brush: written = read");
    }
    if (const Result<LoadedBrush> brush = readMyPaintBrush(bytes, QStringLiteral("a.myb")))
        require(bool(readBrush(writeBrush(brush->brush), QStringLiteral("b.json"))), "what MyPaint's becomes is valid");
    if (const Result<GimpPalette> palette = readGimpPalette(bytes, QStringLiteral("a.gpl")))
        require(palette->swatches.size() <= std::size_t(bytes.size()), "no more swatches than bytes");
    return 0;
}
