#include "render/image_io/embedded_profile.h"

#include "model/formats/gzip.h"
#include "render/image_io/colour_conversion.h"
#include "render/image_io/file_parts.h"

#include <map>

namespace suffuse {

namespace {

/// A name of at most 79 bytes, a zero, the kind of packing (zlib's is 0), and the profile, packed.
QByteArray profileOfPng(const QByteArray &bytes)
{
    const QByteArray chunk = chunkOf(bytes, 8, "iCCP");
    const qsizetype name = chunk.left(80).indexOf('\0');
    if (name < 0 || name + 2 > chunk.size() || chunk[name + 1] != 0)
        return {};
    const Result<QByteArray> profile = unpackedZlib(chunk.mid(name + 2), largestProfile);
    return profile ? *profile : QByteArray();
}

/// A profile is cut into segments, which say their number and how many there are; they may come in any order.
QByteArray profileOfJpeg(const QByteArray &bytes)
{
    const QByteArray mark("ICC_PROFILE\0", 12);
    std::map<int, QByteArray> parts;
    int count = 0;
    qsizetype at = 2;
    while (const std::optional<JpegSegment> segment = nextJpegSegment(bytes, at)) {
        if ((segment->marker >= 0xD8 && segment->marker <= 0xDA) || segment->length < 4)
            break;
        const QByteArray content = bytes.mid(segment->at + 4, segment->length - 4);
        if (segment->marker != 0xE2 || !content.startsWith(mark) || content.size() < mark.size() + 2)
            continue;
        count = static_cast<unsigned char>(content[mark.size() + 1]);
        parts.emplace(static_cast<unsigned char>(content[mark.size()]), content.mid(mark.size() + 2));
    }
    QByteArray profile;
    for (int number = 1; number <= count; ++number) {
        const auto part = parts.find(number);
        if (part == parts.end())
            return {};
        profile += part->second;
    }
    return profile;
}

QByteArray profileOfTiff(const QByteArray &bytes)
{
    constexpr quint64 profileTag = 34675;
    const FileNumbers numbers{bytes, bytes.startsWith('I')};
    const std::optional<TiffDirectory> directory = tiffDirectory(numbers);
    for (quint64 i = 0; directory && i < directory->count; ++i) {
        if (numbers.at(directory->at(i), 2) != profileTag)
            continue;
        const int wide = directory->big ? 8 : 4;
        const quint64 size = numbers.at(directory->at(i) + 4, wide);
        const quint64 place = numbers.at(directory->valueAt(i), wide);
        const auto all = quint64(bytes.size());
        return place < all && size <= all - place && size <= quint64(largestProfile)
                   ? bytes.mid(qsizetype(place), qsizetype(size))
                   : QByteArray();
    }
    return {};
}

} // namespace

QByteArray embeddedProfile(const QByteArray &bytes, ImageFormat format)
{
    switch (format) {
    case ImageFormat::Png:
        return profileOfPng(bytes);
    case ImageFormat::Jpeg:
        return profileOfJpeg(bytes);
    case ImageFormat::Tiff:
        return profileOfTiff(bytes);
    case ImageFormat::WebP:
        return chunkOf(bytes, 12, "ICCP");
    default:
        return {};
    }
}

} // namespace suffuse
