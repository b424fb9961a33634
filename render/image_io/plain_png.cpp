#include "render/image_io/plain_png.h"

#include "model/formats/gzip.h"

#include <QtEndian>

#include <cstdlib>

namespace suffuse {

namespace {

constexpr qsizetype signatureSize = 8;
constexpr int headerSize = 13;

struct PlainHeader {
    int width = 0, height = 0;
    int channels = 0; ///< 0: it is none of the plain ones

    qsizetype rowBytes() const { return qsizetype(width) * channels; }
};

PlainHeader headerOf(const QByteArray &payload, int mostSide)
{
    if (payload.size() != headerSize)
        return {};
    const auto side = [&](int at) { return qFromBigEndian<quint32>(payload.constData() + at); };
    const quint32 width = side(0), height = side(4);
    const bool isPlain = payload[8] == 8 && payload[10] == 0 && payload[11] == 0 && payload[12] == 0;
    if (!isPlain || width < 1 || height < 1 || width > quint32(mostSide) || height > quint32(mostSide))
        return {};
    const int type = payload[9];
    return {int(width), int(height), type == 0 ? 1 : type == 2 ? 3 : type == 6 ? 4 : 0};
}

/// Which of the three bytes before it a byte is probably like (the PNG specification, 9.4).
int paeth(int left, int above, int corner)
{
    const int guess = left + above - corner;
    const int toLeft = std::abs(guess - left), toAbove = std::abs(guess - above), toCorner = std::abs(guess - corner);
    return toLeft <= toAbove && toLeft <= toCorner ? left : toAbove <= toCorner ? above : corner;
}

/// Turns the differences of a row into its bytes, in place. False for a filter that there is not.
bool undoFilter(int filter, quint8 *row, const quint8 *above, qsizetype size, int step)
{
    if (filter > 4)
        return false;
    for (qsizetype i = 0; i < size; ++i) {
        const int left = i >= step ? row[i - step] : 0, up = above ? above[i] : 0;
        const int corner = above && i >= step ? above[i - step] : 0;
        const int guesses[] = {0, left, up, (left + up) / 2, paeth(left, up, corner)};
        row[i] = quint8(row[i] + guesses[filter]);
    }
    return true;
}

/// The packed rows of the file, and its header. A chunk that changes what the numbers mean makes it no plain one.
struct PlainFile {
    PlainHeader header;
    QByteArray packed;
};

PlainFile plainFile(const QByteArray &bytes, int mostSide)
{
    PlainFile file;
    if (!bytes.startsWith("\x89PNG\r\n\x1a\n"))
        return file;
    constexpr qsizetype frame = 12; // length, type, checksum
    for (qsizetype at = signatureSize; bytes.size() - at >= frame;) {
        const auto length = qsizetype(qFromBigEndian<quint32>(bytes.constData() + at));
        if (length > bytes.size() - at - frame)
            return {};
        const QByteArray type = bytes.mid(at + 4, 4), payload = bytes.mid(at + 8, length);
        if (type == "IHDR")
            file.header = headerOf(payload, mostSide);
        else if (type == "IDAT")
            file.packed += payload;
        else if (type == "tRNS" || type == "iCCP" || type == "eXIf")
            return {};
        if (file.header.channels == 0)
            return {};
        at += length + frame;
    }
    return file;
}

} // namespace

std::optional<FloatPicture> readPlainPng(const QByteArray &bytes, int mostSide)
{
    const PlainFile file = plainFile(bytes, mostSide);
    const PlainHeader &header = file.header;
    const qsizetype row = header.rowBytes();
    if (header.channels == 0)
        return std::nullopt;
    Result<QByteArray> rows = unpackedZlib(file.packed, (row + 1) * header.height);
    if (!rows || rows->size() != (row + 1) * header.height)
        return std::nullopt;
    FloatPicture picture;
    picture.resize(header.width, header.height);
    float *out = picture.rgba.data();
    const quint8 *above = nullptr;
    for (int y = 0; y < header.height; ++y) {
        auto *line = reinterpret_cast<quint8 *>(rows->data()) + y * (row + 1);
        if (!undoFilter(line[0], line + 1, above, row, header.channels))
            return std::nullopt;
        above = line + 1;
        for (int x = 0; x < header.width; ++x, out += 4) {
            const quint8 *pixel = above + qsizetype(x) * header.channels;
            for (int c = 0; c < 3; ++c)
                out[c] = float(pixel[header.channels == 1 ? 0 : c]) / 255.0f;
            out[3] = header.channels == 4 ? float(pixel[3]) / 255.0f : 1.0f;
        }
    }
    return picture;
}

} // namespace suffuse
