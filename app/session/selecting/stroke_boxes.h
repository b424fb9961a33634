#pragma once

#include "model/painting/painting.h"
#include "model/painting/stroke_values.h"

namespace suffuse {

/// Keeps the boxes of the strokes' control points, by the strokes' places in the order. The boxes of strokes that stay
/// are not computed again.
class StrokeBoxes {
public:
    /// Takes up the strokes. Returns true if the same strokes stand in the same order as before, whatever their values
    /// are.
    bool follow(const StrokeList &strokes);
    const Rect &operator[](std::size_t place) const { return m_boxes[place]; }

private:
    StrokeValues<Rect> m_boxes;
};

} // namespace suffuse
