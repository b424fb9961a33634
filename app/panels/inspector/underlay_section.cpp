#include "app/panels/inspector/underlay_section.h"

#include "app/session/commands/underlay_commands.h"
#include "app/session/editor.h"
#include "app/widgets/asking/choose_picture.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/quantity.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QToolButton>

namespace suffuse {

namespace {
constexpr double farthestUnderlay = 1e9; ///< canvas units
constexpr double smallestUnderlay = 1e-3;
} // namespace

UnderlaySection::UnderlaySection(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    addHead(*column);
    m_values = new QWidget(this);
    auto *values = new QVBoxLayout(m_values);
    values->setContentsMargins(0, 0, 0, 0);
    values->setSpacing(4);
    addFields(*values);
    addButtons(*values);
    column->addWidget(m_values);
    auto *row = new QHBoxLayout;
    m_add = addButton(*row, tr("Add…"),
                      tr("A picture to paint over. It shows on the canvas only, never in what is exported."));
    column->addLayout(row);
    connect(m_add, &QPushButton::clicked, this, &UnderlaySection::choose);
    refresh();
}

void UnderlaySection::addHead(QVBoxLayout &column)
{
    auto *head = new QHBoxLayout;
    head->addWidget(sectionTitle(tr("Underlay"), this), 1);
    m_visible = makeTool(tr("Show the underlay"));
    m_visible->setCheckable(true);
    m_remove = makeTool(tr("Take the underlay out of the painting"));
    m_remove->setIcon(icon("delete"));
    head->addWidget(m_visible);
    head->addWidget(m_remove);
    column.addLayout(head);
    connect(m_visible, &QToolButton::clicked, this, [this](bool on) { underlay::show(m_editor, on); });
    connect(m_remove, &QToolButton::clicked, this, [this] { underlay::remove(m_editor); });
}

QToolButton *UnderlaySection::makeTool(const QString &text)
{
    auto *button = new QToolButton(this);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(text);
    button->setToolTip(text);
    return button;
}

NumberField *UnderlaySection::addNumber(Number number, const QString &name, const QString &toolTip)
{
    const bool isSize = number == Number::Width || number == Number::Height;
    auto *field = new NumberField(m_values);
    field->setRange(isSize ? smallestUnderlay : -farthestUnderlay, farthestUnderlay);
    field->setStep(1);
    field->setDisplay(lengthDisplay());
    field->setAccessibleName(name);
    field->setToolTip(toolTip);
    field->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("00000 u"))); // Two fields stand in a row.
    field->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(field, &NumberField::refused, this, &UnderlaySection::refused);
    connect(field, &NumberField::entered, this, [this, number](double value) { enter(number, value); });
    connect(field, &NumberField::stepped, this, [this, number](double value) { step(number, value); });
    m_fields[std::size_t(number)] = field;
    return field;
}

void UnderlaySection::addFields(QVBoxLayout &column)
{
    QGridLayout *grid = addFieldGrid(column);
    m_opacity =
        new SliderField(shareSpec(tr("Opacity"), tr("How strongly the underlay shows."), double(Underlay{}.opacity)),
                        *grid, 0, m_values);
    connect(m_opacity, &SliderField::refused, this, &UnderlaySection::refused);
    connect(m_opacity, &SliderField::edited, this,
            [this](double value, ValueEntry *entry) { underlay::setOpacity(m_editor, value, entry); });

    const auto addPair = [&](int row, const QString &name, NumberField *first, NumberField *second) {
        auto *label = new QLabel(name, m_values);
        label->setBuddy(first);
        auto *pair = new QHBoxLayout;
        pair->setSpacing(4);
        pair->addWidget(first, 1);
        pair->addWidget(second, 1);
        grid->addWidget(label, row, 0);
        grid->addLayout(pair, row, 1, 1, 2);
        return pair;
    };
    NumberField *x = addNumber(Number::X, tr("X"), tr("Left edge of the underlay"));
    NumberField *y = addNumber(Number::Y, tr("Y"), tr("Upper edge of the underlay"));
    QHBoxLayout *position = addPair(1, tr("Position"), x, y);
    NumberField *width = addNumber(Number::Width, tr("Width"), tr("Width of the underlay"));
    NumberField *height = addNumber(Number::Height, tr("Height"), tr("Height of the underlay"));
    QHBoxLayout *size = addPair(2, tr("Size"), width, height);

    m_proportions = makeTool(tr("Keep the proportions of width and height"));
    m_proportions->setIcon(icon("proportions"));
    m_proportions->setCheckable(true);
    m_proportions->setChecked(true);
    size->insertWidget(1, m_proportions);
    position->insertSpacing(1, m_proportions->sizeHint().width() + position->spacing());
}

QPushButton *UnderlaySection::addButton(QHBoxLayout &row, const QString &text, const QString &toolTip)
{
    auto *button = new QPushButton(text, this);
    button->setToolTip(toolTip);
    row.addWidget(button);
    return button;
}

void UnderlaySection::addButtons(QVBoxLayout &column)
{
    auto *row = new QHBoxLayout;
    row->setSpacing(4);
    m_fit = addButton(*row, tr("Fit to Canvas"), tr("In the middle of the canvas, as large as it goes"));
    m_replace = addButton(*row, tr("Replace…"), tr("Another picture in its place"));
    column.addLayout(row);
    connect(m_fit, &QPushButton::clicked, this, [this] { underlay::fitToCanvas(m_editor); });
    connect(m_replace, &QPushButton::clicked, this, &UnderlaySection::choose);
}

void UnderlaySection::choose()
{
    if (const QString path = choosePicture(this, tr("Import underlay")); !path.isEmpty())
        emit refused(underlay::importFile(m_editor, path));
}

void UnderlaySection::step(Number number, double value)
{
    if (std::exchange(m_stepped, number) != number)
        m_steps.endSteps();
    m_steps.noteStep();
    enter(number, value, &m_steps);
}

void UnderlaySection::enter(Number number, double value, ValueEntry *entry)
{
    const auto &underlay = m_editor.document().painting()->underlay;
    if (!underlay)
        return;
    const Rect &area = underlay->area;
    double x = area.left, y = area.top, width = area.width(), height = area.height();
    const bool together = m_proportions->isChecked() && width > 0 && height > 0;
    switch (number) {
    case Number::X:
        x = value;
        break;
    case Number::Y:
        y = value;
        break;
    case Number::Width:
        height = together ? height * value / width : height;
        width = value;
        break;
    case Number::Height:
        width = together ? width * value / height : width;
        height = value;
        break;
    }
    underlay::setArea(m_editor, Rect::of(x, y, width, height), entry);
    refresh(); // A number that was too far shows what became of it.
}

void UnderlaySection::refresh()
{
    const auto &underlay = m_editor.document().painting()->underlay;
    m_values->setVisible(bool(underlay));
    m_visible->setVisible(bool(underlay));
    m_remove->setVisible(bool(underlay));
    m_add->setVisible(!underlay);
    if (!underlay)
        return;
    m_visible->setChecked(underlay->visible);
    m_visible->setIcon(icon(underlay->visible ? "eye" : "eye-off"));
    m_opacity->setValue(double(underlay->opacity));
    field(Number::X)->setValue(underlay->area.left);
    field(Number::Y)->setValue(underlay->area.top);
    field(Number::Width)->setValue(underlay->area.width());
    field(Number::Height)->setValue(underlay->area.height());
}

} // namespace suffuse
