// A report of mouse, pen or finger, as tools and the view take it.
#pragma once

#include "model/painting/geometry.h"
#include "model/painting/segment.h"

#include <QPointF>

class QWidget;

namespace suffuse {

enum class PointerDevice { Mouse, Pen, Eraser };

/// One report of the pointer.
struct PointerEvent {
    Point point;                           ///< canvas units
    Point pixel;                           ///< device pixels of the canvas widget
    double pressure = 1;                   ///< [0, 1]; a mouse presses fully
    double tiltX = 0;                      ///< degrees
    double tiltY = 0;                      ///< degrees
    Microseconds time = 0;                 ///< document time
    Microseconds late = 0;                 ///< of a press: how long it has waited to be heard of
    Qt::MouseButton button = Qt::NoButton; ///< what caused it
    Qt::MouseButtons buttons;              ///< what is down
    Qt::KeyboardModifiers modifiers;
    PointerDevice device = PointerDevice::Mouse;
    bool doubleClick = false; ///< a press that follows another at the same place
};

/// Logical pixels of a widget in device pixels.
Point devicePixels(const QWidget &widget, const QPointF &logical);

} // namespace suffuse
