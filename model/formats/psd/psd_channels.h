// The pixels of layers in Photoshop files.
#pragma once

#include "model/formats/psd/planar_tiff.h"

#include <optional>

namespace suffuse::psd {

/// Big-endian numbers and pieces of a file, one after another. Beyond the end all are 0 and empty, and `ok` is false.
class Cursor {
public:
    explicit Cursor(const QByteArray &bytes, qsizetype at = 0) : m_bytes(bytes), m_at(at) {}

    bool ok() const { return m_ok; }
    qsizetype left() const { return m_bytes.size() - m_at; }
    quint8 u8() { return number<quint8>(); }
    quint16 u16() { return number<quint16>(); }
    qint16 i16() { return qint16(number<quint16>()); }
    quint32 u32() { return number<quint32>(); }
    qint32 i32() { return qint32(number<quint32>()); }
    QByteArray take(qsizetype size);
    void skip(qsizetype size) { take(size); }

private:
    template <class T>
    T number();

    QByteArray m_bytes;
    qsizetype m_at;
    bool m_ok = true;
};

/// How the pixels of a channel are stored.
enum class Packing : quint16 { Raw = 0, PackBits = 1, Zip = 2, ZipOfDifferences = 3 };

/// A channel's size.
struct ChannelShape {
    int width = 0, height = 0;
    int bits = 8; ///< 8 or 16

    qsizetype rowBytes() const { return qsizetype(width) * (bits / 8); }
};

/// The rows of a channel in PackBits, from what a layer has of it: the packing, and what that makes of the rows. No
/// value if they are damaged.
std::optional<PackedRows> packedRows(const QByteArray &stored, const ChannelShape &shape);
/// The same of rows whose packed sizes stand elsewhere, as those of the merged picture.
std::optional<PackedRows> packedRows(const QByteArray &counts, const QByteArray &rows, const ChannelShape &shape);

/// Rows in PackBits as they are. They must be whole.
QByteArray unpackedRows(const PackedRows &packed, const ChannelShape &shape);
/// Packs rows.
PackedRows packRows(const QByteArray &rows, const ChannelShape &shape);

} // namespace suffuse::psd
