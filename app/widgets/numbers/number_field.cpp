#include "app/widgets/numbers/number_field.h"

#include "app/widgets/look/section.h"
#include "app/widgets/numbers/arithmetic.h"
#include "app/widgets/numbers/length_units.h"

#include <QDialog>
#include <QKeyEvent>
#include <QLocale>
#include <QTimer>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace suffuse {

NumberField::NumberField(QWidget *parent) : EntryField(parent)
{
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(this, &EntryField::typed, this, &NumberField::take);
    connect(this, &QLineEdit::textEdited, this, [this] {
        if (m_complains)
            complain({});
    });
    show(std::nullopt);
}

void NumberField::setRange(double minimum, double maximum)
{
    m_minimum = minimum;
    m_maximum = maximum;
}

void NumberField::setUnit(const QString &unit)
{
    m_display.unit = unit;
    show(m_value);
}

void NumberField::setDisplay(const Display &display)
{
    m_display = display;
    show(m_value);
}

Display NumberField::display() const
{
    return m_display.isLength ? lengthDisplay(this) : m_display;
}

void NumberField::followUnits()
{
    if (m_display.isLength && !(hasFocus() && isModified()))
        show(m_value);
}

/// It may have come into another window.
void NumberField::showEvent(QShowEvent *event)
{
    followUnits();
    EntryField::showEvent(event);
}

void NumberField::complain(const QString &hint)
{
    m_complains = !hint.isEmpty();
    emit refused(hint);
    if (m_complains)
        keepInSight(*this);
}

void NumberField::setValue(std::optional<double> value)
{
    if (hasFocus() && isModified() && value == m_value)
        return; // the text that is being typed stays while something else changes
    m_value = value;
    show(value);
}

void NumberField::setMixedText(const QString &text)
{
    if (text == m_mixedText)
        return;
    m_mixedText = text;
    if (!m_value && !isModified())
        show(m_value);
}

void NumberField::show(std::optional<double> value)
{
    const QString mixed = m_mixedText.isEmpty() ? QStringLiteral("—") : m_mixedText;
    replaceText(value ? display().text(*value) : mixed);
}

QString NumberField::whyUnread(const QString &text, const QString &unit, double resolution)
{
    const QString foreign = foreignUnit(text, unit, resolution);
    if (foreign.isEmpty())
        return tr("“%1” is not a number. Sums such as 12*1.5 or +2 work too.").arg(text);
    return unit.isEmpty() ? tr("“%1” is not possible here: this number has no unit.").arg(foreign)
                          : tr("“%1” is not possible here: the unit is %2.").arg(foreign, unit);
}

/// A number in a sentence. Large ones are grouped there, and small ones written out, which is easier to read than an
/// exponent.
QString NumberField::inWords(double value) const
{
    const Display display = this->display();
    const double shown = display.toShown(value), size = std::abs(shown);
    const bool isLarge = size >= 1e6 && size < 1e16, isSmall = size >= 1e-9 && size < 1e-3;
    if (!isSmall)
        return isLarge ? QLocale().toString(shown, 'f', 0) : display.number(value);
    QString text = QLocale().toString(shown, 'f', 9);
    while (text.endsWith('0'))
        text.chop(1);
    return text;
}

QString NumberField::rangeHint(double value) const
{
    double low = m_minimum, high = m_maximum;
    if (m_display.isReversed())
        std::swap(low, high);
    // A tiny number says nothing to somebody who has typed none at all.
    if (const double shown = display().toShown(low); shown > 0 && shown < (display().toShown(value) > 0 ? 1e-30 : 1e-4))
        return tr("%1 is out of range: more than 0 and up to %2 is possible.").arg(inWords(value), inWords(high));
    return tr("%1 is out of range: %2 to %3 is possible.").arg(inWords(value), inWords(low), inWords(high));
}

void NumberField::take(const QString &typedText)
{
    const Display display = this->display();
    const QString unit = display.unit.trimmed();
    const auto evaluated = [=](std::optional<double> current) {
        return evaluateArithmetic(typedText, current, unit, display.resolution);
    };
    if (typedText.trimmed().isEmpty()) { // Nothing is meant by it.
        show(m_value);
        complain({});
        return;
    }
    if (!m_value && isRelative(typedText, unit) && evaluated(1.0)) {
        show(m_value);
        complain({});
        const auto map = [=](double value) -> std::optional<double> {
            const std::optional<double> shown = evaluated(display.toShown(value));
            return shown ? std::optional(display.toValue(*shown)) : std::nullopt;
        };
        emit enteredRelative(map);
        return;
    }
    const std::optional<double> current = m_value ? std::optional(display.toShown(*m_value)) : std::nullopt;
    const std::optional<double> typed = evaluated(current);
    if (!typed) {
        show(m_value);
        complain(whyUnread(typedText, unit, display.resolution));
        return;
    }
    const double exact = display.toValue(*typed), value = m_integer ? std::round(exact) : exact;
    if (!(value >= m_minimum && value <= m_maximum)) {
        show(m_value);
        complain(rangeHint(exact));
        return;
    }
    m_value = value;
    show(value);
    complain({});
    emit entered(value);
}

void NumberField::stepBy(double steps)
{
    if (isModified()) { // A number goes on from what is read in the field.
        takeTyped();
        if (m_complains)
            return;
    }
    if (!m_value) {
        complain({});
        emit steppedMixed(steps);
        return;
    }
    const double up = m_display.isReversed() ? -steps : steps; // up means up in the shown sense
    // By shares a number goes by factors, so that as many steps down as up come back to it.
    const bool byFactors = !(m_step > 0) && *m_value != 0;
    const double step = m_step > 0 ? m_step * display().step : m_minimum;
    const double next = byFactors ? *m_value * std::pow(1.1, *m_value > 0 ? up : -up) : *m_value + up * step;
    const double value = std::clamp(next, m_minimum, m_maximum);
    if (value == *m_value)
        return complain((steps > 0 ? tr("%1 is the most that is possible.") : tr("%1 is the least that is possible."))
                            .arg(inWords(value)));
    m_value = value;
    show(value);
    complain({});
    emit stepped(value);
}

void NumberField::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down) {
        stepBy((event->key() == Qt::Key_Up ? 1 : -1) * (event->modifiers() & Qt::ShiftModifier ? 10 : 1));
    } else {
        const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
        const bool typed = isReturn && isModified();
        EntryField::keyPressEvent(event);
        if (typed && m_complains) {
            // A dialog does not go on with another number than the typed one. In a panel the keyboard stays, so that
            // the keys that are to mend the number are not the canvas', where Delete deletes strokes.
            event->accept();
            selectAll();
        }
    }
}

void NumberField::wheelEvent(QWheelEvent *event)
{
    stepBy(event->angleDelta().y() / 120.0);
    event->accept();
}

void NumberField::focusInEvent(QFocusEvent *event)
{
    EntryField::focusInEvent(event);
    QTimer::singleShot(0, this, &QLineEdit::selectAll);
}

QSize NumberField::sizeHint() const
{
    return {fontMetrics().horizontalAdvance(QStringLiteral("10000 u²/s")) + 14, QLineEdit::sizeHint().height()};
}

QSize NumberField::minimumSizeHint() const
{
    return sizeHint();
}

} // namespace suffuse
