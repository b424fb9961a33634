// The two ends of a fill's gradient, as handles on the canvas.
#pragma once

#include "app/canvas/input/pointer_event.h"
#include "app/session/colour/colour_target.h"
#include "app/session/gesture.h"
#include "model/painting/ids.h"
#include "render/view.h"

#include <optional>

class QPainter;

namespace suffuse {

class CanvasWidget;
class ValueEntry;

/// A line from one end to the other, with a knob in the colour of each, for every selected stroke whose fill has a
/// gradient. A knob that is dragged takes its end along; with Ctrl the line keeps to steps of 15°. The knob that was
/// pressed last is the one that colours are for (`ColourTarget::chooseEnd`). Tools that select
/// offer each press to the handles before they look at it themselves.
class GradientHandles {
public:
    explicit GradientHandles(CanvasWidget &canvas) : m_canvas(canvas) {}

    /// Whether a press at a pixel of the canvas would take hold of a knob.
    bool isAt(Point pixel) const { return endAt(pixel).has_value(); }
    /// Returns true if the press took hold of a knob: then moves and the release belong to it, too.
    bool press(const PointerEvent &event);
    void move(const PointerEvent &event);
    /// Ends the drag, and makes a step of it.
    void release();
    /// Gives the drag up.
    void cancel();
    bool isBusy() const { return m_gesture.isOpen(); }
    /// Whether the knob that was pressed last is still there, and nothing else was chosen since.
    bool isChosen() const;
    /// Moves the end whose knob was pressed last; what is entered without a pause is one step. Returns false if no
    /// knob is chosen.
    bool nudge(Point by, ValueEntry &entry);
    /// Chooses no knob. Returns false if none was chosen.
    bool deselect();
    /// Paints the handles in device pixels.
    void paint(QPainter &painter, const View &view, double dpr) const;
    /// Device pixels from the curves of what is selected to what is painted, which may lie anywhere; 0 if there is
    /// none.
    double reach() const;
    /// What dragging a knob does, for the status bar.
    static QString hint();

private:
    using End = GradientEnd;
    std::optional<End> endAt(Point pixel) const;

    CanvasWidget &m_canvas;
    End m_end;
    std::optional<End> m_chosen;
    Point m_grab; ///< from the pointer to the end, canvas units
    Gesture m_gesture;
};

} // namespace suffuse
