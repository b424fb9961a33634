#include "model/formats/psd/psd_channels.h"

#include "model/formats/psd/pack_bits.h"

#include <QtEndian>

namespace suffuse::psd {

namespace {

const std::uint8_t *bytesOf(const QByteArray &array, qsizetype at = 0)
{
    return reinterpret_cast<const std::uint8_t *>(array.constData()) + at;
}

/// Rows that hold differences to the pixel on the left become what they stand for.
void addUp(QByteArray &rows, const ChannelShape &shape)
{
    auto *row = reinterpret_cast<std::uint8_t *>(rows.data());
    for (int y = 0; y < shape.height; ++y, row += shape.rowBytes())
        for (int x = 1; x < shape.width; ++x)
            if (shape.bits == 8) {
                row[x] = std::uint8_t(row[x] + row[x - 1]);
            } else {
                std::uint8_t *pixel = row + 2 * x;
                qToBigEndian(quint16(qFromBigEndian<quint16>(pixel) + qFromBigEndian<quint16>(pixel - 2)), pixel);
            }
}

} // namespace

QByteArray Cursor::take(qsizetype size)
{
    m_ok = m_ok && size >= 0 && size <= left();
    if (!m_ok)
        return {};
    const QByteArray piece = m_bytes.mid(m_at, size);
    m_at += size;
    return piece;
}

template <class T>
T Cursor::number()
{
    m_ok = m_ok && qsizetype(sizeof(T)) <= left();
    if (!m_ok)
        return 0;
    const T value = qFromBigEndian<T>(m_bytes.constData() + m_at);
    m_at += qsizetype(sizeof(T));
    return value;
}
template quint8 Cursor::number();
template quint16 Cursor::number();
template quint32 Cursor::number();

std::optional<PackedRows> packedRows(const QByteArray &counts, const QByteArray &rows, const ChannelShape &shape)
{
    Cursor sizes(counts);
    QByteArray row(shape.rowBytes(), Qt::Uninitialized);
    qsizetype at = 0;
    PackedRows packed;
    for (int y = 0; y < shape.height; ++y) {
        const qsizetype size = sizes.u16();
        packed.sizes.push_back(std::uint32_t(size));
        if (size > rows.size() - at ||
            !unpackBits(bytesOf(rows, at), std::size_t(size), reinterpret_cast<std::uint8_t *>(row.data()),
                        std::size_t(row.size())))
            return {};
        at += size;
    }
    packed.bytes = rows.left(at);
    return sizes.ok() ? std::optional(std::move(packed)) : std::nullopt;
}

std::optional<PackedRows> packedRows(const QByteArray &stored, const ChannelShape &shape)
{
    Cursor cursor(stored);
    const auto packing = Packing(cursor.u16());
    const qsizetype bytes = shape.rowBytes() * shape.height;
    if (packing == Packing::PackBits) {
        const QByteArray counts = cursor.take(2 * qsizetype(shape.height));
        return cursor.ok() ? packedRows(counts, cursor.take(cursor.left()), shape) : std::nullopt;
    }
    QByteArray rows = cursor.take(packing == Packing::Raw ? bytes : cursor.left());
    if (packing == Packing::Zip || packing == Packing::ZipOfDifferences) {
        QByteArray head(4, '\0'); // the size that is expected, as qUncompress wants it
        qToBigEndian(quint32(bytes), head.data());
        rows = qUncompress(head + rows);
    } else if (packing != Packing::Raw) {
        return {};
    }
    if (!cursor.ok() || rows.size() != bytes)
        return {};
    if (packing == Packing::ZipOfDifferences)
        addUp(rows, shape);
    return packRows(rows, shape);
}

QByteArray unpackedRows(const PackedRows &packed, const ChannelShape &shape)
{
    // Rows begin where runs do, so all of them can be unpacked as one.
    QByteArray rows(shape.rowBytes() * shape.height, '\0');
    unpackBits(bytesOf(packed.bytes), std::size_t(packed.bytes.size()), reinterpret_cast<std::uint8_t *>(rows.data()),
               std::size_t(rows.size()));
    return rows;
}

PackedRows packRows(const QByteArray &rows, const ChannelShape &shape)
{
    PackedRows packed;
    for (int y = 0; y < shape.height; ++y) {
        const qsizetype before = packed.bytes.size();
        packBits(bytesOf(rows, y * shape.rowBytes()), std::size_t(shape.rowBytes()), packed.bytes);
        packed.sizes.push_back(std::uint32_t(packed.bytes.size() - before));
    }
    return packed;
}

} // namespace suffuse::psd
