#include "render/drawing/pdf_image.h"

#include "render/image_io/embedded_profile.h"
#include "render/image_io/file_parts.h"

#include <cmath>

namespace suffuse {

namespace {

QByteArray imageDictionary(qint64 width, qint64 height, const QByteArray &space, const QByteArray &more)
{
    return "<< /Type /XObject /Subtype /Image /Width " + QByteArray::number(width) + " /Height " +
           QByteArray::number(height) + " /ColorSpace /" + space + " /BitsPerComponent 8" + more + " >>";
}

/// The channels as colour spaces of PDF; empty for others.
QByteArray spaceOf(int channels)
{
    return channels == 1 ? QByteArrayLiteral("DeviceGray")
                         : (channels == 3 ? QByteArrayLiteral("DeviceRGB") : QByteArray());
}

/// A PNG's stream of pixels is what PDF has, too, if it has no palette, no alpha, no profile, and is not interlaced. 0:
/// it is none of these.
int addPacked(pdf::Objects &objects, const QByteArray &png)
{
    constexpr qsizetype firstChunk = 8, header = 16;
    const FileNumbers numbers{png};
    const quint64 width = numbers.at(header, 4), height = numbers.at(header + 4, 4), depth = numbers.at(header + 8, 1),
                  colour = numbers.at(header + 9, 1), interlace = numbers.at(header + 12, 1);
    if (depth != 8 || (colour != 0 && colour != 2) || interlace != 0)
        return 0;
    QByteArray packed;
    for (qsizetype at = firstChunk; at + 8 <= png.size();) {
        const qsizetype length = qsizetype(numbers.at(quint64(at), 4));
        const QByteArray type = png.mid(at + 4, 4);
        if (type == "tRNS" || type == "iCCP")
            return 0;
        if (type == "IDAT")
            packed += png.mid(at + 8, length);
        at += 12 + length;
    }
    const int channels = colour == 2 ? 3 : 1;
    return objects.addStream(imageDictionary(qint64(width), qint64(height), spaceOf(channels),
                                             " /Filter /FlateDecode /DecodeParms << /Predictor 15 /Colors " +
                                                 QByteArray::number(channels) + " /Columns " +
                                                 QByteArray::number(width) + " >>"),
                             packed);
}

/// So is a JPEG of grey or of red, green and blue.
int addJpeg(pdf::Objects &objects, const QByteArray &jpeg)
{
    const FileNumbers numbers{jpeg};
    if (!embeddedProfile(jpeg, ImageFormat::Jpeg).isEmpty())
        return 0;
    for (qsizetype at = 2; const std::optional<JpegSegment> segment = nextJpegSegment(jpeg, at);) {
        const int marker = segment->marker;
        if (marker < 0xC0 || marker > 0xCF || marker == 0xC4 || marker == 0xC8 || marker == 0xCC)
            continue;
        const quint64 frame = quint64(segment->at) + 4;
        const QByteArray space = spaceOf(int(numbers.at(frame + 5, 1)));
        if (numbers.at(frame, 1) != 8 || space.isEmpty() || marker > 0xC2)
            return 0;
        return objects.addStream(imageDictionary(qint64(numbers.at(frame + 3, 2)), qint64(numbers.at(frame + 1, 2)),
                                                 space, " /Filter /DCTDecode"),
                                 jpeg);
    }
    return 0;
}

char level(float value)
{
    return char(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
}

} // namespace

Result<int> addImage(pdf::Objects &objects, const DrawnImage &image)
{
    const ImageFormat format = detectImageFormat(image.bytes);
    const int asIs = format == ImageFormat::Jpeg ? addJpeg(objects, image.bytes)
                                                 : (format == ImageFormat::Png ? addPacked(objects, image.bytes) : 0);
    if (asIs != 0)
        return asIs;
    const Result<FloatPicture> picture = readImage(image.bytes, nameOf(format));
    if (!picture)
        return Error{picture.error()};
    const std::size_t pixels = picture->rgba.size() / 4;
    QByteArray colours(qsizetype(3 * pixels), Qt::Uninitialized), alphas(qsizetype(pixels), Qt::Uninitialized);
    bool isOpaque = true;
    for (std::size_t i = 0; i < pixels; ++i) {
        const float *rgba = picture->rgba.data() + 4 * i;
        for (std::size_t c = 0; c < 3; ++c)
            colours[qsizetype(3 * i + c)] = level(rgba[c]);
        alphas[qsizetype(i)] = level(rgba[3]);
        isOpaque = isOpaque && alphas[qsizetype(i)] == char(255);
    }
    QByteArray mask;
    if (!isOpaque) {
        const int soft = objects.addStream(imageDictionary(picture->width, picture->height, spaceOf(1), {}), alphas);
        mask = " /SMask " + pdf::reference(soft);
    }
    return objects.addStream(imageDictionary(picture->width, picture->height, spaceOf(3), mask), colours);
}

} // namespace suffuse
