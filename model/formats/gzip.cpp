#include "model/formats/gzip.h"

#include "model/formats/messages.h"

#include <zlib.h>

namespace suffuse {

namespace {

constexpr int gzipWindow = MAX_WBITS + 16; // with gzip's header
constexpr qsizetype gzipStep = 1 << 18;

Result<QByteArray> unpacked(const QByteArray &bytes, int window, qint64 most, bool begins)
{
    z_stream stream{};
    if (inflateInit2(&stream, window) != Z_OK)
        return Error{FileMessages::tr("there is not enough memory")};
    QByteArray out;
    stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(bytes.constData()));
    stream.avail_in = uInt(std::min<qsizetype>(bytes.size(), std::numeric_limits<int>::max()));
    int code = Z_OK;
    while (code == Z_OK && out.size() < most) {
        const qsizetype had = out.size(), step = std::min<qsizetype>(gzipStep, most - had);
        out.resize(had + step);
        stream.next_out = reinterpret_cast<Bytef *>(out.data() + had);
        stream.avail_out = uInt(step);
        code = inflate(&stream, Z_NO_FLUSH);
        out.resize(had + step - qsizetype(stream.avail_out));
        if (code == Z_OK && stream.avail_in == 0 && stream.avail_out > 0)
            break; // It ends too early.
    }
    inflateEnd(&stream);
    if (code == Z_STREAM_END || begins)
        return out;
    if (code == Z_OK && out.size() >= most)
        return Error{FileMessages::tr("is too large once it is unpacked")};
    return Error{FileMessages::tr("is damaged: it cannot be unpacked")};
}

} // namespace

bool isGzip(const QByteArray &bytes)
{
    return bytes.startsWith("\x1f\x8b");
}

Result<QByteArray> unpackedGzip(const QByteArray &bytes, qint64 most, bool begins)
{
    return unpacked(bytes, gzipWindow, most, begins);
}

Result<QByteArray> unpackedZlib(const QByteArray &bytes, qint64 most)
{
    return unpacked(bytes, MAX_WBITS, most, false);
}

QByteArray packedGzip(const QByteArray &bytes, const std::atomic<bool> *cancel)
{
    z_stream stream{};
    if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzipWindow, 8, Z_DEFAULT_STRATEGY) != Z_OK)
        return {};
    QByteArray out;
    QByteArray room(gzipStep, Qt::Uninitialized);
    for (qsizetype at = 0, code = Z_OK; code != Z_STREAM_END;) {
        if (cancel && cancel->load(std::memory_order_relaxed)) {
            out.clear();
            break;
        }
        const qsizetype step = std::min(gzipStep, bytes.size() - at);
        stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(bytes.constData() + at));
        stream.avail_in = uInt(step);
        at += step;
        do {
            stream.next_out = reinterpret_cast<Bytef *>(room.data());
            stream.avail_out = uInt(room.size());
            code = deflate(&stream, at == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
            out.append(room.constData(), room.size() - qsizetype(stream.avail_out));
        } while (stream.avail_out == 0);
    }
    deflateEnd(&stream);
    return out;
}

} // namespace suffuse
