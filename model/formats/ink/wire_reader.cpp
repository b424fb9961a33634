#include "model/formats/ink/wire_reader.h"

#include <QJsonArray>
#include <QtEndian>

#include <cmath>
#include <vector>

namespace suffuse {

namespace {

constexpr int deepest = 16;
constexpr int costOfMessage = 16; ///< values that take as much memory
constexpr qsizetype longestText = 4096;

/// How a value is packed, by the lowest bits of what stands before it.
enum WirePacking { Varint = 0, Eight = 1, Bytes = 2, Four = 5 };

class WireReader {
public:
    WireReader(QByteArrayView bytes, qint64 &budget, int depth) : m_bytes(bytes), m_budget(budget), m_depth(depth) {}

    std::optional<QJsonObject> read(std::span<const WireField> fields)
    {
        QJsonObject object;
        std::vector<QJsonArray> lists(fields.size());
        while (m_isWhole && m_at < m_bytes.size()) {
            const quint64 tag = varint();
            const auto packing = int(tag & 7);
            std::size_t k = 0;
            while (k < fields.size() && quint64(fields[k].number) != tag >> 3)
                ++k;
            if (k == fields.size()) {
                skip(packing);
                continue;
            }
            const WireField &field = fields[k];
            const bool isNumber = field.kind >= WireKind::Whole && field.kind <= WireKind::Double;
            if (field.isList && isNumber && packing == Bytes) {
                const QByteArrayView packed = block();
                WireReader inside(packed, m_budget, m_depth);
                while (m_isWhole && inside.m_at < packed.size()) {
                    lists[k].append(inside.number(field.kind, packingOf(field.kind)));
                    m_isWhole = inside.m_isWhole;
                }
                continue;
            }
            const QJsonValue value = isNumber ? QJsonValue(number(field.kind, packing)) : valueOf(field, packing);
            if (field.isList)
                lists[k].append(value);
            else
                object.insert(QLatin1String(field.name), value);
        }
        if (!m_isWhole)
            return std::nullopt;
        for (std::size_t k = 0; k < fields.size(); ++k)
            if (!lists[k].isEmpty())
                object.insert(QLatin1String(fields[k].name), lists[k]);
        return object;
    }

private:
    static int packingOf(WireKind kind)
    {
        return kind == WireKind::Float ? Four : kind == WireKind::Double ? Eight : Varint;
    }

    /// Nothing that follows damage is read.
    void fail()
    {
        m_isWhole = false;
        m_at = m_bytes.size();
    }

    void spend(int values)
    {
        m_budget -= values;
        if (m_budget < 0)
            fail();
    }

    quint64 varint()
    {
        quint64 value = 0;
        for (int shift = 0; shift < 64; shift += 7) {
            if (m_at >= m_bytes.size())
                break;
            const auto byte = static_cast<unsigned char>(m_bytes[m_at++]);
            value |= quint64(byte & 127) << shift;
            if (byte < 128)
                return value;
        }
        fail();
        return 0;
    }

    QByteArrayView take(qsizetype size)
    {
        if (size > m_bytes.size() - m_at) {
            fail();
            return {};
        }
        const QByteArrayView taken = m_bytes.sliced(m_at, size);
        m_at += size;
        return taken;
    }

    QByteArrayView block()
    {
        const quint64 size = varint();
        return take(qsizetype(std::min<quint64>(size, quint64(m_bytes.size()) + 1)));
    }

    void skip(int packing)
    {
        if (packing == Varint)
            varint();
        else if (packing == Bytes)
            block();
        else if (packing == Four || packing == Eight)
            take(packing == Four ? 4 : 8);
        else
            fail();
    }

    double number(WireKind kind, int packing)
    {
        spend(1);
        if (packing != packingOf(kind)) {
            fail();
            return 0;
        }
        if (packing == Varint) {
            const quint64 value = varint();
            return kind == WireKind::Signed ? double(qint64(value >> 1) ^ -qint64(value & 1)) : double(value);
        }
        const QByteArrayView bytes = take(packing == Four ? 4 : 8);
        if (bytes.isEmpty())
            return 0;
        const double value =
            packing == Four ? double(qFromLittleEndian<float>(bytes.data())) : qFromLittleEndian<double>(bytes.data());
        if (!std::isfinite(value)) // JSON has none of them.
            fail();
        return m_isWhole ? value : 0;
    }

    QJsonValue valueOf(const WireField &field, int packing)
    {
        if (packing != Bytes) {
            fail();
            return {};
        }
        const QByteArrayView bytes = block();
        spend(costOfMessage);
        if (field.kind == WireKind::Message) {
            if (m_depth >= deepest || !m_isWhole) {
                fail();
                return {};
            }
            const auto message = WireReader(bytes, m_budget, m_depth + 1).read(field.message);
            if (!message)
                fail();
            return message.value_or(QJsonObject());
        }
        const QByteArrayView text = bytes.first(std::min(bytes.size(), longestText));
        return field.kind == WireKind::Text ? QJsonValue(QString::fromUtf8(text))
                                            : QJsonValue(QString::fromLatin1(text.toByteArray().toHex()));
    }

    QByteArrayView m_bytes;
    qint64 &m_budget;
    int m_depth;
    qsizetype m_at = 0;
    bool m_isWhole = true;
};

} // namespace

std::optional<QJsonObject> readWire(QByteArrayView bytes, std::span<const WireField> fields, qint64 &budget)
{
    return WireReader(bytes, budget, 0).read(fields);
}

} // namespace suffuse
