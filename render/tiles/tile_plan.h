// A picture of any size, cut into tiles, with smaller pictures of the same for looking at it from afar.
#pragma once

#include "render/view.h"

#include <QtGlobal>

#include <vector>

namespace suffuse {

/// The greatest picture in tiles, pixels a side. Pixels are counted in 32 bits, with some room around the picture.
inline constexpr int maxTiledSide = int((qint64(1) << 31) - 4096);

/// One of the pictures: the whole one, or one of a half, a quarter … of its width.
struct TileLevel {
    View view;
    int columns = 0, rows = 0; ///< of tiles
    int sheetColumns = 0, sheetRows = 0;
    qint64 firstSheet = 0, firstTile = 0; ///< among those of all levels

    qint64 sheets() const { return qint64(sheetColumns) * sheetRows; }
    qint64 tiles() const { return qint64(columns) * rows; }
};

/// What is drawn at once: a square of tiles. Sheets are counted from 0 over all levels.
struct TileSheet {
    int level = 0;
    int column = 0, row = 0; ///< of its first tile
    int columns = 0, rows = 0;
    PixelRect pixels; ///< of the level's picture, with the overlap of its outer tiles
    PixelRect near;   ///< of the sheets for which strokes are prepared together
};

struct TileOptions {
    int tile = 256;    ///< pixels a side, without the overlap
    int overlap = 0;   ///< pixels that a tile shows of its neighbours on each side
    int sheet = 0;     ///< pixels a side of what is drawn at once, about; 0: the usual
    bool toOne = true; ///< whether the smallest picture is a single pixel, as in Deep Zoom; else it is a single tile
};

/// The levels of a picture from the smallest to the whole one, and its sheets. Each level is drawn, not shrunk: pixel
/// (i, j) of the level of 1/2^k covers 2^k × 2^k pixels of the whole picture. Where the sides are no multiples of that,
/// its last column and row reach beyond the area.
class TilePlan {
public:
    /// `view` is that of the whole picture.
    TilePlan(const View &view, const TileOptions &options);

    const TileOptions &options() const { return m_options; }
    const std::vector<TileLevel> &levels() const { return m_levels; }
    const View &view() const { return m_levels.back().view; }
    qint64 sheets() const { return m_levels.back().firstSheet + m_levels.back().sheets(); }
    qint64 tiles() const { return m_levels.back().firstTile + m_levels.back().tiles(); }
    /// Sheets follow each other so that neighbours share the strokes that were prepared for them.
    TileSheet sheet(qint64 number) const;
    /// The pixels of a tile in its level's picture, with its overlap.
    PixelRect tile(int level, int column, int row) const;
    double pixels() const; ///< of all levels

private:
    TileOptions m_options;
    int m_side; ///< tiles along a side of a sheet
    std::vector<TileLevel> m_levels;
};

} // namespace suffuse
