// Finds the tiles in which two scenes differ.
#pragma once

#include "render/scene/scene.h"
#include "render/threads/parallel.h"

#include <vector>

namespace suffuse {

/// The columns left … right − 1 and the rows top … bottom − 1 of tiles.
struct TileRange {
    int left = 0, top = 0, right = 0, bottom = 0;

    bool isEmpty() const { return left >= right || top >= bottom; }
    bool contains(const TileRange &r) const
    {
        return r.isEmpty() || (left <= r.left && top <= r.top && right >= r.right && bottom >= r.bottom);
    }
};

/// The tiles of a picture, each of which is clean or dirty.
class DirtyRegion {
public:
    /// Divides a picture, which may begin anywhere in its grid, into tiles whose corners are multiples of `tileSize`.
    /// All of them are dirty.
    void reset(const PixelRect &picture, int tileSize);
    int columns() const { return m_columns; }
    int rows() const { return m_rows; }
    /// The pixels of a tile: those that lie in the picture, and at its left and upper edge as many more as bring its
    /// corner to a multiple of `alignment`, or of the tile's size.
    PixelRect tile(int column, int row) const;
    static constexpr int alignment = 16;
    /// The part of a rectangle of the grid that lies in the picture.
    PixelRect clipped(const PixelRect &rect) const;
    const PixelRect &picture() const { return m_picture; }
    /// Moves the picture in its grid. A tile of which every pixel was in the picture, and clean, stays clean.
    void moveTo(const PixelRect &picture);
    /// The tiles in which pixels of the picture lie; empty if there are no pixels.
    TileRange tilesOf(const PixelRect &pixels) const;

    void markAll() { std::fill(m_dirty.begin(), m_dirty.end(), std::uint8_t(1)); }
    void mark(const PixelRect &pixels) { mark(tilesOf(pixels)); }
    void mark(const TileRange &tiles);
    /// Marks many ranges, at a cost that hardly depends on how large they are.
    void mark(const std::vector<TileRange> &ranges);
    bool isDirty(int column, int row) const { return m_dirty[index(column, row)] != 0; }
    /// A byte for each column of a row: 1 where the tile is dirty, else 0. Those of the next row follow.
    const std::uint8_t *dirtyRow(int row) const { return m_dirty.data() + index(0, row); }
    void clean(int column, int row) { m_dirty[index(column, row)] = 0; }
    void cleanAll() { std::fill(m_dirty.begin(), m_dirty.end(), std::uint8_t(0)); }

private:
    std::size_t index(int column, int row) const { return std::size_t(row) * m_columns + column; }

    PixelRect m_picture;
    int m_tileSize = 1, m_left = 0, m_top = 0; ///< the number of the first column and row in the grid
    int m_columns = 0, m_rows = 0;
    int m_shift = 0; ///< the tiles' size is 2^m_shift; −1 if it is no power of two
    std::vector<std::uint8_t> m_dirty;
};

/// Marks where a stroke differs from what it was in the same view: the segments whose nodes or values differ, old and
/// new, or all of it if a property of the whole stroke differs. The tiles are the same for any number of threads.
void markChanged(const SceneStroke &before, const SceneStroke &after, const PictureGrid &grid, Threads threads,
                 DirtyRegion &region);

} // namespace suffuse
