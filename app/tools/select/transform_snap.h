// What a drag of the Select tool snaps to.
#pragma once

#include "app/session/selecting/snapping.h"
#include "model/painting/selection.h"

namespace suffuse {

/// Snapping of strokes that are moved, by their box and their nodes; of a handle; or of the centre of rotation.
class TransformSnap {
public:
    enum class What { Strokes, Handle, Centre };

    /// `start`: where the drag began, canvas units.
    void begin(const Painting &painting, const CanvasAids &aids, const Selection &moved, What what, Point start);
    /// Where the strokes go that are to go by so much.
    Point move(Point by, const View &view, double dpr);
    /// Where a point goes.
    Point point(Point to, const View &view, double dpr);
    /// The drag goes freely.
    void clear() { m_found = {}; }
    /// The place that it snapped to last.
    const Snap &found() const { return m_found; }

private:
    Snapping m_snapping;
    Snap m_found;
    std::vector<Point> m_points; ///< that move along
};

} // namespace suffuse
