#pragma once

#include "model/painting/painting.h"
#include "model/painting/stroke_values.h"

namespace suffuse {

/// The boxes of the strokes' control points, by their places in the order. Those of strokes that stay are kept.
class StrokeBoxes {
public:
    /// True where the same strokes stand in the same order as before, whatever their values are.
    bool follow(const StrokeList &strokes);
    const Rect &operator[](std::size_t place) const { return m_boxes[place]; }

private:
    StrokeValues<Rect> m_boxes;
};

} // namespace suffuse
