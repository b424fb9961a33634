#include "app/dialogs/export/clock_box.h"

#include "app/widgets/numbers/time_text.h"

namespace suffuse {

ClockBox::ClockBox(QWidget *parent) : QDoubleSpinBox(parent)
{
    setDecimals(3);
    setRange(0, 1e9);
    setSingleStep(0.1);
    setKeyboardTracking(false);
    setAlignment(Qt::AlignRight);
}

QString ClockBox::textFromValue(double seconds) const
{
    return clockText(toMicroseconds(seconds));
}

double ClockBox::valueFromText(const QString &text) const
{
    const std::optional<Microseconds> time = timeOfClock(text);
    return time ? toSeconds(*time) : value();
}

QValidator::State ClockBox::validate(QString &text, int &) const
{
    const std::optional<Microseconds> time = timeOfClock(text);
    const bool isIn = time && toSeconds(*time) >= minimum() && toSeconds(*time) <= maximum();
    return isIn ? QValidator::Acceptable : QValidator::Intermediate;
}

} // namespace suffuse
