#include "app/widgets/number_field.h"

#include "app/widgets/arithmetic.h"

#include <QKeyEvent>
#include <QLocale>
#include <QTimer>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace suffuse {

NumberField::NumberField(QWidget *parent) : QLineEdit(parent)
{
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(this, &QLineEdit::editingFinished, this, &NumberField::commit);
    connect(this, &QLineEdit::textEdited, this, [this] { emit refused({}); });
    show(std::nullopt);
}

void NumberField::setRange(double minimum, double maximum)
{
    m_minimum = minimum;
    m_maximum = maximum;
}

void NumberField::setUnit(const QString &unit)
{
    m_unit = unit;
    show(m_value);
}

void NumberField::setValue(std::optional<double> value)
{
    if (hasFocus() && isModified() && value == m_value)
        return; // what is being typed stays while something else changes
    m_value = value;
    show(value);
}

void NumberField::show(std::optional<double> value)
{
    m_shown = value ? format(*value * m_factor) + m_unit : QStringLiteral("—");
    setText(m_shown);
    setCursorPosition(0);
    setModified(false);
}

QString NumberField::format(double shown) const
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const double size = std::abs(shown);
    if (m_integer)
        return locale.toString(shown, 'f', 0);
    if (size != 0 && (size >= 1e6 || size < 1e-3))
        return locale.toString(shown, 'g', 4);
    const int decimals = size >= 1000 ? 0 : size >= 100 ? 1 : size >= 10 ? 2 : 3;
    QString text = locale.toString(shown, 'f', decimals);
    if (text.contains(locale.decimalPoint())) {
        while (text.endsWith('0'))
            text.chop(1);
        if (text.endsWith(locale.decimalPoint()))
            text.chop(1);
    }
    return text;
}

QString NumberField::whyRefused(const QString &text) const
{
    const QString unit = m_unit.trimmed(), foreign = foreignUnit(text, unit);
    if (foreign.isEmpty())
        return tr("“%1” is not a number. Sums such as 12*1.5 or +2 work too.").arg(text);
    return unit.isEmpty() ? tr("“%1” is not possible here: this number has no unit.").arg(foreign)
                          : tr("“%1” is not possible here: the unit is %2.").arg(foreign, unit);
}

QString NumberField::rangeHint(double shown) const
{
    return tr("%1 is out of range: %2 to %3 is possible.")
        .arg(format(shown), format(m_minimum * m_factor), format(m_maximum * m_factor));
}

void NumberField::commit()
{
    if (!isModified() || text() == m_shown) {
        show(m_value);
        return;
    }
    const QString typedText = text(), unit = m_unit.trimmed();
    if (!m_value && isRelative(typedText) && evaluateArithmetic(typedText, 1.0, unit)) {
        show(m_value);
        emit refused({});
        const auto map = [typedText, unit, factor = m_factor](double value) -> std::optional<double> {
            const std::optional<double> shown = evaluateArithmetic(typedText, value * factor, unit);
            return shown ? std::optional(*shown / factor) : std::nullopt;
        };
        emit enteredRelative(map);
        return;
    }
    const std::optional<double> current = m_value ? std::optional(*m_value * m_factor) : std::nullopt;
    const std::optional<double> typed = evaluateArithmetic(typedText, current, unit);
    if (!typed) {
        show(m_value);
        emit refused(whyRefused(typedText));
        return;
    }
    const double value = m_integer ? std::round(*typed / m_factor) : *typed / m_factor;
    if (!(value >= m_minimum && value <= m_maximum)) {
        show(m_value);
        emit refused(rangeHint(*typed));
        return;
    }
    m_value = value;
    show(value);
    emit refused({});
    emit entered(value);
}

void NumberField::stepBy(double steps)
{
    if (!m_value)
        return;
    const double step = m_step > 0 ? m_step : std::max(std::abs(*m_value) * 0.1, m_minimum);
    const double value = std::clamp(*m_value + steps * step, m_minimum, m_maximum);
    if (value == *m_value)
        return;
    m_value = value;
    show(value);
    emit stepped(value);
}

bool NumberField::event(QEvent *event)
{
    // Where nothing has been typed there is nothing to undo here: the keys undo in the painting.
    if (event->type() == QEvent::ShortcutOverride && !isModified()) {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    return QLineEdit::event(event);
}

void NumberField::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down)
        stepBy((event->key() == Qt::Key_Up ? 1 : -1) * (event->modifiers() & Qt::ShiftModifier ? 10 : 1));
    else if (event->key() == Qt::Key_Escape && isModified())
        show(m_value);
    else
        QLineEdit::keyPressEvent(event);
}

void NumberField::wheelEvent(QWheelEvent *event)
{
    // Without focus the wheel scrolls the panel.
    if (!hasFocus()) {
        event->ignore();
        return;
    }
    stepBy(event->angleDelta().y() / 120.0);
    event->accept();
}

void NumberField::focusInEvent(QFocusEvent *event)
{
    QLineEdit::focusInEvent(event);
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
