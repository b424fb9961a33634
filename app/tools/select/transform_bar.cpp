#include "app/tools/select/transform_bar.h"

#include "app/session/commands/commands.h"
#include "app/session/editor.h"
#include "app/tools/tool_fields.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/numbers/display.h"
#include "app/widgets/numbers/number_field.h"
#include "model/painting/decimal.h"
#include "undo/transform_edits.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include <numbers>

namespace suffuse {

namespace {

constexpr double farthestBox = 1e9; ///< canvas units
constexpr double smallestBox = 1e-6;

} // namespace

TransformBar::TransformBar(Editor &editor, Commands &commands, QWidget *parent)
    : QWidget(parent), m_editor(editor), m_commands(commands)
{
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(4, 2, 4, 2);
    row->setSpacing(4);
    addNumbers(*row);
    row->addSpacing(8);
    addButtons(*row, commands);
    row->addStretch(1);
    connect(&editor.laterChanges(), &LaterChanges::changed, this, &TransformBar::follow);
}

void TransformBar::addNumbers(QHBoxLayout &row)
{
    //: left edge of the selection
    addField(row, Number::X, tr("X"), tr("Left edge of the selected strokes' curves"));
    addField(row, Number::Y, tr("Y"), tr("Upper edge of the selected strokes' curves"));
    //: width
    addField(row, Number::Width, tr("W"), tr("Width of the selected strokes' curves"));
    m_proportions = new QToolButton(this);
    m_proportions->setIcon(icon("proportions"));
    m_proportions->setCheckable(true);
    m_proportions->setAutoRaise(true);
    m_proportions->setObjectName("proportions");
    m_proportions->setToolTip(tr("Keep the proportions of width and height"));
    m_proportions->setAccessibleName(tr("Keep the proportions"));
    row.addWidget(m_proportions);
    //: height
    addField(row, Number::Height, tr("H"), tr("Height of the selected strokes' curves"));
    NumberField *angle = addField(row, Number::Angle, tr("∠"), tr("Rotate the selected strokes by this angle"));
    // The values are degrees already, so only the unit of the display is taken.
    angle->setDisplay({.unit = angleDisplay().unit});
    angle->setRange(-3600, 3600);
}

NumberField *TransformBar::addField(QHBoxLayout &row, Number number, const QString &label, const QString &tip)
{
    auto *name = new QLabel(label, this);
    name->setToolTip(tip);
    auto *field = new NumberField(this);
    field->setToolTip(tip);
    field->setAccessibleName(tip);
    if (number != Number::Angle)
        field->setDisplay(lengthDisplay());
    field->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("00000.0") + millimetreUnit()) + 12);
    const bool size = number == Number::Width || number == Number::Height;
    field->setRange(size ? smallestBox : -farthestBox, farthestBox);
    field->setStep(1);
    row.addSpacing(4);
    row.addWidget(name);
    row.addWidget(field);
    connect(field, &NumberField::entered, this, [this, number](double value) { enter(number, value); });
    connect(field, &NumberField::stepped, this, [this, number](double value) { step(number, value); });
    connect(field, &NumberField::refused, this, [this, number](const QString &hint) { showHint(number, hint); });
    m_fields[std::size_t(number)] = field;
    return field;
}

void TransformBar::showHint(Number number, const QString &hint)
{
    showHintBelow(*m_fields[std::size_t(number)], hint);
}

void TransformBar::addButtons(QHBoxLayout &row, Commands &commands)
{
    const auto add = [&](Command command) {
        auto *button = new QToolButton(this);
        button->setDefaultAction(&commands[command]);
        button->setAutoRaise(true);
        button->setIconSize(QSize(20, 20));
        row.addWidget(button);
    };
    using enum Command;
    for (const Command command : {QuarterLeft, QuarterRight, FlipAcross, FlipDown, ScaleSpread})
        add(command);
    row.addSpacing(12);
    for (const Command command : {Lasso, TouchPath})
        add(command);
}

void TransformBar::showEvent(QShowEvent *event)
{
    refresh();
    QWidget::showEvent(event);
}

void TransformBar::follow()
{
    m_stale = true;
    if (isVisible()) // One refresh serves all that happens before the event loop comes round.
        QMetaObject::invokeMethod(this, &TransformBar::refresh, Qt::QueuedConnection);
}

void TransformBar::refresh()
{
    if (!std::exchange(m_stale, false))
        return;
    m_box = selectionBox(*m_editor.unsettled().painting(), m_editor.selection());
    const bool any = !m_box.isEmpty();
    const double values[] = {m_box.left, m_box.top, m_box.width(), m_box.height(), m_turn};
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        const bool flat = (i == std::size_t(Number::Width) || i == std::size_t(Number::Height)) && !(values[i] > 0);
        m_fields[i]->setEnabled(any && !flat);
        m_fields[i]->setValue(any ? std::optional(values[i]) : std::nullopt);
    }
}

void TransformBar::showTurn(std::optional<double> angle)
{
    m_turn = std::round(angle.value_or(0) * 1800 / std::numbers::pi) / 10;
    NumberField *field = m_fields[std::size_t(Number::Angle)];
    if (angle || field->value())
        field->setValue(m_turn);
}

void TransformBar::step(Number number, double value)
{
    if (std::exchange(m_stepped, number) != number)
        m_steps.endSteps();
    m_steps.noteStep();
    enter(number, value, &m_steps);
}

Affine TransformBar::mapFor(Number number, double value) const
{
    const bool keeps = m_proportions->isChecked();
    const Point corner{m_box.left, m_box.top};
    switch (number) {
    case Number::X:
        return Affine::translation({decimalSum(value, -m_box.left), 0});
    case Number::Y:
        return Affine::translation({0, decimalSum(value, -m_box.top)});
    case Number::Width: {
        const double k = value / m_box.width();
        return Affine::scaling(corner, k, keeps ? k : 1);
    }
    case Number::Height: {
        const double k = value / m_box.height();
        return Affine::scaling(corner, keeps ? k : 1, k);
    }
    case Number::Angle:
        break;
    }
    return Affine::rotation(m_box.centre(), value * std::numbers::pi / 180);
}

QString TransformBar::refusal()
{
    return tr("Some of these strokes would become too small, too large or too far away to be painted.");
}

void TransformBar::enter(Number number, double value, ValueEntry *entry)
{
    m_editor.settle();
    m_stale = true;
    refresh(); // The fields must show the box of this moment before a value is taken.
    if (m_box.isEmpty())
        return;
    const QString name = number == Number::Angle                      ? tr("Rotate")
                         : number == Number::X || number == Number::Y ? tr("Move")
                                                                      : tr("Scale");
    const SpreadRule rule = m_commands[Command::ScaleSpread].isChecked() ? SpreadRule::Scales : SpreadRule::Stays;
    const Affine map = mapFor(number, value);
    Edit edit = transformSelection(m_editor.document(), map, rule);
    if (edit.isEmpty() && !map.isIdentity())
        showHint(number, refusal());
    m_editor.push(std::move(edit), name, entry);
    m_stale = true;
    refresh();
}

} // namespace suffuse
