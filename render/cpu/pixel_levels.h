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
    /// Looks at the marks again after they were changed.
    void recount();

    std::uint8_t *marks() { return m_marks.data(); }
    int at(int pixel) const { return m_marks[std::size_t(pixel)] / levelQuarters; }
    bool has(int level) const { return m_levels >> level & 1; }
    /// Whether a pixel of a square has this level.
    bool has(int level, int column, int row, int side) const;

private:
    void findCentres();
    void raise(const Rect &box, std::uint8_t mark);
    void markSmall(const SceneStroke &stroke);

    View m_view;
    Point m_first; ///< the centre of the first pixel, in pixels
    bool m_known = false;
    bool m_turned = false; ///< whether the view is
    /// of the pixels, in canvas units; if the view is not turned only those of the first row and the first column
    std::array<Point, blockSize> m_centres;
    Rect m_area; ///< of the centres, and more than rounding takes
    std::array<std::uint8_t, blockSize> m_marks{};
    unsigned m_levels = 0; ///< a bit for each level that a pixel has
};

} // namespace suffuse::cpu
