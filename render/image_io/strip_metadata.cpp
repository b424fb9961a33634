#include "render/image_io/strip_metadata.h"

#include "render/image_io/file_parts.h"

#include <QSet>

namespace suffuse {

namespace {

/// Keeps the chunks that make the picture. A broken chunk ends it.
QByteArray strippedPng(const QByteArray &bytes)
{
    const FileNumbers numbers{bytes};
    QByteArray out = bytes.left(8);
    for (qsizetype at = 8; at + 12 <= bytes.size();) {
        const qsizetype length = qsizetype(numbers.at(quint64(at), 4)) + 12;
        const QByteArray type = bytes.mid(at + 4, 4);
        if (type == "IHDR" || type == "PLTE" || type == "tRNS" || type == "IDAT" || type == "IEND")
            out += bytes.mid(at, length);
        at += length;
    }
    return out;
}

/// Leaves out APP1 … APP13, APP15 and comments up to the first scan. APP14, which says how colours are stored, stays.
/// Stray bytes between markers are left out, as decoders do.
QByteArray strippedJpeg(const QByteArray &bytes)
{
    QByteArray out = bytes.left(2);
    qsizetype at = 2;
    while (const std::optional<JpegSegment> segment = nextJpegSegment(bytes, at)) {
        const int marker = segment->marker;
        if (marker == 0xDA)
            return out + bytes.mid(segment->at);
        if (marker == 0xD8 || marker == 0xD9 || segment->length < 4) // It begins again, ends, or is broken.
            return out;
        const bool isMetadata = marker == 0xFE || (marker >= 0xE1 && marker <= 0xEF && marker != 0xEE);
        if (!isMetadata)
            out += bytes.mid(segment->at, segment->length);
    }
    return out;
}

/// Gives entries of the first directory that are not about pixels a tag that nothing reads. Offsets stay.
QByteArray strippedTiff(const QByteArray &bytes)
{
    // These are XMP, IPTC, Photoshop, ICC profile, Exif, GPS, Interoperability, and the orientation, which libtiff
    // respects only for some pictures.
    static const QSet<quint64> metadata = {700, 33723, 34377, 34675, 34665, 34853, 40965, 274};
    const FileNumbers numbers{bytes, bytes.startsWith('I')};
    const std::optional<TiffDirectory> directory = tiffDirectory(numbers);
    if (!directory)
        return bytes;
    QByteArray out = bytes;
    for (quint64 i = 0; i < directory->count; ++i) {
        const quint64 at = directory->at(i);
        if (metadata.contains(numbers.at(at, 2)))
            out[qsizetype(at)] = out[qsizetype(at) + 1] = '\xFE';
    }
    return out;
}

} // namespace

QByteArray withoutMetadata(const QByteArray &bytes, ImageFormat format)
{
    switch (format) {
    case ImageFormat::Png:
        return strippedPng(bytes);
    case ImageFormat::Jpeg:
        return strippedJpeg(bytes);
    case ImageFormat::Tiff:
        return strippedTiff(bytes);
    default:
        return bytes;
    }
}

} // namespace suffuse
