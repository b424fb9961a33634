// What lies on the canvas and can be dragged there whatever tool is in use.
#pragma once

#include "app/canvas/input/pointer_event.h"
#include "render/view.h"

#include <QCursor>

#include <optional>

class QPainter;

namespace suffuse {

struct OverlayColours;

/// The hand asks it at each press of the main button, before the tool. Pixels are device pixels of the canvas.
class CanvasHandle {
public:
    virtual ~CanvasHandle() = default;

    /// The cursor over what would take a press at a pixel; no value: nothing would.
    virtual std::optional<QCursor> cursorAt(Point pixel) const = 0;
    /// Takes a press, if `cursorAt` has a cursor there.
    virtual void press(const PointerEvent &event) = 0;
    virtual void move(const PointerEvent &event) = 0;
    virtual void release(const PointerEvent &event) = 0;
    /// Puts back what was dragged, as if it had not been pressed.
    virtual void cancel() = 0;
    virtual void paint(QPainter &painter, const View &view, const OverlayColours &colours, double dpr) const = 0;
};

} // namespace suffuse
