// Fields of the row over the canvas.
#pragma once

#include <QWidget>

#include <functional>

class QHBoxLayout;
class QPainter;

namespace suffuse {

class NumberField;
struct FieldSpec;

/// A row's layout with the margins that all tools have.
QHBoxLayout *toolRow(QWidget *row);
/// A label with a number field behind it, added to the row; `take` gets what is entered or stepped to.
NumberField *addNumber(QHBoxLayout &row, const QString &name, const QString &toolTip,
                       const std::function<void(double)> &take);

/// The same, with name, tool tip, unit and range of a quantity.
NumberField *addNumber(QHBoxLayout &row, const FieldSpec &spec, const std::function<void(double)> &take);

/// Says below a field of a row why what was typed there was refused; empty: that is over.
void showHintBelow(NumberField &field, const QString &hint);

/// A ring around the pointer that shows on any picture: `radius` in device pixels.
void paintRing(QPainter &painter, double x, double y, double radius, double dpr);

} // namespace suffuse
