// Makes one canonical sequence of bytes of values, for hashes.
#pragma once

#include "model/painting/fields.h"

#include <QCryptographicHash>

#include <bit>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

namespace suffuse {

/// Feeds values to SHA-256: fixed-width little-endian numbers, floats as bits, texts and lists with their length, and
/// all else field by field. Documents contain these hashes, so the sequence must never change.
class FieldHash {
public:
    template <typename T>
    requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    void put(T value)
    {
        if constexpr (std::is_same_v<T, float>)
            put(std::bit_cast<std::uint32_t>(value + 0.0f)); // −0 equals 0, so it hashes as 0
        else if constexpr (std::is_same_v<T, double>)
            put(std::bit_cast<std::uint64_t>(value + 0.0));
        else if constexpr (std::is_enum_v<T>)
            put(std::underlying_type_t<T>(value));
        else {
            auto bits = std::make_unsigned_t<std::conditional_t<std::is_same_v<T, bool>, char, T>>(value);
            for (std::size_t i = 0; i < sizeof bits; ++i, bits = decltype(bits)(std::uint64_t(bits) >> 8))
                m_buffer.append(char(bits & 0xff));
            if (m_buffer.size() > bufferSize)
                flush();
        }
    }
    void put(const QString &text) { put(text.toUtf8()); }
    void put(const QByteArray &bytes)
    {
        put(std::uint64_t(bytes.size()));
        flush();
        m_hash.addData(bytes);
    }
    void put(const EncodedImage &image)
    {
        put(bool(image));
        if (image)
            put(*image);
    }
    void put(Offset o) { put(o.x), put(o.y); }
    void put(Point p) { put(p.x), put(p.y); }
    void put(const Rect &r) { put(r.left), put(r.top), put(r.right), put(r.bottom); }
    template <typename T, std::size_t N>
    void put(const std::array<T, N> &values)
    {
        for (const T &value : values)
            put(value);
    }
    template <typename T>
    void put(const std::vector<T> &values)
    {
        put(std::uint64_t(values.size()));
        for (const T &value : values)
            put(value);
    }
    template <typename T>
    void put(const std::optional<T> &value)
    {
        put(value.has_value());
        if (value)
            put(*value);
    }
    void put(const SharedFill &fill) { put(*fill); } // It is put only where there is one.
    void put(const SharedText &text) { put(*text); } // So is this.
    void put(const SharedPicture &picture) { put(*picture); }
    void put(const Affine &map) { put(map.a), put(map.b), put(map.c), put(map.d), put(map.offset); }
    void put(const Cubic &cubic) { put(cubic.p); }
    /// Fields of later versions count only where they differ from their defaults, so that earlier paintings keep their
    /// hashes.
    template <HasFields T>
    void put(const T &value)
    {
        static const T usual;
        forEachField(value, [&](const auto &field, const auto &member) {
            if (field.traits.since > 1) {
                if (member == usual.*field.member)
                    return;
                put(QByteArray(field.name));
            }
            put(member);
        });
    }
    /// Images of pictures count by their SHA-256. Where a linked file lies does not count: documents name it as seen
    /// from where they lie.
    void put(const Picture &picture)
    {
        put(picture.isLinked());
        forEachField(picture, [&](const auto &field, const auto &member) {
            if (std::string_view(field.name) != "image" && std::string_view(field.name) != "link")
                put(member);
        });
    }
    /// The grain was added to papers last, so it comes last.
    void put(const Paper &paper)
    {
        forEachField(paper, [&](const auto &field, const auto &member) {
            if (std::string_view(field.name) != "grain")
                put(member);
        });
        put(paper.grain);
    }
    QByteArray result()
    {
        flush();
        return m_hash.result();
    }

private:
    static constexpr qsizetype bufferSize = 1 << 16;
    void flush()
    {
        m_hash.addData(m_buffer);
        m_buffer.resize(0);
    }

    QCryptographicHash m_hash{QCryptographicHash::Sha256};
    QByteArray m_buffer;
};

} // namespace suffuse
