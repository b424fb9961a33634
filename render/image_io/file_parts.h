// Finds parts of image files without decoding them.
#pragma once

#include <QByteArray>

#include <algorithm>
#include <optional>

namespace suffuse {

/// Whole numbers of a file with the most or the least significant byte first; 0 beyond its end.
struct FileNumbers {
    const QByteArray &bytes;
    bool littleEndian = false;

    quint64 at(quint64 offset, int count) const
    {
        if (offset > quint64(bytes.size()) || quint64(bytes.size()) - offset < quint64(count))
            return 0;
        quint64 v = 0;
        for (int i = 0; i < count; ++i) {
            const quint64 place = offset + quint64(littleEndian ? count - 1 - i : i);
            v = v << 8 | static_cast<unsigned char>(bytes[qsizetype(place)]);
        }
        return v;
    }
};

/// A marker of a JPEG file, with what belongs to it.
struct JpegSegment {
    int marker = 0;
    qsizetype at = 0, length = 0; ///< from the first byte of the marker on; the length is less than 4 if it is broken
};

/// The next marker from `at` on, which is moved behind it; no value at the end of the file. Stray bytes, and markers
/// without a length, are skipped, as decoders do.
inline std::optional<JpegSegment> nextJpegSegment(const QByteArray &bytes, qsizetype &at)
{
    const FileNumbers numbers{bytes};
    while (at + 4 <= bytes.size()) {
        const int marker = static_cast<unsigned char>(bytes[at + 1]);
        if (bytes[at] != '\xFF' || marker == 0xFF) {
            ++at;
        } else if (marker <= 0x01 || (marker >= 0xD0 && marker <= 0xD7)) {
            at += 2;
        } else {
            const JpegSegment segment{marker, at, qsizetype(numbers.at(quint64(at) + 2, 2)) + 2};
            at += segment.length;
            return segment;
        }
    }
    return {};
}

/// The content of the first chunk of a type, from `at` on, in a file of chunks as PNG's (from 8) and WebP's (from 12)
/// are: each has a length of four bytes and a type, in either order. Empty if there is none.
inline QByteArray chunkOf(const QByteArray &bytes, qsizetype at, const QByteArray &type)
{
    const bool riff = bytes.startsWith("RIFF");
    const FileNumbers numbers{bytes, riff};
    while (at + 8 <= bytes.size()) {
        const qsizetype length = qsizetype(numbers.at(quint64(at) + (riff ? 4 : 0), 4));
        if (bytes.mid(at + (riff ? 0 : 4), 4) == type)
            return bytes.mid(at + 8, length);
        at += riff ? 8 + length + length % 2 : 12 + length; // In PNG a checksum follows.
    }
    return {};
}

/// The entries of the first directory of a TIFF file, of BigTIFF or of Exif data.
struct TiffDirectory {
    bool big = false;
    /// the place of the first entry, and the number of entries for which the file has room
    quint64 first = 0, count = 0;

    quint64 at(quint64 i) const { return first + i * (big ? 20 : 12); }
    quint64 valueAt(quint64 i) const { return at(i) + (big ? 12 : 8); }
};

/// The directory; no value if there is none in the file.
inline std::optional<TiffDirectory> tiffDirectory(const FileNumbers &numbers)
{
    const bool big = numbers.at(2, 2) == 43;
    const quint64 directory = big ? numbers.at(8, 8) : numbers.at(4, 4);
    const quint64 size = quint64(numbers.bytes.size()), head = big ? 8 : 2, entry = big ? 20 : 12;
    if (directory > size || size - directory < head)
        return {};
    return TiffDirectory{big, directory + head,
                         std::min(numbers.at(directory, int(head)), (size - directory - head) / entry)};
}

} // namespace suffuse
