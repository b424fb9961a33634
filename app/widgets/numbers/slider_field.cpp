#include "app/widgets/numbers/slider_field.h"

#include "app/widgets/numbers/bar_slider.h"

#include <QEvent>
#include <QGridLayout>
#include <QLocale>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {
/// The slider's ends multiply mixed values by this, or divide them by it. Where values are added to, its ends are half
/// of its range away.
constexpr double greatestFactor = 10;
constexpr std::size_t mostAmounts = 64; ///< steps that an undo or a redo is looked for among
} // namespace

SliderField::SliderField(const FieldSpec &spec, QGridLayout &grid, int row, QWidget *parent)
    : QObject(parent), m_spec(spec), m_label(new QLabel(spec.name, parent)), m_slider(new BarSlider(parent)),
      m_number(new NumberField(parent))
{
    rename(spec.name, spec.toolTip);
    m_label->installEventFilter(this);
    m_label->setBuddy(m_number);
    m_number->setRange(spec.minimum, spec.maximum);
    m_number->setDisplay(spec.display);
    m_number->setStep(spec.step);
    grid.addWidget(m_label, row, 0);
    grid.addWidget(m_slider, row, 1);
    grid.addWidget(m_number, row, 2);

    connect(m_slider, &QSlider::sliderPressed, this, &SliderField::sliderPressed);
    connect(m_slider, &QSlider::valueChanged, this, &SliderField::sliderChanged);
    connect(m_slider, &BarSlider::givenUp, this, &SliderField::giveUp);
    connect(m_slider, &QSlider::sliderReleased, this, [this] {
        m_entry.commitDrag();
        m_pressedValue.reset();
        noteAmount();
        setValue(m_value);
        emit dragEnded();
    });
    connect(m_number, &NumberField::entered, this, [this](double value) { emit edited(value, nullptr); });
    connect(m_number, &NumberField::enteredRelative, this, [this](const ValueMap &map) {
        emit editedRelative([map, low = m_spec.minimum, high = m_spec.maximum](double value) {
            const std::optional<double> mapped = map(value);
            return mapped && *mapped >= low && *mapped <= high ? mapped : std::nullopt;
        });
    });
    connect(m_number, &NumberField::stepped, this, [this](double value) { emit edited(value, step()); });
    connect(m_number, &NumberField::steppedMixed, this, [this](double steps) {
        if (m_isOneOfSeveral && m_value)
            stepToOne(steps);
        else
            stepAll(steps);
    });
    connect(m_number, &NumberField::refused, this, &SliderField::refused);
}

void SliderField::rename(const QString &name, const QString &toolTip)
{
    m_label->setText(name);
    if (const int least = m_label->minimumWidth(); least > 0) // That of the names before would cut a longer one.
        m_label->setMinimumWidth(std::max(least, m_label->sizeHint().width()));
    m_toolTip = toolTip;
    m_label->setToolTip(toolTip + "\n" + tr("Double-click: back to the default."));
    m_slider->setAccessibleName(tr("%1, slider").arg(name));
    m_number->setAccessibleName(name);
    showMixed(m_slider->isMixed());
}

void SliderField::showMixed(bool mixed)
{
    m_slider->setMixed(mixed);
    const QString scales = tr("The values differ. The slider multiplies each of them; with Ctrl it makes them one.");
    const QString shifts = tr("The values differ. The slider adds to each of them; with Ctrl it makes them one.");
    const QString says = mixed ? changeKind() == ValueChange::Scale ? scales : shifts : QString();
    m_slider->setStatusTip(says);
    m_slider->setToolTip(mixed ? m_toolTip + '\n' + says : m_toolTip);
    const QString typed = mixed || m_isOneOfSeveral
                              ? tr("The values differ. A number makes them one; *1.2 or +2 changes each of them.")
                              : QString();
    m_number->setStatusTip(typed);
    m_number->setToolTip(typed.isEmpty() ? m_toolTip : m_toolTip + '\n' + typed);
}

ValueChange::Kind SliderField::changeKind() const
{
    return m_spec.logarithmic ? ValueChange::Scale : ValueChange::Shift;
}

std::optional<ValueChange> SliderField::change() const
{
    if (!m_amount)
        return std::nullopt;
    return ValueChange{changeKind(), *m_amount, m_spec.minimum, m_spec.maximum};
}

int SliderField::positionOf(double amount) const
{
    const double range = m_spec.sliderMaximum - m_spec.sliderMinimum;
    double share = 0;
    if (changeKind() == ValueChange::Scale)
        share = 0.5 * std::log(amount) / std::log(greatestFactor);
    else if (range > 0)
        share = (m_spec.display.isReversed() ? -amount : amount) / range;
    return int(std::lround((0.5 + std::clamp(share, -0.5, 0.5)) * BarSlider::steps));
}

double SliderField::amountAt(int position) const
{
    const double share = double(position) / BarSlider::steps - 0.5;
    if (changeKind() == ValueChange::Scale) {
        const double factor = std::pow(greatestFactor, 2 * share);
        const double unit = factor < 1 ? 1e-3 : 1e-2;
        return std::round(factor / unit) * unit;
    }
    const double amount =
        (m_spec.display.isReversed() ? -share : share) * (m_spec.sliderMaximum - m_spec.sliderMinimum);
    const double unit = m_spec.sliderStep > 0 ? m_spec.sliderStep : m_spec.step;
    return unit > 0 ? std::round(amount / unit) * unit : amount;
}

QString SliderField::changeText() const
{
    if (!m_amount)
        return {};
    if (changeKind() == ValueChange::Scale)
        return QStringLiteral("×") + QLocale().toString(*m_amount, 'f', *m_amount < 1 ? 3 : 2);
    Display display = m_number->display();
    const double shown = *m_amount * display.factor;
    display.factor = 1;
    display.offset = 0;
    return (shown < 0 ? QStringLiteral("−") : QStringLiteral("+")) + display.text(std::abs(shown));
}

void SliderField::forgetChange()
{
    if (m_slider->isSliderDown())
        return;
    m_entry.forgetStart();
    m_amounts.clear();
    if (!m_amount)
        return;
    m_amount.reset();
    setValue(m_value);
}

void SliderField::keepChange(const std::function<bool(const ValueChange &)> &holds)
{
    if (!m_amount || m_slider->isSliderDown())
        return;
    const auto isOf = [&](double amount) { return holds({changeKind(), amount, m_spec.minimum, m_spec.maximum}); };
    if (isOf(*m_amount))
        return;
    const auto found = std::find_if(m_amounts.rbegin(), m_amounts.rend(), isOf);
    if (found != m_amounts.rend())
        m_amount = *found;
    else if (const double none = ValueChange::neutral(changeKind()); isOf(none))
        m_amount = none;
    else
        forgetChange();
}

/// What is shown has become a step.
void SliderField::noteAmount()
{
    if (!m_amount || std::find(m_amounts.begin(), m_amounts.end(), *m_amount) != m_amounts.end())
        return;
    if (m_amounts.size() == mostAmounts)
        m_amounts.erase(m_amounts.begin());
    m_amounts.push_back(*m_amount);
}

void SliderField::changeAll(double amount, ValueEntry *entry)
{
    m_amount = amount;
    if (!m_entry.isDragging())
        noteAmount();
    m_number->setMixedText(changeText());
    emit refused({});
    emit changed(*change(), entry);
}

void SliderField::stepAll(double steps)
{
    const double from = m_amount.value_or(ValueChange::neutral(changeKind()));
    double amount = 0;
    if (changeKind() == ValueChange::Scale) {
        const double factor = std::clamp(from * std::pow(1.1, steps), 1e-3, 1e3);
        const double unit = factor < 1 ? 1e-3 : 1e-2;
        amount = std::round(factor / unit) * unit;
    } else {
        const double range = m_spec.sliderMaximum - m_spec.sliderMinimum;
        const double step = (m_spec.step > 0 ? m_spec.step : 0.01 * range) * (m_spec.display.isReversed() ? -1 : 1);
        amount = from + steps * step;
    }
    changeAll(amount, step());
    setValue(m_value);
}

/// From the one that is shown by the slider, which all become.
void SliderField::stepToOne(double steps)
{
    const double unit = m_spec.step > 0 ? m_spec.step : 0.01 * (m_spec.maximum - m_spec.minimum);
    emit refused({});
    emit edited(std::clamp(*m_value + steps * unit, m_spec.minimum, m_spec.maximum), step());
}

int SliderField::toPosition(double value) const
{
    const double low = m_spec.sliderMinimum, high = m_spec.sliderMaximum;
    if (!(high > low))
        return 0;
    const double v = std::clamp(value, low, high);
    const double share = m_spec.logarithmic ? std::log(v / low) / std::log(high / low) : (v - low) / (high - low);
    return int(std::lround((m_spec.display.isReversed() ? 1 - share : share) * BarSlider::steps));
}

double SliderField::toValue(int position) const
{
    const double along = double(position) / BarSlider::steps;
    const double share = m_spec.display.isReversed() ? 1 - along : along; // the shown value grows to the right
    const double low = m_spec.sliderMinimum, high = m_spec.sliderMaximum;
    if (!m_spec.logarithmic) {
        const double value = low + share * (high - low);
        return m_spec.sliderStep > 0 ? std::round(value / m_spec.sliderStep) * m_spec.sliderStep : value;
    }
    // Values have three significant digits: nobody wants 12.589254.
    const double value = low * std::pow(high / low, share);
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2);
    return std::clamp(std::round(value / unit) * unit, low, high);
}

void SliderField::setValue(std::optional<double> value)
{
    m_value = value;
    // A change goes on being shown where it has made the values equal, by a limit: it can be taken back.
    const bool mixed = !value || m_amount;
    m_number->setMixedText(changeText());
    m_number->setValue(mixed || m_isOneOfSeveral ? std::nullopt : value);
    const QSignalBlocker blocker(m_slider);
    if (mixed != m_slider->isMixed())
        showMixed(mixed);
    if (!m_slider->isSliderDown())
        m_slider->setValue(mixed ? positionOf(m_amount.value_or(ValueChange::neutral(changeKind())))
                                 : toPosition(*value));
}

void SliderField::setOneOfSeveral(bool several)
{
    if (several == m_isOneOfSeveral)
        return;
    m_isOneOfSeveral = several;
    setValue(m_value);
    showMixed(m_slider->isMixed());
}

void SliderField::setEnabled(bool enabled)
{
    m_label->setEnabled(enabled);
    m_slider->setEnabled(enabled);
    m_number->setEnabled(enabled);
}

void SliderField::setVisible(bool visible)
{
    m_label->setVisible(visible);
    m_slider->setVisible(visible);
    m_number->setVisible(visible);
}

void SliderField::setRange(double minimum, double maximum)
{
    m_spec.minimum = minimum;
    m_spec.maximum = maximum;
    m_number->setRange(minimum, maximum);
}

void SliderField::setSliderRange(double minimum, double maximum)
{
    m_spec.sliderMinimum = minimum;
    m_spec.sliderMaximum = maximum;
    setValue(m_value);
}

void SliderField::sliderPressed()
{
    m_entry.beginDrag();
    m_pressedValue = m_value;
    m_pressedAmount = m_amount;
    m_pressedPosition = m_slider->value();
    if (!m_amount)
        m_entry.forgetStart();
    emit dragStarted();
}

void SliderField::sliderChanged(int position)
{
    if (m_slider->isMixed() && !(m_slider->isSliderDown() && m_slider->makesOne())) {
        const bool back = m_slider->isSliderDown() && m_pressedAmount && position == m_pressedPosition;
        ValueEntry *entry = m_slider->isSliderDown() ? &m_entry : step();
        changeAll(back ? *m_pressedAmount : amountAt(position), entry);
        return;
    }
    double value = toValue(position);
    ValueEntry *entry = &m_entry;
    if (!m_slider->isSliderDown())
        entry = step();
    else if (m_pressedValue && position == m_pressedPosition)
        value = *m_pressedValue;
    m_value = value;
    m_amount.reset();
    m_amounts.clear();
    showMixed(false);
    m_number->setValue(value);
    emit refused({});
    emit edited(value, entry);
}

void SliderField::giveUp()
{
    m_value = m_pressedValue;
    m_amount = m_pressedAmount;
    if (m_pressedValue && !m_amount) // for whoever keeps values without an editor
        emit edited(*m_pressedValue, &m_entry);
    m_entry.giveUpDrag();
    emit dragEnded();
}

/// The entry for a step by key or wheel.
ValueEntry *SliderField::step()
{
    m_entry.noteStep();
    if (!m_amount)
        m_entry.forgetStart();
    return &m_entry;
}

bool SliderField::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_label && event->type() == QEvent::MouseButtonDblClick && m_label->isEnabled()) {
        emit edited(m_spec.defaultValue, nullptr);
        return true;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace suffuse
