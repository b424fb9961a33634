// The columns of a stroke chunk: numbers of one width, split into planes of bytes, each of which is stored as small as
// possible.
#pragma once

#include "model/formats/suffuse/suffuse_layout.h"

#include <functional>

namespace suffuse {

enum class PlaneCoding : std::uint8_t { Raw, Zstd, Constant, Zero };

class ColumnWriter {
public:
    /// Appends a column of little-endian numbers of 1, 4 or 8 bytes. If `dense`, the lowest plane is stored raw, so
    /// that the file has at least a byte for each element.
    template <typename Number>
    void put(const std::vector<Number> &values, bool dense = false)
    {
        QByteArray plane(qsizetype(values.size()), Qt::Uninitialized);
        for (std::size_t b = 0; b < sizeof(Number); ++b) {
            char *to = plane.data();
            for (const Number v : values)
                *to++ = char(v >> (8 * b) & 255);
            putPlane(plane, dense && b == 0);
        }
    }
    /// Appends bytes whose number the reader does not know. They are compressed only within `budget`, which shrinks by
    /// it.
    void putBlock(const QByteArray &bytes, std::uint64_t &budget);
    void putU32(std::uint32_t value) { appendU32(m_out, value); }

    const QByteArray &bytes() const { return m_out; }

private:
    void putPlane(const QByteArray &plane, bool raw);

    QByteArray m_out;
};

/// Reads what ColumnWriter has written. It never allocates more than the numbers of elements that it is asked for.
class ColumnReader {
public:
    explicit ColumnReader(QByteArrayView bytes) : m_cursor(bytes) {}

    bool ok() const { return m_ok && m_cursor.ok(); }
    template <typename Number>
    std::vector<Number> get(std::size_t count)
    {
        std::vector<Number> values(ok() ? count : 0);
        for (std::size_t b = 0; b < sizeof(Number) && getPlane(count); ++b) {
            if (m_isZero)
                continue;
            const char *from = m_plane.constData();
            for (Number &v : values)
                v = Number(v | Number(static_cast<unsigned char>(*from++)) << (8 * b));
        }
        return ok() ? values : std::vector<Number>();
    }
    /// Reads a block. For a compressed one, `mayUnpack(size)` is asked first.
    QByteArray getBlock(const std::function<bool(std::uint64_t)> &mayUnpack);
    std::uint32_t getU32() { return m_cursor.u32(); }
    bool atEnd() const { return ok() && m_cursor.left() == 0; }

private:
    bool getPlane(std::size_t count);

    ByteCursor m_cursor;
    QByteArray m_plane;
    bool m_isZero = false;
    bool m_ok = true;
};

} // namespace suffuse
