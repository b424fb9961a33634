// Helpers for the fields of the row over the canvas.
#pragma once

#include <QWidget>

#include <functional>

class QHBoxLayout;
class QPainter;

namespace suffuse {

class NumberField;
struct FieldSpec;

/// Gives a row a layout with the margins that the rows of all tools have.
QHBoxLayout *toolRow(QWidget *row);
/// Adds a label and a number field to the row. `take` is called with each number that is entered or stepped to.
NumberField *addNumber(QHBoxLayout &row, const QString &name, const QString &toolTip,
                       const std::function<void(double)> &take);

/// Does the same with name, tool tip, unit and range of a quantity.
NumberField *addNumber(QHBoxLayout &row, const FieldSpec &spec, const std::function<void(double)> &take);

/// Shows below a field why what was typed there was refused. An empty hint hides the message.
void showHintBelow(NumberField &field, const QString &hint);

/// Paints a ring around the pointer that is seen on any picture; `radius` is in device pixels.
void paintRing(QPainter &painter, double x, double y, double radius, double dpr);

} // namespace suffuse
