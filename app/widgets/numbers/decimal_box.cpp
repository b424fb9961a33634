#include "app/widgets/numbers/decimal_box.h"

#include "app/widgets/numbers/arithmetic.h"
#include "app/widgets/numbers/number_field.h"

#include <QKeyEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

/// What stands in a box, without the box's suffix.
QString cleanedOf(QString text, const QString &suffix)
{
    if (!suffix.isEmpty() && text.endsWith(suffix))
        text.chop(suffix.size());
    return text.trimmed();
}

/// The value of what stands in a box, with the box's suffix or without it, in a unit.
std::optional<double> valueIn(const QString &text, const QString &suffix, double current, const QString &unit,
                              double resolution = 0)
{
    return evaluateArithmetic(cleanedOf(text, suffix), current, unit, resolution);
}

QString inWords(const DecimalBox &box, double value)
{
    return box.inWords(value);
}

QString inWords(const WholeBox &box, int value)
{
    return box.locale().toString(value);
}

QString unitOf(const DecimalBox &box)
{
    return box.unit();
}

QString unitOf(const WholeBox &box)
{
    return box.suffix().trimmed();
}

QValidator::State stateOf(const std::optional<double> &number, double minimum, double maximum)
{
    return number && *number >= minimum && *number <= maximum ? QValidator::Acceptable : QValidator::Intermediate;
}

/// Says below a box why it does not take what stands in it; nothing where it does.
template <class Box>
void sayWhyRefused(Box &box, const std::optional<double> &read)
{
    if (box.hasAcceptableInput())
        return;
    const QString text = box.cleanText();
    const QString why = read ? NumberField::tr("%1 is out of range: %2 to %3 is possible.")
                                   .arg(text, inWords(box, box.minimum()), inWords(box, box.maximum()))
                             : NumberField::whyUnread(text, unitOf(box));
    // After what Return and Tab do to the focus, which hides tool tips.
    QMetaObject::invokeMethod(
        &box, [&box, why] { QToolTip::showText(box.mapToGlobal(QPoint(0, box.height())), why, &box); },
        Qt::QueuedConnection);
}

/// Whether a key would confirm what a box does not take; it says why not.
template <class Box>
bool refusesReturn(Box &box, const QKeyEvent &event, const std::optional<double> &read)
{
    const bool isReturn = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    if (!isReturn || box.hasAcceptableInput())
        return false;
    sayWhyRefused(box, read);
    return true;
}

} // namespace

void DecimalBox::keyPressEvent(QKeyEvent *event)
{
    if (!refusesReturn(*this, *event, read(cleanText())))
        QDoubleSpinBox::keyPressEvent(event);
}

void DecimalBox::focusOutEvent(QFocusEvent *event)
{
    sayWhyRefused(*this, read(cleanText()));
    QDoubleSpinBox::focusOutEvent(event);
}

void WholeBox::keyPressEvent(QKeyEvent *event)
{
    if (!refusesReturn(*this, *event, read(cleanText())))
        QSpinBox::keyPressEvent(event);
}

void WholeBox::focusOutEvent(QFocusEvent *event)
{
    sayWhyRefused(*this, read(cleanText()));
    QSpinBox::focusOutEvent(event);
}

std::optional<double> DecimalBox::read(const QString &text) const
{
    if (!m_display)
        return valueIn(text, suffix(), value(), unit());
    const std::optional<double> shown =
        valueIn(text, suffix(), m_display->toShown(value()), unit(), m_display->resolution);
    return shown ? std::optional(m_display->toValue(*shown)) : std::nullopt;
}

void DecimalBox::setDisplay(const Display &display)
{
    m_display = display;
    setSuffix(display.unit);
    setSingleStep(display.step);
}

QString DecimalBox::inWords(double value) const
{
    return m_display ? shownText(value, finestDecimals())
                     : locale().toString(value, 'f', QLocale::FloatingPointShortest);
}

QString DecimalBox::textFromValue(double value) const
{
    if (!m_display)
        return QDoubleSpinBox::textFromValue(value);
    return shownText(value, std::min(finestDecimals(), m_display->unit == inchUnit() ? 3 : 2));
}

/// How many decimals of the shown number tell a value from its neighbours.
int DecimalBox::finestDecimals() const
{
    return decimals() + std::max(0, int(std::ceil(-std::log10(std::abs(m_display->factor)))));
}

QString DecimalBox::shownText(double value, int decimals) const
{
    QLocale plain = locale();
    plain.setNumberOptions(plain.numberOptions() | QLocale::OmitGroupSeparator);
    QString text = plain.toString(m_display->toShown(value), 'f', decimals);
    if (text.contains(plain.decimalPoint())) {
        while (text.endsWith(QLatin1Char('0')))
            text.chop(1);
        if (text.endsWith(plain.decimalPoint()))
            text.chop(1);
    }
    return text;
}

double DecimalBox::valueFromText(const QString &text) const
{
    if (m_display && cleanedOf(text, suffix()) == textFromValue(value()))
        return value(); // What stands there untouched has fewer digits than the value.
    const double digits = std::pow(10, decimals());
    return std::round(read(text).value_or(value()) * digits) / digits;
}

QValidator::State DecimalBox::validate(QString &text, int &) const
{
    return stateOf(read(text), minimum(), maximum());
}

WholeBox::WholeBox(QWidget *parent) : QSpinBox(parent)
{
    setKeyboardTracking(false); // "*2" would double the number with each key that follows.
}

std::optional<double> WholeBox::read(const QString &text) const
{
    std::optional<double> number = valueIn(text, suffix(), value(), suffix().trimmed());
    if (number)
        number = std::round(*number);
    return number;
}

int WholeBox::valueFromText(const QString &text) const
{
    return int(read(text).value_or(value()));
}

QValidator::State WholeBox::validate(QString &text, int &) const
{
    return stateOf(read(text), minimum(), maximum());
}

} // namespace suffuse
