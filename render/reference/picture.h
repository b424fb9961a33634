// A picture as the paint of a stroke, in double precision (docs/solver.md, "Pictures").
#pragma once

#include "model/painting/stroke.h"
#include "render/reference/colour.h"
#include "render/view.h"

#include <memory>
#include <vector>

namespace suffuse::reference {

/// The picture of a stroke as a view filters it.
class PictureField {
public:
    /// Null if its image is missing or cannot be read.
    static std::shared_ptr<const PictureField> of(const Stroke &stroke, const View &view);

    /// What the stroke shows at a pixel, or at a point of the canvas, where it has this paint.
    Paint shownAtPixel(Point pixel, const Paint &paint) const { return shownAt(m_view.toCanvas(pixel), paint); }
    Paint shownAt(Point canvas, const Paint &paint) const;

private:
    using Value = std::array<double, 4>; ///< premultiplied
    struct Level {
        int width = 0, height = 0;
        std::vector<Value> values;
        const Value &at(int x, int y) const;
        Value between(double x, double y) const;
    };
    static Level half(const Level &level);

    View m_view;
    Point m_corner, m_right, m_down; ///< on the canvas; the last two as vectors from the first
    double m_lambda = 0;             ///< the binary logarithm of the image's pixels along a pixel, beyond m_finer
    Level m_finer, m_coarser;
    double m_columns = 1, m_rows = 1; ///< of the image in pixels of the finer level, which may end in part of one
};

} // namespace suffuse::reference
