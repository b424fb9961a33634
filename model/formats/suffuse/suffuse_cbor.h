// Takes values out of the CBOR maps of a .suffuse file.
#pragma once

#include "model/painting/painting.h"

#include <QCborArray>
#include <QCborMap>
#include <QCborValue>

namespace suffuse {

/// The integer of a value, or `otherwise` for any other type. Qt's own function converts a double of any size, for
/// which C++ leaves the result undefined.
inline qint64 integerIn(const QCborValue &value, qint64 otherwise = 0)
{
    return value.isInteger() ? value.toInteger() : otherwise;
}

/// Takes values out of a map, and remembers whether all had the right type. Values that are absent leave the default.
class MapReader {
public:
    MapReader(const QCborValue &map, bool &ok) : m_map(map.toMap()), m_ok(ok) { m_ok = m_ok && map.isMap(); }

    void read(const char *name, double &value) const
    {
        if (const QCborValue v = take(name); good(v, v.isDouble() || v.isInteger()))
            value = v.toDouble();
    }
    void read(const char *name, float &value) const
    {
        double wide = double(value);
        read(name, wide);
        value = float(wide);
    }
    void read(const char *name, std::uint64_t &value) const
    {
        if (const QCborValue v = take(name); good(v, v.isInteger()))
            value = std::uint64_t(v.toInteger());
    }
    void read(const char *name, bool &value) const
    {
        if (const QCborValue v = take(name); good(v, v.isBool()))
            value = v.toBool();
    }
    void read(const char *name, QString &value) const
    {
        if (const QCborValue v = take(name); good(v, v.isString()))
            value = v.toString();
    }
    void read(const char *name, Colour &value) const
    {
        const QCborValue v = take(name);
        const QCborArray list = v.toArray();
        if (good(v, list.size() == 4))
            value = {float(list.at(0).toDouble()), float(list.at(1).toDouble()), float(list.at(2).toDouble()),
                     float(list.at(3).toDouble())};
    }
    /// Reads an image by its number among `images`.
    void read(const char *name, EncodedImage &value, const std::vector<EncodedImage> &images) const
    {
        const QCborValue v = take(name);
        if (good(v, v.isInteger() && v.toInteger() >= 0 && std::uint64_t(v.toInteger()) < images.size()))
            value = images[std::size_t(v.toInteger())];
    }
    QCborValue take(const char *name) const { return m_map.value(QLatin1String(name)); }

private:
    bool good(const QCborValue &value, bool rightType) const
    {
        m_ok = m_ok && (value.isUndefined() || rightType);
        return !value.isUndefined() && rightType;
    }

    QCborMap m_map;
    bool &m_ok;
};

} // namespace suffuse
