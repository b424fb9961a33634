#include "render/tiles/big_tiff.h"

#include "render/image_io/file_replacement.h"

#include <QtEndian>

#include <cerrno>
#include <cstdio>

#include <unistd.h>

namespace suffuse {

namespace {

enum Type : quint16 { Ascii = 2, Short = 3, Long = 4, Undefined = 7, Long8 = 16 };

template <typename Number>
void put(QByteArray &out, Number value)
{
    char bytes[sizeof value];
    qToLittleEndian(value, bytes);
    out.append(bytes, sizeof value);
}

/// Makes a directory, whose entries come in ascending order, and values that have no room in them behind it.
class Directory {
public:
    Directory(qint64 at, int entries) : m_behind(at + 8 + 20 * entries + 8), m_count(entries) {}

    void number(quint16 tag, Type type, quint64 value) { entry(tag, type, 1, value); }
    void numbers(quint16 tag, quint16 value, int count)
    {
        quint64 packed = 0;
        for (int i = 0; i < count; ++i)
            packed |= quint64(value) << (16 * i);
        entry(tag, Short, quint64(count), packed);
    }
    void text(quint16 tag, const QByteArray &value)
    {
        entry(tag, Ascii, quint64(value.size()) + 1, quint64(m_behind + m_values.size()));
        m_values += value + '\0';
    }
    void entry(quint16 tag, Type type, quint64 count, quint64 value)
    {
        put(m_entries, tag);
        put(m_entries, quint16(type));
        put(m_entries, count);
        put(m_entries, value);
    }
    /// `last`: no directory follows.
    QByteArray bytes(bool last)
    {
        m_values.append((8 - m_values.size() % 8) % 8, '\0');
        QByteArray out;
        put(out, quint64(m_count));
        out += m_entries;
        put(out, last ? quint64(0) : quint64(m_behind + m_values.size()));
        return out + m_values;
    }

private:
    const qint64 m_behind;
    const int m_count;
    QByteArray m_entries, m_values;
};

} // namespace

BigTiff::BigTiff(const TiledPicture &picture, qint64 end, Write write)
    : m_picture(picture), m_tables((end + 7) / 8 * 8), m_write(std::move(write))
{}

bool BigTiff::enter(const TileSheet &sheet, const SheetRecord &record)
{
    const auto at = std::size_t(sheet.level);
    const TileLevel &level = m_picture.plan.levels()[at];
    if (level.tiles() == 1)
        m_single[at] = {record.offset, record.size()};
    qint64 offset = record.offset;
    for (int row = 0, tile = 0; row < sheet.rows; ++row) {
        QByteArray offsets, sizes;
        for (int column = 0; column < sheet.columns; ++column, ++tile) {
            put(offsets, quint64(offset));
            put(sizes, quint64(record.sizes[std::size_t(tile)]));
            offset += record.sizes[std::size_t(tile)];
        }
        const qint64 first = tableOf(at) + 8 * (qint64(sheet.row + row) * level.columns + sheet.column);
        if (!m_write(first, offsets.constData(), std::size_t(offsets.size())) ||
            !m_write(first + 8 * level.tiles(), sizes.constData(), std::size_t(sizes.size())))
            return false;
    }
    return true;
}

QByteArray BigTiff::directoryOf(std::size_t number, qint64 at, qint64 profileAt, qint64 profileSize, bool isLast) const
{
    constexpr int reduced = 1, deflate = 8, rgb = 2, topLeft = 1, contiguous = 1, horizontal = 2, straight = 2;
    const TileLevel &level = m_picture.plan.levels()[number];
    const bool alpha = m_picture.encoding.image.alpha;
    const int channels = alpha ? 4 : 3;
    const auto single = m_single.find(number);
    const auto table = [&](qint64 tableAt, qint64 value) { return single == m_single.end() ? tableAt : value; };
    const auto tiles = quint64(level.tiles());
    const quint64 offsets = quint64(table(tableOf(number), single == m_single.end() ? 0 : single->second.first));
    const quint64 sizes =
        quint64(table(tableOf(number) + 8 * level.tiles(), single == m_single.end() ? 0 : single->second.second));
    Directory out(at, alpha ? 17 : 16);
    out.number(254, Long, number + 1 == m_picture.plan.levels().size() ? 0 : reduced);
    out.number(256, Long, quint64(level.view.width));
    out.number(257, Long, quint64(level.view.height));
    out.numbers(258, quint16(m_picture.encoding.bits()), channels);
    out.number(259, Short, deflate);
    out.number(262, Short, rgb);
    out.number(274, Short, topLeft);
    out.number(277, Short, quint64(channels));
    out.number(284, Short, contiguous);
    out.text(305, "Suffuse " SUFFUSE_VERSION);
    out.number(317, Short, horizontal);
    out.number(322, Long, quint64(m_picture.plan.options().tile));
    out.number(323, Long, quint64(m_picture.plan.options().tile));
    out.entry(324, Long8, tiles, offsets);
    out.entry(325, Long8, tiles, sizes);
    if (alpha)
        out.numbers(338, straight, 1);
    out.entry(34675, Undefined, quint64(profileSize), quint64(profileAt));
    return out.bytes(isLast);
}

Result<void> frameBigTiff(const TiledPicture &picture, const QString &path, qint64 end,
                          const std::vector<SheetRecord> &records)
{
    const Result<QByteArray> profile = srgbIccProfile();
    if (!profile)
        return Error{profile.error()};
    QFile file(path);
    const auto failed = [&] { return Error{FileReplacement::reason(path, errno)}; };
    if (!file.open(QIODevice::ReadWrite | QIODevice::Unbuffered))
        return failed();
    BigTiff tiff(picture, end, [&](qint64 offset, const void *bytes, std::size_t size) {
        for (std::size_t done = 0; done < size;) {
            const ssize_t n =
                ::pwrite(file.handle(), static_cast<const char *>(bytes) + done, size - done, offset + qint64(done));
            if (n > 0)
                done += std::size_t(n);
            else if (n == 0 || errno != EINTR)
                return false;
        }
        return true;
    });
    for (const SheetRecord &record : records)
        if (!tiff.enter(picture.plan.sheet(record.sheet), record))
            return failed();
    if (!tiff.finish(*profile) || ::fsync(file.handle()) != 0)
        return failed();
    file.close();
    if (::rename(QFile::encodeName(path).constData(), QFile::encodeName(picture.path).constData()) != 0)
        return failed();
    return {};
}

bool BigTiff::finish(const QByteArray &profile)
{
    const qint64 profileAt = m_tables + 16 * m_picture.plan.tiles();
    const qint64 first = (profileAt + profile.size() + 7) / 8 * 8;
    QByteArray directories;
    for (std::size_t level = m_picture.plan.levels().size(); level-- > 0;) // the whole picture first
        directories += directoryOf(level, first + directories.size(), profileAt, profile.size(), level == 0);
    QByteArray head("II", 2);
    put(head, quint16(43));
    put(head, quint16(8)); // the bytes of an offset
    put(head, quint16(0));
    put(head, quint64(first));
    return m_write(profileAt, profile.constData(), std::size_t(profile.size())) &&
           m_write(first, directories.constData(), std::size_t(directories.size())) &&
           m_write(0, head.constData(), std::size_t(head.size()));
}

} // namespace suffuse
