#include "app/tools/shapes/next_node_fields.h"

#include "app/tools/tool_fields.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/numbers/slider_field.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QToolButton>

#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

constexpr double farthest = 1e6; ///< canvas units

} // namespace

NextNodeFields::NextNodeFields(QHBoxLayout &row) : QObject(row.parentWidget())
{
    const auto add = [&](Number number, const char *name, FieldSpec spec, double step) {
        spec.step = step;
        NumberField *field = addNumber(row, spec, [this, number](double value) { take(number, value); });
        m_fields[std::size_t(number)] = field;
        field->setObjectName(QLatin1String(name));
        field->setValue(std::nullopt);
        field->installEventFilter(this);
        connect(field, &QLineEdit::textEdited, this, [this, number] { m_edited = number; });
        connect(field, &NumberField::refused, this, [this](const QString &hint) {
            m_isRefused = !hint.isEmpty();
            if (m_isRefused)
                m_edited.reset();
        });
    };
    //: of the next node of an outline
    add(Number::X, "x",
        {tr("X"), tr("Where the next node is set, from the left. Return sets it, and so does a click"), lengthDisplay(),
         -farthest, farthest},
        1);
    //: of the next node of an outline
    add(Number::Y, "y",
        {tr("Y"), tr("Where the next node is set, from the top. Return sets it, and so does a click"), lengthDisplay(),
         -farthest, farthest},
        1);
    add(Number::Length, "length",
        {tr("Length"), tr("From the last node to the next one. Return sets it, and so does a click"), lengthDisplay(),
         0, farthest},
        1);
    add(Number::Angle, "angle",
        {tr("Angle"),
         tr("Direction from the last node to the next one, clockwise from the right. Return sets it, and so does a "
            "click"),
         angleDisplay(), -20 * std::numbers::pi, 20 * std::numbers::pi},
        std::numbers::pi / 180);
    m_close = new QToolButton(row.parentWidget());
    m_close->setObjectName("closeOutline");
    //: closes an outline
    m_close->setText(tr("Close"));
    m_close->setToolTip(tr("Closes the outline at its first node (Shift+Return)"));
    connect(m_close, &QToolButton::clicked, this, &NextNodeFields::closed);
    row.addWidget(m_close);
    show(std::nullopt, {}, false);
}

std::optional<NextNode::Number> NextNodeFields::numberOf(const QObject *watched) const
{
    for (const Number number : NextNode::numbers)
        if (field(number) == watched)
            return number;
    return std::nullopt;
}

void NextNodeFields::take(Number number, double value)
{
    m_edited.reset();
    m_node.type(number, value);
    emit changed();
}

void NextNodeFields::forgetTyped(Number number)
{
    m_edited.reset();
    m_node.forget(number);
    field(number)->setModified(false); // Only then another text than the deleted one is shown.
    field(number)->setValue(field(number)->value());
    emit changed();
}

void NextNodeFields::takeEdited()
{
    if (!m_edited)
        return;
    const Number number = *m_edited;
    if (field(number)->text().trimmed().isEmpty())
        return forgetTyped(number);
    field(number)->takeTyped();
    // Who types what the field showed anyhow means that the number is to stay.
    if (std::exchange(m_edited, std::nullopt) && field(number)->value())
        take(number, *field(number)->value());
}

void NextNodeFields::clear()
{
    m_edited.reset();
    m_node.clear();
}

void NextNodeFields::show(std::optional<Point> from, Point next, bool canClose)
{
    m_isFirst = !from;
    const Point way = from ? next - *from : Point{};
    // Rounded, since a way along an axis has no angle of 1e-15°, nor one of −0°.
    const double angle = std::round(std::atan2(way.y, way.x) * 1e12) / 1e12 + 0.0;
    const double shown[] = {next.x, next.y, length(way), angle};
    for (const Number number : NextNode::numbers) {
        const std::optional<double> typed = m_node.typed(number);
        const bool isWay = number == Number::Length || number == Number::Angle;
        if (isWay && m_isFirst && field(number)->hasFocus())
            select(Number::X);
        field(number)->setEnabled(!isWay || !m_isFirst);
        if (m_edited != number)
            field(number)->setValue(typed || m_isFirst ? typed : std::optional(shown[std::size_t(number)]));
    }
    m_close->setEnabled(canClose);
}

void NextNodeFields::select(Number number)
{
    field(number)->setFocus(Qt::OtherFocusReason);
    field(number)->selectAll();
}

void NextNodeFields::pressReturn(Number number)
{
    m_isRefused = false;
    takeEdited();
    if (m_isRefused)
        return;
    if (!m_node.isAnyTyped()) {
        emit ended();
    } else if (m_node.needsPointer(m_isFirst)) {
        select(number == Number::X ? Number::Y : Number::X);
    } else {
        const Number next = m_node.isWayTyped() ? Number::Length : Number::X;
        emit placed();
        if (!m_isFirst) // It has not closed the outline.
            select(next);
    }
}

bool NextNodeFields::eventFilter(QObject *watched, QEvent *event)
{
    const std::optional<Number> number = numberOf(watched);
    if (!number)
        return false;
    if (event->type() == QEvent::FocusOut)
        takeEdited();
    if (event->type() != QEvent::KeyPress)
        return false;
    const auto &key = static_cast<const QKeyEvent &>(*event);
    if (key.key() == Qt::Key_Escape)
        m_edited.reset(); // The field takes its text back.
    if (key.key() != Qt::Key_Return && key.key() != Qt::Key_Enter)
        return false;
    if (!(key.modifiers() & Qt::ShiftModifier)) {
        pressReturn(*number);
    } else {
        clear();
        if (m_close->isEnabled())
            emit closed();
    }
    return true;
}

} // namespace suffuse
