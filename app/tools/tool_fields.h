// Fields of the row over the canvas.
#pragma once

#include <QWidget>

#include <functional>

class QHBoxLayout;
class QPainter;

namespace suffuse {

class NumberField;

/// A row's layout with the margins that all tools have.
QHBoxLayout *toolRow(QWidget *row);
/// A label with a number field behind it, added to the row; `take` gets what is entered or stepped to.
NumberField *addNumber(QHBoxLayout &row, const QString &name, const QString &toolTip,
                       const std::function<void(double)> &take);

/// A ring around the pointer that shows on any picture: `radius` in device pixels.
void paintRing(QPainter &painter, double x, double y, double radius, double dpr);

} // namespace suffuse
