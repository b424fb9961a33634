// What a drag of the Select tool snaps to.
#pragma once

#include "app/session/selecting/snapping.h"
#include "model/painting/selection.h"

namespace suffuse {

/// Snaps strokes that are moved (by their box and their nodes), a handle, or the centre of rotation.
class TransformSnap {
public:
    enum class What { Strokes, Handle, Centre };

    /// Gathers what the drag can snap to. `start` is where it began, canvas units.
    void begin(const Painting &painting, const CanvasAids &aids, const std::vector<Guide> &guides,
               const Selection &moved, What what, Point start);
    /// Returns the move that is nearest to `by` and snaps, or `by` itself. Canvas units.
    Point move(Point by, const View &view, double dpr);
    /// Returns the place that is nearest to a point and snaps, or the point itself. Canvas units.
    Point point(Point to, const View &view, double dpr);
    /// Forgets the snap, since the drag goes freely.
    void clear() { m_found = {}; }
    /// The place that the drag snapped to last.
    const Snap &found() const { return m_found; }

private:
    Snapping m_snapping;
    Snap m_found;
    std::vector<Point> m_points; ///< the points that move along with the drag
};

} // namespace suffuse
