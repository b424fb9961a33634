#include "app/widgets/numbers/decimal_box.h"

#include "app/widgets/numbers/arithmetic.h"

#include <cmath>

namespace suffuse {

std::optional<double> DecimalBox::read(const QString &text) const
{
    QString number = text;
    if (!suffix().isEmpty() && number.endsWith(suffix()))
        number.chop(suffix().size());
    return evaluateArithmetic(number.trimmed(), value(), suffix().trimmed());
}

double DecimalBox::valueFromText(const QString &text) const
{
    const double digits = std::pow(10, decimals());
    return std::round(read(text).value_or(value()) * digits) / digits;
}

QValidator::State DecimalBox::validate(QString &text, int &) const
{
    const std::optional<double> number = read(text);
    return number && *number >= minimum() && *number <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
}

} // namespace suffuse
