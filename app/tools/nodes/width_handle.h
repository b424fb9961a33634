// The handle that makes a stroke wider or narrower on the canvas.
#pragma once

#include "app/canvas/input/pointer_event.h"
#include "app/session/gesture.h"
#include "app/session/painting/seen_width.h"
#include "model/painting/selection.h"
#include "render/view.h"

#include <optional>
#include <vector>

class QPainter;

namespace suffuse {

class CanvasWidget;

/// The handle stands at the visible edge, beside the middle of what is selected in one stroke. Dragging it solves in
/// closed form for the density φ, and beyond twice the spread for the diffusion D; with Shift it solves for D alone.
/// Erasures have no such edge: beside them there is no handle, and it leaves them as they are. The widths of all
/// selected segments keep their proportions. Tools that select offer each press to the handle before they look at it
/// themselves.
class WidthHandle {
public:
    explicit WidthHandle(CanvasWidget &canvas) : m_canvas(canvas) {}

    /// Whether a press at a pixel of the canvas would take hold of the handle.
    bool isAt(Point pixel) const;
    /// The segment that the handle stands beside; nothing where there is no handle.
    std::optional<SegmentRef> segment() const;
    /// Returns true if the press took hold of the handle: then moves and the release belong to it, too.
    bool press(const PointerEvent &event);
    /// Goes on with the drag.
    void move(const PointerEvent &event);
    /// Ends the drag, and makes a step of it.
    void release();
    /// Gives the drag up: the values are again what they were.
    void cancel();
    bool isBusy() const { return m_gesture.isOpen(); }
    /// Paints the handle in device pixels, if there is one.
    void paint(QPainter &painter, const View &view, double dpr) const;
    /// Device pixels from the curve to the far side of the handle; 0 if there is none.
    double reach() const;
    /// What dragging the handle does, for the status bar.
    static QString hint();

private:
    /// Where the handle stands: beside the middle of a segment, to the left of its direction.
    struct Place {
        SegmentRef ref;
        Point middle;     ///< canvas units
        Point normal;     ///< a vector of length 1
        double width = 0; ///< visible half-width of the segment, canvas units
    };
    struct Target {
        SegmentRef ref;
        Segment before;
        SeenWidth seen;
    };

    std::optional<Place> place() const;
    Point pixelOf(const Place &place, const View &view, double dpr) const;
    std::optional<Target> targetOf(const Stroke &stroke, const SegmentRef &ref) const;
    void setWidth(double width, bool diffusionAlone);

    CanvasWidget &m_canvas;
    Place m_start;
    std::vector<Target> m_targets;
    double m_grab = 0; ///< pixels from the handle outwards to where the pointer took hold of it
    Gesture m_gesture;
};

} // namespace suffuse
