// What was finished of a picture in tiles, on disk, with the hashes by which it is known to be whole.
#pragma once

#include "model/result.h"

#include <QByteArray>
#include <QFile>

#include <mutex>
#include <numeric>
#include <vector>

namespace suffuse {

/// The first 8 bytes of SHA-1: they find damage, not forgery.
quint64 tileHash(QByteArrayView bytes);

struct SheetRecord {
    qint64 sheet = 0;
    qint64 offset = 0; ///< of its tiles in a file of many, one after the other; 0 where each is a file
    std::vector<quint32> sizes;
    std::vector<quint64> hashes;

    qint64 size() const { return std::accumulate(sizes.begin(), sizes.end(), qint64(0)); }
};

/// A file that grows by a line for each finished sheet. A line that was cut off or damaged is as if it had never been
/// written. Its first line says of which picture it is.
class TileJournal {
public:
    /// The records of a file; none if there is no file. It fails if the file is of another picture than `picture`.
    /// `damaged`: how many lines are not whole, but for one at the end that was cut off.
    static Result<std::vector<SheetRecord>> read(const QString &path, const QByteArray &picture,
                                                 int *damaged = nullptr);

    /// Opens the file to go on with it, or makes it. It fails while another process has it open so: two of them would
    /// write over each other. The lock goes with the process.
    Result<void> open(const QString &path, const QByteArray &picture);
    /// Adds a line, and flushes it. Any thread may call it.
    Result<void> add(const SheetRecord &record);
    bool isOpen() const { return m_file.isOpen(); }
    QString path() const { return m_file.fileName(); }
    void close() { m_file.close(); }

private:
    Result<void> put(const QByteArray &line);

    QFile m_file;
    std::mutex m_mutex;
};

} // namespace suffuse
