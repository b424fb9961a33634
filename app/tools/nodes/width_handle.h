// The handle that makes a stroke wider or narrower on the canvas.
#pragma once

#include "app/canvas/input/pointer_event.h"
#include "app/session/gesture.h"
#include "model/painting/selection.h"
#include "render/view.h"

#include <optional>
#include <vector>

class QPainter;

namespace suffuse {

class CanvasWidget;

/// Stands at the visible edge beside the middle of what is selected in one stroke. A drag solves for the density φ in
/// closed form, and for the diffusion D beyond twice the spread; with Shift for D alone. All selected segments keep
/// their widths' proportions. For tools that select: they offer it each press before they look at it themselves.
class WidthHandle {
public:
    explicit WidthHandle(CanvasWidget &canvas) : m_canvas(canvas) {}

    /// Whether a press there would take hold of it; pixels of the canvas.
    bool isAt(Point pixel) const;
    /// True if it took hold: moves and the release are its own then.
    bool press(const PointerEvent &event);
    void move(const PointerEvent &event);
    void release();
    /// Gives the drag up; the values are what they were.
    void cancel();
    bool isBusy() const { return m_gesture.isOpen(); }
    void paint(QPainter &painter, const View &view, double dpr) const;
    /// Device pixels from the curve to the far side of the handle; 0: there is none.
    double reach() const;
    /// What dragging it does, for the status bar.
    static QString hint();

private:
    /// Where it stands: beside the middle of a segment, on the left of its direction.
    struct Place {
        SegmentRef ref;
        Point middle;     ///< canvas units
        Point normal;     ///< of length 1
        double width = 0; ///< visible half-width of the segment, units
    };
    struct Target {
        SegmentRef ref;
        Segment before;
        double across = 1; ///< D across the curve, of D
        double cut = 0;
        double width = 0;
        double age = 0;
    };

    std::optional<Place> place() const;
    Point pixelOf(const Place &place, const View &view, double dpr) const;
    std::optional<Target> targetOf(const Stroke &stroke, const SegmentRef &ref) const;
    void widen(Segment &segment, const Target &target, double width, bool diffusionAlone) const;
    void setWidth(double width, bool diffusionAlone);

    CanvasWidget &m_canvas;
    Place m_start;
    std::vector<Target> m_targets;
    double m_grab = 0; ///< pixels between the handle and the pointer, outwards
    Gesture m_gesture;
};

} // namespace suffuse
