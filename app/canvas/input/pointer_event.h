// A report of mouse, pen or finger, in the form that tools and the view use.
#pragma once

#include "model/geometry/geometry.h"
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
    Microseconds late = 0;                 ///< microseconds that a press has waited before it arrived
    Qt::MouseButton button = Qt::NoButton; ///< the button that caused the report
    Qt::MouseButtons buttons;              ///< the buttons that are down
    Qt::KeyboardModifiers modifiers;
    PointerDevice device = PointerDevice::Mouse;
    bool doubleClick = false; ///< whether it is a press that follows another one at the same place
};

/// Converts logical pixels of a widget to device pixels.
Point devicePixels(const QWidget &widget, const QPointF &logical);

} // namespace suffuse
