#pragma once

#include <QRectF>

class QPainter;
class QWidget;

namespace suffuse {

/// Begins a plot that fills `widget`: paints its frame and sets a small font. Returns the frame's inside.
QRectF paintPlotFrame(QPainter &painter, const QWidget &widget);

} // namespace suffuse
