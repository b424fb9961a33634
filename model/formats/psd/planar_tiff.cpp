#include "model/formats/psd/planar_tiff.h"

#include <QDataStream>

namespace suffuse {

namespace {

/// The directory of the file, whose tags stand in the order of their numbers.
class Directory {
public:
    explicit Directory(qint64 at) : m_at(at) {}

    void addShorts(quint16 tag, const std::vector<quint16> &values) { add(tag, 3, values); }
    void addLongs(quint16 tag, const std::vector<quint32> &values) { add(tag, 4, values); }
    void addBytes(quint16 tag, const QByteArray &bytes)
    {
        constexpr quint16 undefined = 7;
        m_entries.push_back({tag, undefined, quint32(bytes.size()), bytes});
    }
    /// The bytes of the directory, which begins where it was told.
    QByteArray bytes() const
    {
        constexpr qint64 entryBytes = 12;
        const qint64 values = m_at + 2 + entryBytes * qint64(m_entries.size()) + 4;
        QByteArray out, beyond;
        QDataStream stream(&out, QIODevice::WriteOnly);
        stream << quint16(m_entries.size());
        for (const Entry &entry : m_entries) {
            stream << entry.tag << entry.type << entry.count;
            if (entry.content.size() <= 4) {
                const QByteArray inPlace = entry.content.leftJustified(4, '\0');
                stream.writeRawData(inPlace.constData(), 4);
            } else {
                stream << quint32(values + beyond.size());
                beyond += entry.content + QByteArray(entry.content.size() % 2, '\0');
            }
        }
        stream << quint32(0); // no other directory
        return out + beyond;
    }

private:
    struct Entry {
        quint16 tag, type;
        quint32 count;
        QByteArray content;
    };

    template <class T>
    void add(quint16 tag, quint16 type, const std::vector<T> &values)
    {
        Entry entry{tag, type, quint32(values.size()), {}};
        QDataStream stream(&entry.content, QIODevice::WriteOnly);
        for (const T value : values)
            stream << value;
        m_entries.push_back(std::move(entry));
    }

    qint64 m_at;
    std::vector<Entry> m_entries;
};

} // namespace

QByteArray planarTiff(const PlanarImage &image)
{
    QByteArray out("MM\0\x2a", 4);
    constexpr qsizetype head = 8;
    qsizetype end = head;
    std::vector<quint32> places, sizes; // A strip is a row: readers take rows of all channels at a time.
    for (const PackedRows &channel : image.channels)
        for (const std::uint32_t size : channel.sizes) {
            places.push_back(quint32(end)), sizes.push_back(size);
            end += qsizetype(size);
        }
    const qsizetype directoryAt = end + end % 2;
    QDataStream stream(&out, QIODevice::WriteOnly | QIODevice::Append);
    stream << quint32(directoryAt);
    for (const PackedRows &channel : image.channels)
        out += channel.bytes;
    out += QByteArray(directoryAt - end, '\0');
    const std::size_t count = image.channels.size();
    const bool grey = count <= 2, alpha = count % 2 == 0;
    Directory directory(directoryAt);
    directory.addLongs(256, {quint32(image.width)});
    directory.addLongs(257, {quint32(image.height)});
    directory.addShorts(258, std::vector<quint16>(count, quint16(image.bits)));
    directory.addShorts(259, {32773});                 // PackBits
    directory.addShorts(262, {quint16(grey ? 1 : 2)}); // black is 0, or RGB
    directory.addLongs(273, places);
    directory.addShorts(277, {quint16(count)});
    directory.addLongs(278, {1});
    directory.addLongs(279, sizes);
    directory.addShorts(284, {2}); // one channel after another
    if (alpha)
        directory.addShorts(338, {2}); // straight
    if (!image.profile.isEmpty())
        directory.addBytes(34675, image.profile);
    return out + directory.bytes();
}

} // namespace suffuse
