// Where the tiles of a picture go.
#pragma once

#include "render/tiles/tile_encoder.h"
#include "render/tiles/tile_journal.h"
#include "render/tiles/tile_plan.h"

#include <QJsonObject>

#include <functional>
#include <map>
#include <mutex>
#include <optional>

namespace suffuse {

/// A picture in tiles that is to be written.
struct TiledPicture {
    TilePlan plan;
    TileEncoding encoding;
    QString path;        ///< picture.dzi, or picture.tif
    QByteArray identity; ///< all that its bits depend on, in one line
};

/// Puts down what was finished, and knows what is there. One object may be used by several threads.
class TileStore {
public:
    virtual ~TileStore() = default;
    /// Whether the sheet is there, and whole: its tiles are read again and their hashes compared.
    virtual bool has(qint64 sheet) = 0;
    /// A tile of a sheet is made, the `index`-th row by row. Each tile is told once, by any thread, before its sheet is
    /// put: a store of files writes them side by side.
    virtual Result<void> putTile(const TileSheet & /*sheet*/, std::size_t /*index*/, const QByteArray & /*tile*/)
    {
        return {};
    }
    /// Puts down the tiles of a sheet, row by row; after it they are known to be there.
    virtual Result<void> put(const TileSheet &sheet, qint64 number, const std::vector<QByteArray> &tiles) = 0;
};

/// The records of several journals, by sheet.
using SheetRecords = std::multimap<qint64, SheetRecord>;

/// A file that is not what was written down of it.
struct LostFile {
    QString path;
    bool isThere = false; ///< but damaged
};

/// A folder of tiles beside a .dzi file: picture_files/level/column_row.jpg. Each file is replaced as a whole.
class DeepZoomStore : public TileStore {
public:
    /// `records`: what is said to be there. New sheets go into `journal`, by their number and `base`.
    DeepZoomStore(const TiledPicture &picture, SheetRecords records, TileJournal &journal, qint64 base = 0);

    bool has(qint64 sheet) override;
    Result<void> putTile(const TileSheet &sheet, std::size_t index, const QByteArray &tile) override;
    Result<void> put(const TileSheet &sheet, qint64 number, const std::vector<QByteArray> &tiles) override;
    /// Writes the description and the page that shows the picture. All sheets must be there.
    Result<void> finish();

    static QString filesOf(const QString &path); ///< picture_files, which must be there
    static QString pageOf(const QString &path);  ///< picture.html
    /// Whether there is something else than our page where it will be.
    static bool isPageTaken(const QString &path);
    QString pathOf(int level, int column, int row) const;
    /// Files of a sheet that are not what its records say, in their order.
    std::vector<LostFile> lost(qint64 sheet) const;

private:
    const TiledPicture &m_picture;
    SheetRecords m_records;
    TileJournal &m_journal;
    const qint64 m_base;
    QString m_files;
};

/// The same, with the file in which the tiles of a record lie.
using PackRecords = std::multimap<qint64, std::pair<SheetRecord, QString>>;

/// A file that grows.
class PackFile {
public:
    /// `from` is where it begins.
    Result<void> open(const QString &path, qint64 from = 0);
    /// Adds bytes and returns where they lie. Any thread may call it.
    Result<qint64> add(const QByteArray &bytes);
    const QString &path() const { return m_path; }
    qint64 end() const { return m_end; }

private:
    QString m_path;
    QFile m_file;
    std::mutex m_mutex;
    qint64 m_end = 0;
};

/// A file to which the tiles of one sheet after the other are added.
class PackStore : public TileStore {
public:
    PackStore(PackRecords records, TileJournal &journal, PackFile &file, qint64 base = 0);

    /// By the last record of the sheet.
    bool has(qint64 sheet) override;
    Result<void> put(const TileSheet &sheet, qint64 number, const std::vector<QByteArray> &tiles) override;
    /// A record of the sheet whose tiles are whole, and their bytes.
    std::optional<std::pair<SheetRecord, QByteArray>> whole(qint64 sheet) const;

private:
    PackRecords m_records;
    TileJournal &m_journal;
    PackFile &m_file;
    const qint64 m_base;
};

/// The record of tiles, and of a single file.
SheetRecord sheetRecord(qint64 number, qint64 offset, const std::vector<QByteArray> &tiles);
/// Replaces a file by the bytes. `toDisk`: see FileReplacement::commit.
Result<void> replaceFile(const QString &path, const QByteArray &bytes, bool toDisk);

/// What a file lacks of what `isGood` says of its bytes; nothing where it is good.
std::optional<LostFile> lostFile(const QString &path, const std::function<bool(const QByteArray &)> &isGood);

/// Whether tiles, one after the other, have the sizes and hashes of the record.
bool isWhole(const SheetRecord &record, QByteArrayView tiles);

} // namespace suffuse
