#include "model/formats/suffuse/suffuse_columns.h"

#include <zstd.h>

#include <memory>

namespace suffuse {

namespace {

/// Level 9 would take twice the time for 2 % less.
constexpr int zstdLevel = 5;

/// A compressor, made once for each thread: planes are short, and making one takes as long as a plane.
ZSTD_CCtx *compressor()
{
    thread_local const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(), &ZSTD_freeCCtx);
    return context.get();
}

ZSTD_DCtx *decompressor()
{
    thread_local const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(), &ZSTD_freeDCtx);
    return context.get();
}

QByteArray compressed(const QByteArray &bytes)
{
    QByteArray out(qsizetype(ZSTD_compressBound(std::size_t(bytes.size()))), Qt::Uninitialized);
    const std::size_t size = ZSTD_compressCCtx(compressor(), out.data(), std::size_t(out.size()), bytes.constData(),
                                               std::size_t(bytes.size()), zstdLevel);
    if (ZSTD_isError(size))
        return bytes; // Compressing does not make them smaller, so the caller stores the bytes as they are.
    out.truncate(qsizetype(size));
    return out;
}

bool decompress(QByteArrayView from, QByteArray &to)
{
    const std::size_t size =
        ZSTD_decompressDCtx(decompressor(), to.data(), std::size_t(to.size()), from.data(), std::size_t(from.size()));
    return !ZSTD_isError(size) && size == std::size_t(to.size());
}

void appendCoded(QByteArray &out, const QByteArray &bytes, bool raw)
{
    const QByteArray packed = raw ? bytes : compressed(bytes);
    if (packed.size() < bytes.size()) {
        out.append(char(PlaneCoding::Zstd));
        appendVarint(out, std::uint64_t(packed.size()));
        out.append(packed);
    } else {
        out.append(char(PlaneCoding::Raw));
        out.append(bytes);
    }
}

} // namespace

void ColumnWriter::putPlane(const QByteArray &plane, bool raw)
{
    const bool same = !plane.isEmpty() && plane.count(plane.front()) == plane.size();
    if (plane.isEmpty() || (same && !raw && plane.front() == 0)) {
        m_out.append(char(PlaneCoding::Zero));
    } else if (same && !raw) {
        m_out.append(char(PlaneCoding::Constant)).append(plane.front());
    } else {
        appendCoded(m_out, plane, raw);
    }
}

void ColumnWriter::putBlock(const QByteArray &bytes, std::uint64_t &budget)
{
    const auto size = std::uint64_t(bytes.size());
    const bool raw = size == 0 || size > budget;
    appendVarint(m_out, size);
    appendCoded(m_out, bytes, raw);
    budget -= raw ? 0 : size;
}

bool ColumnReader::getPlane(std::size_t count)
{
    if (!ok())
        return false;
    const auto coding = PlaneCoding(m_cursor.u8());
    m_isZero = coding == PlaneCoding::Zero;
    if (m_isZero)
        return ok();
    if (coding == PlaneCoding::Raw) {
        const QByteArrayView raw = m_cursor.take(count);
        m_plane = raw.toByteArray();
    } else if (coding == PlaneCoding::Zstd) {
        const QByteArrayView packed = m_cursor.take(m_cursor.varint());
        m_plane.resize(qsizetype(count));
        m_ok = m_cursor.ok() && decompress(packed, m_plane);
    } else if (coding == PlaneCoding::Constant) {
        m_plane.fill(char(m_cursor.u8()), qsizetype(count));
    } else {
        m_ok = false;
    }
    return ok();
}

QByteArray ColumnReader::getBlock(const std::function<bool(std::uint64_t)> &mayUnpack)
{
    const std::uint64_t size = m_cursor.varint();
    const auto coding = PlaneCoding(m_cursor.u8());
    if (ok() && coding == PlaneCoding::Raw)
        return m_cursor.take(size).toByteArray();
    m_ok = m_ok && coding == PlaneCoding::Zstd && mayUnpack(size);
    const QByteArrayView packed = ok() ? m_cursor.take(m_cursor.varint()) : QByteArrayView();
    if (!ok())
        return {};
    QByteArray bytes(qsizetype(size), Qt::Uninitialized);
    m_ok = decompress(packed, bytes);
    return m_ok ? bytes : QByteArray();
}

} // namespace suffuse
