#include "app/widgets/numbers/decimal_box.h"

#include "app/widgets/numbers/arithmetic.h"

#include <cmath>

namespace suffuse {

namespace {

/// The value of what stands in a box, with the box's suffix or without it.
std::optional<double> valueIn(const QString &text, const QString &suffix, double current)
{
    QString number = text;
    if (!suffix.isEmpty() && number.endsWith(suffix))
        number.chop(suffix.size());
    return evaluateArithmetic(number.trimmed(), current, suffix.trimmed());
}

QValidator::State stateOf(const std::optional<double> &number, double minimum, double maximum)
{
    return number && *number >= minimum && *number <= maximum ? QValidator::Acceptable : QValidator::Intermediate;
}

} // namespace

std::optional<double> DecimalBox::read(const QString &text) const
{
    return valueIn(text, suffix(), value());
}

double DecimalBox::valueFromText(const QString &text) const
{
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
    std::optional<double> number = valueIn(text, suffix(), value());
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
