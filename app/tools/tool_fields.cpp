#include "app/tools/tool_fields.h"

#include "app/widgets/numbers/slider_field.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolTip>

namespace suffuse {

QHBoxLayout *toolRow(QWidget *row)
{
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(6, 0, 6, 0);
    layout->setSpacing(6);
    return layout;
}

NumberField *addNumber(QHBoxLayout &row, const QString &name, const QString &toolTip,
                       const std::function<void(double)> &take)
{
    auto *label = new QLabel(name, row.parentWidget());
    auto *field = new NumberField(row.parentWidget());
    label->setBuddy(field);
    label->setToolTip(toolTip);
    field->setToolTip(toolTip);
    field->setAccessibleName(name);
    row.addWidget(label);
    row.addWidget(field);
    row.addSpacing(10);
    QObject::connect(field, &NumberField::entered, field, take);
    QObject::connect(field, &NumberField::stepped, field, take);
    QObject::connect(field, &NumberField::refused, field,
                     [field](const QString &hint) { showHintBelow(*field, hint); });
    return field;
}

NumberField *addNumber(QHBoxLayout &row, const FieldSpec &spec, const std::function<void(double)> &take)
{
    NumberField *field = addNumber(row, spec.name, spec.toolTip, take);
    field->setRange(spec.minimum, spec.maximum);
    field->setDisplay(spec.display);
    field->setStep(spec.step);
    return field;
}

void showHintBelow(NumberField &field, const QString &hint)
{
    const auto show = [&field, hint] {
        // An empty text hides the tool tip.
        QToolTip::showText(field.mapToGlobal(QPoint(0, field.height())), hint, &field);
    };
    // Return moves the focus, which hides tool tips, so the hint is shown after that.
    QMetaObject::invokeMethod(&field, show, Qt::QueuedConnection);
}

void paintRing(QPainter &painter, double x, double y, double radius, double dpr)
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(255, 255, 255, 200), 2.2 * dpr));
    painter.drawEllipse(QPointF(x, y), radius, radius);
    painter.setPen(QPen(QColor(20, 20, 24, 200), dpr));
    painter.drawEllipse(QPointF(x, y), radius, radius);
}

} // namespace suffuse
