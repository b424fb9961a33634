#include "app/tools/assistants/assistant_row.h"

#include "app/session/commands/commands.h"
#include "app/tools/tool_fields.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/numbers/display.h"
#include "app/widgets/numbers/number_field.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include <numbers>

namespace suffuse {

namespace {

constexpr double farthestPoint = 1e9; ///< canvas units
constexpr double smallestAxis = 1e-3;

} // namespace

QString nameOf(AssistantKind kind)
{
    switch (kind) {
    case AssistantKind::Ruler:
        break;
    case AssistantKind::Parallel:
        return AssistantRow::tr("Parallel Lines");
    case AssistantKind::VanishingPoint:
        return AssistantRow::tr("Vanishing Point");
    case AssistantKind::Perspective:
        return AssistantRow::tr("Perspective");
    case AssistantKind::Ellipse:
        return AssistantRow::tr("Ellipse");
    case AssistantKind::Concentric:
        return AssistantRow::tr("Concentric Ellipses");
    }
    return AssistantRow::tr("Ruler");
}

AssistantRow::AssistantRow(Commands &commands, QWidget *parent) : QWidget(parent)
{
    QHBoxLayout *row = toolRow(this);
    m_kinds = new QComboBox(this);
    m_kinds->setObjectName("kind");
    for (int kind = 0; kind <= int(AssistantKind::Concentric); ++kind)
        m_kinds->addItem(nameOf(AssistantKind(kind)));
    m_kinds->setToolTip(tr("What is made next"));
    m_kinds->setAccessibleName(tr("What is made next"));
    connect(m_kinds, &QComboBox::activated, this, [this](int index) { emit kindChosen(AssistantKind(index)); });
    row->addWidget(m_kinds);
    addButtons(*row, commands);
    addField(*row, Number::X, tr("X"), tr("Horizontal place of the chosen point, canvas units"));
    addField(*row, Number::Y, tr("Y"), tr("Vertical place of the chosen point, canvas units"));
    addField(*row, Number::Angle, tr("∠"), tr("Angle of the line or of the first half axis, clockwise"));
    addField(*row, Number::First, tr("a"), tr("First half axis of the ellipse, canvas units"));
    addField(*row, Number::Second, tr("b"), tr("Second half axis of the ellipse, canvas units"));
    row->addStretch(1);
    show(nullptr, 0);
}

void AssistantRow::addButtons(QHBoxLayout &row, Commands &commands)
{
    auto *add = new QToolButton(this);
    add->setObjectName("add");
    add->setIcon(icon("plus"));
    add->setAutoRaise(true);
    add->setIconSize(QSize(20, 20));
    add->setToolTip(tr("A new one in the middle of the view"));
    add->setAccessibleName(tr("New assistant"));
    connect(add, &QToolButton::clicked, this, &AssistantRow::newAsked);
    row.addWidget(add);
    using enum Command;
    for (const Command command : {Delete, ShowAssistants, SnapToAssistants}) {
        auto *button = new QToolButton(this);
        button->setDefaultAction(&commands[command]);
        button->setAutoRaise(true);
        button->setIconSize(QSize(20, 20));
        row.addWidget(button);
    }
}

void AssistantRow::addField(QHBoxLayout &row, Number number, const QString &label, const QString &tip)
{
    auto *pair = new QWidget(this);
    auto *inner = new QHBoxLayout(pair);
    inner->setContentsMargins(4, 0, 0, 0);
    inner->setSpacing(4);
    auto *name = new QLabel(label, pair);
    name->setToolTip(tip);
    auto *field = new NumberField(pair);
    field->setToolTip(tip);
    field->setAccessibleName(tip);
    const bool isAxis = number == Number::First || number == Number::Second;
    if (number == Number::Angle) {
        field->setDisplay(angleDisplay());
        field->setRange(-2 * std::numbers::pi, 2 * std::numbers::pi);
        field->setStep(std::numbers::pi / 180);
    } else {
        field->setDisplay(lengthDisplay());
        field->setRange(isAxis ? smallestAxis : -farthestPoint, farthestPoint);
        field->setStep(1);
    }
    field->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("00000.0") + canvasUnit()) + 12);
    inner->addWidget(name);
    inner->addWidget(field);
    row.addWidget(pair);
    connect(field, &NumberField::entered, this, [this, number](double value) { emit entered(number, value); });
    connect(field, &NumberField::stepped, this, [this, number](double value) { emit entered(number, value); });
    connect(field, &NumberField::refused, this, [field](const QString &hint) { showHintBelow(*field, hint); });
    m_fields[std::size_t(number)] = field;
    m_pairs[std::size_t(number)] = pair;
}

void AssistantRow::showKind(AssistantKind kind)
{
    m_kinds->setCurrentIndex(int(kind));
}

void AssistantRow::show(const Assistant *chosen, std::size_t point)
{
    const bool isRound = chosen && chosen->isRound();
    const bool isStraight = chosen && (chosen->kind == AssistantKind::Ruler || chosen->kind == AssistantKind::Parallel);
    m_pairs[std::size_t(Number::Angle)]->setVisible(isRound || isStraight);
    for (const Number axis : {Number::First, Number::Second})
        m_pairs[std::size_t(axis)]->setVisible(isRound);
    for (const Number place : {Number::X, Number::Y}) {
        field(place).setEnabled(chosen);
        field(place).setValue(std::nullopt);
    }
    if (!chosen)
        return;
    field(Number::X).setValue(chosen->points[point].x);
    field(Number::Y).setValue(chosen->points[point].y);
    if (isRound) {
        const Assistant::Form form = chosen->form();
        field(Number::Angle).setValue(form.angle);
        field(Number::First).setValue(form.first);
        field(Number::Second).setValue(form.second);
    } else if (isStraight) {
        const Point way = chosen->points[1] - chosen->points[0];
        field(Number::Angle).setValue(std::atan2(way.y, way.x));
    }
}

} // namespace suffuse
