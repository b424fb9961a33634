#include "app/widgets/numbers/time_text.h"

#include <QLocale>
#include <QRegularExpression>

namespace suffuse {

QString clockText(Microseconds time)
{
    const QLocale locale;
    const auto milliseconds = ((time < 0 ? -time : time) + 500) / 1000;
    return QStringLiteral("%1%2:%3%4%5")
        .arg(time < 0 && milliseconds > 0 ? QStringLiteral("−") : QString())
        .arg(milliseconds / 60'000)
        .arg(milliseconds / 1000 % 60, 2, 10, QLatin1Char('0'))
        .arg(locale.decimalPoint())
        .arg(milliseconds % 1000, 3, 10, QLatin1Char('0'));
}

std::optional<Microseconds> timeOfClock(const QString &text)
{
    static const QRegularExpression form(
        QStringLiteral("^\\s*([-−])?\\s*(?:(?:(\\d{1,6}):)?(\\d{1,8}):)?(\\d{1,9}(?:[.,]\\d*)?)\\s*s?\\s*$"));
    QString plain = text;
    const QRegularExpressionMatch match = form.match(plain.replace(QLocale().decimalPoint(), QLatin1String(".")));
    if (!match.hasMatch())
        return {};
    const double seconds = match.captured(4).replace(',', '.').toDouble();
    const double whole = 3600 * match.captured(2).toDouble() + 60 * match.captured(3).toDouble() + seconds;
    return toMicroseconds(match.captured(1).isEmpty() ? whole : -whole);
}

} // namespace suffuse
