#include "app/widgets/numbers/slider_field.h"

#include "app/widgets/numbers/bar_slider.h"

#include <QEvent>
#include <QGridLayout>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {
constexpr int stepGapMs = 900; ///< key and wheel steps closer than this are one undo step
}

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
    connect(m_number, &NumberField::refused, this, &SliderField::refused);
}

void SliderField::rename(const QString &name, const QString &toolTip)
{
    m_label->setText(name);
    m_label->setToolTip(toolTip + "\n" + tr("Double-click: back to the default."));
    m_slider->setAccessibleName(tr("%1, slider").arg(name));
    m_slider->setToolTip(toolTip);
    m_number->setAccessibleName(name);
    m_number->setToolTip(toolTip);
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
    m_number->setValue(value);
    const QSignalBlocker blocker(m_slider);
    m_slider->setMixed(!value);
    if (value && !m_slider->isSliderDown())
        m_slider->setValue(toPosition(*value));
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
    m_pressedPosition = m_slider->value();
    emit dragStarted();
}

void SliderField::sliderChanged(int position)
{
    double value = toValue(position);
    ValueEntry *entry = &m_entry;
    if (!m_slider->isSliderDown())
        entry = step();
    else if (m_pressedValue && position == m_pressedPosition)
        value = *m_pressedValue;
    m_value = value;
    m_slider->setMixed(false);
    m_number->setValue(value);
    emit refused({});
    emit edited(value, entry);
}

void SliderField::giveUp()
{
    m_value = m_pressedValue;
    if (m_pressedValue) // for whoever keeps values without an editor
        emit edited(*m_pressedValue, &m_entry);
    m_entry.giveUpDrag();
}

/// The entry for a step by key or wheel.
ValueEntry *SliderField::step()
{
    if (!m_sinceStep.isValid() || m_sinceStep.elapsed() > stepGapMs)
        m_entry.endSteps();
    m_sinceStep.restart();
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
