// The frame of a pyramidal BigTIFF file around tiles that are packed already.
#pragma once

#include "render/tiles/tile_store.h"

#include <functional>

namespace suffuse {

/// The room for the head of the file, before which no tile lies.
inline constexpr qint64 bigTiffHead = 16;

/// A file in which the head, the directories and the tables of tiles come last, so that it is no TIFF before it is
/// whole. libtiff keeps these in memory to the end, and cannot go on with a file that has no directory yet.
class BigTiff {
public:
    /// Puts bytes at an offset; false where that fails.
    using Write = std::function<bool(qint64 offset, const void *bytes, std::size_t size)>;

    /// The tables begin at `end`, behind all tiles.
    BigTiff(const TiledPicture &picture, qint64 end, Write write);

    /// Enters where the tiles of a sheet lie.
    bool enter(const TileSheet &sheet, const SheetRecord &record);
    /// Writes directories and head, after all sheets have been entered. `profile`: ICC, of the colours.
    bool finish(const QByteArray &profile);

private:
    qint64 tableOf(std::size_t level) const { return m_tables + 16 * m_picture.plan.levels()[level].firstTile; }
    QByteArray directoryOf(std::size_t level, qint64 at, qint64 profileAt, qint64 profileSize, bool isLast) const;

    const TiledPicture &m_picture;
    const qint64 m_tables; ///< for each level the offsets and then the sizes of its tiles, 8 bytes each
    const Write m_write;
    std::map<std::size_t, std::pair<qint64, qint64>> m_single; ///< levels of one tile, which stands in the directory
};

/// Frames a file in which the tiles of `records` lie up to `end`, brings it to disk, and puts it into the picture's
/// place. A sheet may have several records.
Result<void> frameBigTiff(const TiledPicture &picture, const QString &file, qint64 end,
                          const std::vector<SheetRecord> &records);

} // namespace suffuse
