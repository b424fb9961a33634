#include "app/widgets/numbers/display.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

QString numberIn(const QLocale &locale, double shown, int decimals)
{
    const double size = std::abs(shown);
    if (decimals < 0 && size != 0 && (size >= 1e6 || size < 1e-3))
        return locale.toString(shown, 'g', 4);
    int places = size >= 1000 ? 0 : size >= 100 ? 1 : size >= 10 ? 2 : 3;
    if (decimals >= 0)
        places = std::min(decimals, places);
    // The number is rounded first, so that one that is shown as zero has no sign.
    const double power = std::pow(10.0, places), rounded = size * power < 0.5 ? 0 : shown;
    QString text = locale.toString(rounded, 'f', places);
    if (text.contains(locale.decimalPoint())) {
        while (text.endsWith('0'))
            text.chop(1);
        if (text.endsWith(locale.decimalPoint()))
            text.chop(1);
    }
    return text;
}

} // namespace

QString Display::number(double value) const
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return numberIn(locale, toShown(value), decimals);
}

QString Display::text(double value) const
{
    constexpr double large = 10'000;
    return (std::abs(toShown(value)) < large ? number(value) : numberIn(QLocale(), toShown(value), decimals)) + unit;
}

QString canvasUnit()
{
    return QCoreApplication::translate("suffuse::NumberField", " u");
}

QString millimetreUnit()
{
    return QCoreApplication::translate("suffuse::NumberField", " mm");
}

QString inchUnit()
{
    return QCoreApplication::translate("suffuse::NumberField", " in");
}

QString secondsUnit()
{
    return QCoreApplication::translate("suffuse::NumberField", " s");
}

QString diffusionUnit()
{
    return QCoreApplication::translate("suffuse::NumberField", " u²/s");
}

Display lengthDisplay()
{
    return {.unit = canvasUnit(), .isLength = true};
}

Display timeDisplay()
{
    return {.unit = secondsUnit()};
}

Display diffusionDisplay()
{
    return {.unit = diffusionUnit()};
}

Display angleDisplay()
{
    return {.unit = QStringLiteral("°"), .factor = 180 / std::numbers::pi};
}

Display shareDisplay()
{
    return {.unit = QStringLiteral(" %"), .factor = 100, .decimals = 1};
}

Display grainDisplay()
{
    return {.unit = QStringLiteral(" %"), .factor = -100, .offset = 100, .decimals = 1};
}

Display grainDifferenceDisplay()
{
    return {.unit = QStringLiteral(" %"), .factor = -100, .decimals = 1};
}

Display screenDisplay()
{
    return {.unit = QStringLiteral(" px")};
}

} // namespace suffuse
