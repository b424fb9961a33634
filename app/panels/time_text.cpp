#include "app/panels/time_text.h"

#include <QLocale>

namespace suffuse {

QString clockText(Microseconds time)
{
    const QLocale locale;
    const auto milliseconds = (time < 0 ? -time : time) / 1000;
    return QStringLiteral("%1%2:%3%4%5")
        .arg(time < 0 ? QStringLiteral("−") : QString())
        .arg(milliseconds / 60'000)
        .arg(milliseconds / 1000 % 60, 2, 10, QLatin1Char('0'))
        .arg(locale.decimalPoint())
        .arg(milliseconds % 1000, 3, 10, QLatin1Char('0'));
}

} // namespace suffuse
