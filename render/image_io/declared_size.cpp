#include "render/image_io/declared_size.h"

#include <QtEndian>

#include <algorithm>
#include <map>
#include <optional>

namespace suffuse {

namespace {

struct Size {
    qint64 width = 0;
    qint64 height = 0;
};

bool isTooLarge(Size s)
{
    return s.width > maxImageSide || s.height > maxImageSide || s.width * s.height > maxImagePixels;
}

std::uint32_t littleEndian(const QByteArray &bytes, qsizetype at, int count)
{
    std::uint32_t v = 0;
    for (int i = 0; i < count && at + i < bytes.size(); ++i)
        v |= std::uint32_t(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return v;
}

Size webpSize(const QByteArray &bytes)
{
    const QByteArray chunk = bytes.mid(12, 4);
    if (chunk == "VP8X")
        return {qint64(littleEndian(bytes, 24, 3)) + 1, qint64(littleEndian(bytes, 27, 3)) + 1};
    if (chunk == "VP8L") {
        const std::uint32_t v = littleEndian(bytes, 21, 4);
        return {(v & 0x3FFF) + 1, (v >> 14 & 0x3FFF) + 1};
    }
    if (chunk == "VP8 ")
        return {littleEndian(bytes, 26, 2) & 0x3FFF, littleEndian(bytes, 28, 2) & 0x3FFF};
    return {};
}

Size pngSize(const QByteArray &bytes)
{
    const auto bigEndian = [&bytes](qsizetype at) { return qint64(qbswap(littleEndian(bytes, at, 4))); };
    return {bigEndian(16), bigEndian(20)};
}

/// An attribute of an EXR header: name, type, size, value.
struct ExrAttribute {
    QByteArray name, type;
    qsizetype at = 0, size = 0; ///< place and size of the value
};

/// Reads an attribute and moves `at` behind it. No value at the end of a header. A size beyond the file is kept as it
/// is.
std::optional<ExrAttribute> nextAttribute(const QByteArray &bytes, qsizetype &at)
{
    const auto text = [&] {
        const qsizetype end = bytes.indexOf('\0', at);
        const QByteArray found = end < 0 ? QByteArray() : bytes.mid(at, end - at);
        at = end < 0 ? bytes.size() : end + 1;
        return found;
    };
    ExrAttribute attribute;
    attribute.name = text();
    if (attribute.name.isEmpty())
        return {};
    attribute.type = text();
    attribute.size = qint32(littleEndian(bytes, at, 4));
    attribute.at = at + 4;
    at = attribute.at + std::clamp<qsizetype>(attribute.size, 0, bytes.size());
    return attribute;
}

/// Whether OpenEXR reads a type up to an end of its own, whatever size is written. Then it finds the next attribute
/// elsewhere.
bool endsElsewhere(const QByteArray &bytes, const ExrAttribute &a)
{
    static const std::map<QByteArray, qsizetype> sizes = {
        {"box2i", 16}, {"box2f", 16}, {"chromaticities", 32}, {"compression", 1}, {"deepImageState", 1}, {"double", 8},
        {"envmap", 1}, {"float", 4},  {"int", 4},             {"keycode", 28},    {"lineOrder", 1},      {"m33d", 72},
        {"m33f", 36},  {"m44d", 128}, {"m44f", 64},           {"rational", 8},    {"tiledesc", 9},       {"timecode", 8},
        {"v2d", 16},   {"v2f", 8},    {"v2i", 8},             {"v3d", 24},        {"v3f", 12},           {"v3i", 12}};
    if (const auto known = sizes.find(a.type); known != sizes.end())
        return a.size != known->second;
    if (a.type != "chlist")
        return false;
    qsizetype at = a.at; // A name and 16 bytes follow for each channel, until an empty name.
    while (at < bytes.size() && bytes[at] != '\0') {
        const qsizetype end = bytes.indexOf('\0', at);
        at = end < 0 ? bytes.size() : end + 1 + 16;
    }
    return at + 1 != a.at + a.size;
}

bool asksTooMuch(const QByteArray &bytes, const ExrAttribute &a)
{
    const auto number = [&](int i) { return qint64(qint32(littleEndian(bytes, a.at + 4 * i, 4))); };
    if (a.size < 0 || a.at + a.size > bytes.size() || endsElsewhere(bytes, a))
        return true;
    if (a.name == "dataWindow" && a.size == 16)
        return isTooLarge({number(2) - number(0) + 1, number(3) - number(1) + 1});
    if (a.name == "chunkCount" && a.size == 4) // A table follows with eight bytes for each chunk.
        return number(0) > bytes.size() / 8;
    if (a.name == "preview" && a.size >= 8)
        return isTooLarge({number(0), number(1)}) || number(0) < 0 || 4 * number(0) * number(1) + 8 != a.size;
    return false;
}

/// Checks one header, or a header for each part until an empty one.
bool exrAsksTooMuch(const QByteArray &bytes)
{
    constexpr std::uint32_t hasParts = 1 << 12;
    qsizetype at = 8;
    for (bool isFirst = true;; isFirst = false) {
        bool isEmpty = true;
        while (const std::optional<ExrAttribute> attribute = nextAttribute(bytes, at)) {
            isEmpty = false;
            if (asksTooMuch(bytes, *attribute))
                return true;
        }
        if (isEmpty || (isFirst && !(littleEndian(bytes, 4, 4) & hasParts)))
            return false;
    }
}

} // namespace

bool declaresTooMuch(const QByteArray &bytes, ImageFormat format)
{
    return (format == ImageFormat::WebP && isTooLarge(webpSize(bytes))) ||
           (format == ImageFormat::Png && isTooLarge(pngSize(bytes))) ||
           (format == ImageFormat::Exr && exrAsksTooMuch(bytes));
}

} // namespace suffuse
