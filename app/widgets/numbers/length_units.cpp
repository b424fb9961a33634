#include "app/widgets/numbers/length_units.h"

#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "app/widgets/numbers/number_field.h"
#include "model/painting/resolution.h"

namespace suffuse {

LengthUnits::LengthUnits(QWidget &window, Editor &editor) : LengthUnits(window, usualResolution)
{
    m_editor = &editor;
    connect(&editor.document(), &Document::changed, this, [this](const Change &change) {
        if (change.reset) // Another painting may be as large on paper as it likes.
            refresh();
    });
}

LengthUnits::LengthUnits(QWidget &form, double resolution)
    : QObject(&form), m_window(form), m_resolution(resolution), m_units(settings::canvasAids().rulerUnits)
{}

LengthUnits *LengthUnits::of(const QWidget *widget)
{
    for (; widget; widget = widget->parentWidget())
        if (auto *units = widget->findChild<LengthUnits *>(QString(), Qt::FindDirectChildrenOnly))
            return units;
    return nullptr;
}

void LengthUnits::setUnits(RulerUnits units)
{
    m_units = units;
    refresh();
}

void LengthUnits::setResolution(double resolution)
{
    m_resolution = resolution;
    refresh();
}

void LengthUnits::refresh()
{
    for (NumberField *field : m_window.findChildren<NumberField *>())
        field->followUnits();
    emit changed();
}

Display LengthUnits::display() const
{
    constexpr double inchSteps = 10;
    const double resolution = m_editor ? m_editor->resolution() : m_resolution;
    Display display = lengthDisplay();
    display.resolution = resolution;
    if (m_units == RulerUnits::Millimetres) {
        display.unit = millimetreUnit();
        display.factor = millimetresOfInch / resolution;
        display.step = 1 / display.factor;
    } else if (m_units == RulerUnits::Inches) {
        display.unit = inchUnit();
        display.factor = 1 / resolution;
        display.step = resolution / inchSteps;
    }
    return display;
}

Display lengthDisplay(const QWidget *widget)
{
    const LengthUnits *units = LengthUnits::of(widget);
    return units ? units->display() : lengthDisplay();
}

} // namespace suffuse
