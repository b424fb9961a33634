#include "render/image_io/orientation.h"

#include "render/image_io/file_parts.h"

#include <algorithm>

namespace suffuse {

namespace {

/// The tag in the first directory of a TIFF file. Exif data are such a file, too.
Orientation orientationOfTiff(const QByteArray &tiff)
{
    constexpr quint64 orientationTag = 274, shortType = 3;
    const FileNumbers numbers{tiff, tiff.startsWith("II")};
    const quint64 version = numbers.at(2, 2);
    if (!(tiff.startsWith("II") || tiff.startsWith("MM")) || !(version == 42 || version == 43))
        return {};
    const std::optional<TiffDirectory> directory = tiffDirectory(numbers);
    for (quint64 i = 0; directory && i < directory->count; ++i) {
        const quint64 at = directory->at(i);
        if (numbers.at(at, 2) == orientationTag)
            return numbers.at(at + 2, 2) == shortType ? Orientation(int(numbers.at(directory->valueAt(i), 2)))
                                                      : Orientation();
    }
    return {};
}

/// The Exif data of the first APP1 segment that has some. Segments after the first scan do not count.
QByteArray exifOfJpeg(const QByteArray &bytes)
{
    const QByteArray mark("Exif\0\0", 6);
    qsizetype at = 2;
    while (const std::optional<JpegSegment> segment = nextJpegSegment(bytes, at)) {
        if ((segment->marker >= 0xD8 && segment->marker <= 0xDA) || segment->length < 4)
            return {};
        const QByteArray content = bytes.mid(segment->at + 4, segment->length - 4);
        if (segment->marker == 0xE1 && content.startsWith(mark))
            return content.mid(mark.size());
    }
    return {};
}

} // namespace

ImageRun Orientation::run(int y, int width, int height) const
{
    const int right = width - 1, bottom = height - 1;
    switch (m_exif) {
    case 2:
        return {right, y, -1, 0, {}, width};
    case 3:
        return {right, bottom - y, -1, 0, {}, width};
    case 4:
        return {0, bottom - y, 1, 0, {}, width};
    case 5:
        return {y, 0, 0, 1, {}, width};
    case 6:
        return {bottom - y, 0, 0, 1, {}, width};
    case 7:
        return {bottom - y, right, 0, -1, {}, width};
    case 8:
        return {y, right, 0, -1, {}, width};
    default:
        return {0, y, 1, 0, {}, width};
    }
}

Orientation orientationOf(const QByteArray &bytes, ImageFormat format)
{
    switch (format) {
    case ImageFormat::Jpeg:
        return orientationOfTiff(exifOfJpeg(bytes));
    case ImageFormat::Tiff:
        return orientationOfTiff(bytes);
    case ImageFormat::Png:
        return orientationOfTiff(chunkOf(bytes, 8, "eXIf"));
    case ImageFormat::WebP: {
        // Some writers put JPEG's mark before it.
        const QByteArray exif = chunkOf(bytes, 12, "EXIF");
        return orientationOfTiff(exif.startsWith("Exif") ? exif.mid(6) : exif);
    }
    default:
        return {};
    }
}

} // namespace suffuse
