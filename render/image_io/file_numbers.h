#pragma once

#include <QByteArray>

namespace suffuse {

/// Whole numbers of a file, most or least significant byte first; 0 beyond the end.
struct FileNumbers {
    const QByteArray &bytes;
    bool littleEndian = false;

    quint64 at(quint64 offset, int count) const
    {
        if (offset > quint64(bytes.size()) || quint64(bytes.size()) - offset < quint64(count))
            return 0;
        quint64 v = 0;
        for (int i = 0; i < count; ++i) {
            const quint64 place = offset + quint64(littleEndian ? count - 1 - i : i);
            v = v << 8 | static_cast<unsigned char>(bytes[qsizetype(place)]);
        }
        return v;
    }
};

} // namespace suffuse
