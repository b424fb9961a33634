// By how many samples the pixels of a block are drawn (docs/reference.md, "Supersampling").
#pragma once

#include "render/cpu/tile_fill.h"
#include "render/scene/scene.h"

#include <array>

namespace suffuse::cpu {

/// Has a mark for each pixel: levelQuarters times its level, plus the quarter (SmallSegment). It is large, and used
/// again and again.
class PixelLevels {
public:
    /// Begins the block whose first pixel is (x, y).
    void begin(const View &view, int x, int y);
    /// Finds for each pixel the greatest level of the stroke's small segments that reach it, and of its fill where the
    /// outline is near. Returns false if it is 0 everywhere.
    bool mark(const SceneStroke &stroke, const TileFill *fill);
    /// Says that the marks were changed: those of level 1 are 0 now, all of them or all but some.
    void settle(bool someLeft) { m_levels = (m_levels & ~2u) | (someLeft ? 3 : 1); }

    std::uint8_t *marks() { return m_marks.data(); }
    int at(int pixel) const { return m_marks[std::size_t(pixel)] / levelQuarters; }
    /// False only if no pixel has this level.
    bool has(int level) const { return m_levels >> level & 1; }
    /// Whether a pixel of a square has this level.
    bool has(int level, int column, int row, int side) const;

private:
    /// The first and the last of a row's (or a column's) pixels that lie in a range; none: last < first.
    struct Span {
        int first = 0, last = -1;
    };

    void findCentres();
    Span within(const std::array<double, blockSide> &places, double low, double high) const;
    bool raise(const Rect &box, std::uint8_t mark);
    void markSmall(const SceneStroke &stroke);

    View m_view;
    Point m_first; ///< the centre of the first pixel, in pixels
    bool m_known = false;
    bool m_turned = false; ///< whether the view is
    /// of the pixels, in canvas units, if the view is turned
    std::array<Point, blockSize> m_centres;
    /// else of the columns, and of the rows
    std::array<double, blockSide> m_columns, m_rows;
    Rect m_area; ///< of the centres, and more than rounding takes
    std::array<std::uint8_t, blockSize> m_marks{};
    unsigned m_levels = 0; ///< a bit for each level that a pixel may have
};

} // namespace suffuse::cpu
