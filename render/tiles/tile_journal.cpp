#include "render/tiles/tile_journal.h"

#include "render/image_io/file_replacement.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QtEndian>

#include <cerrno>

#include <sys/file.h>

namespace suffuse {

namespace {

/// Each line ends with a hash of what stands before.
QByteArray signedLine(const QByteArray &text)
{
    return text + " =" + QByteArray::number(tileHash(text), 16) + '\n';
}

/// What stands before the hash; empty if the line is not whole.
QByteArray textOf(const QByteArray &line)
{
    const qsizetype at = line.lastIndexOf(" =");
    const QByteArray text = line.left(std::max<qsizetype>(at, 0));
    return at > 0 && line.mid(at + 2) == QByteArray::number(tileHash(text), 16) ? text : QByteArray();
}

std::optional<SheetRecord> recordOf(const QByteArray &text)
{
    const QList<QByteArray> words = text.split(' ');
    if (words.size() < 3 || words[0] != "sheet")
        return {};
    SheetRecord record;
    record.sheet = words[1].toLongLong();
    record.offset = words[2].toLongLong();
    for (qsizetype i = 3; i < words.size(); ++i) {
        const qsizetype colon = words[i].indexOf(':');
        record.sizes.push_back(words[i].left(colon).toUInt());
        record.hashes.push_back(words[i].mid(colon + 1).toULongLong(nullptr, 16));
    }
    return record;
}

} // namespace

quint64 tileHash(QByteArrayView bytes)
{
    QCryptographicHash hash(QCryptographicHash::Sha1);
    hash.addData(bytes);
    return qFromBigEndian<quint64>(hash.result().constData());
}

Result<std::vector<SheetRecord>> TileJournal::read(const QString &path, const QByteArray &picture,
                                                          int *damaged)
{
    std::vector<SheetRecord> records;
    int lost = 0;
    QFile file(path);
    if (!file.exists())
        return records;
    if (!file.open(QIODevice::ReadOnly))
        return Error{QCoreApplication::translate("Tiles", "%1: cannot be read (%2)").arg(path, file.errorString())};
    bool isKnown = false;
    while (!file.atEnd()) {
        const QByteArray line = file.readLine(), text = textOf(line.chopped(1));
        if (text.isEmpty()) {
            lost += line.size() > 1 && line.endsWith('\n');
            continue;
        }
        if (text.startsWith("of ")) {
            if (text.mid(3) != picture)
                return Error{QCoreApplication::translate(
                                 "Tiles", "%1: what is there is of another picture, or of another build or backend. "
                                          "Remove it, or choose another name.")
                                 .arg(path)};
            isKnown = true;
        } else if (auto record = recordOf(text); record && isKnown) {
            records.push_back(std::move(*record));
        } else {
            ++lost;
        }
    }
    if (damaged)
        *damaged = lost;
    return records;
}

Result<void> TileJournal::open(const QString &path, const QByteArray &picture)
{
    m_file.setFileName(path);
    if (!m_file.open(QIODevice::ReadWrite | QIODevice::Append | QIODevice::Unbuffered))
        return Error{QCoreApplication::translate("Tiles",
                                                 "%1: cannot be written (%2). Choose another folder, or change "
                                                 "its permissions.")
                         .arg(path, m_file.errorString())};
    if (::flock(m_file.handle(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        return Error{QCoreApplication::translate("Tiles",
                                                 "%1: another program is drawing the same picture. Wait until it has "
                                                 "finished, or choose another name.")
                         .arg(path)};
    // A line that was cut off must not swallow the next one.
    return put("\n" + signedLine("of " + picture));
}

Result<void> TileJournal::put(const QByteArray &line)
{
    errno = 0;
    if (m_file.write(line) == line.size())
        return {};
    return Error{FileReplacement::reason(m_file.fileName(), errno ? errno : ENOSPC)};
}

Result<void> TileJournal::add(const SheetRecord &record)
{
    QByteArray text = "sheet " + QByteArray::number(record.sheet) + ' ' + QByteArray::number(record.offset);
    for (std::size_t i = 0; i < record.sizes.size(); ++i)
        text += ' ' + QByteArray::number(record.sizes[i]) + ':' + QByteArray::number(record.hashes[i], 16);
    const std::lock_guard lock(m_mutex);
    return put(signedLine(text));
}

} // namespace suffuse
