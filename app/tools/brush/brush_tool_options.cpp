#include "app/tools/brush/brush_tool_options.h"

#include "app/session/editor.h"
#include "app/session/settings/brush_library.h"
#include "app/tools/tool_fields.h"
#include "app/widgets/brush/brush_combo.h"
#include "app/widgets/numbers/quantity.h"
#include "model/brush/brush_width.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>

namespace suffuse {

BrushToolOptions::BrushToolOptions(Editor &editor) : m_editor(editor)
{
    QHBoxLayout *row = toolRow(this);
    addPresets(*row);
    FieldSpec size = specOf(Quantity::Size), opacity = specOf(Quantity::Opacity);
    size.toolTip = tr("Width of a dry line at full pressure, in units ([ and ] change it)");
    opacity.toolTip = tr("How much the paint covers ({ and } change it)");
    m_size = addNumber(*row, size, [this](double value) { change([=](Brush &b) { setVisibleWidth(b, value); }); });
    m_flow = addNumber(*row, specOf(Quantity::Flow),
                       [this](double value) { change([=](Brush &b) { b.peak = float(value); }); });
    m_opacity =
        addNumber(*row, opacity, [this](double value) { change([=](Brush &b) { b.colour.opacity = float(value); }); });
    addSmoothing(*row);
    row->addStretch();
    connect(&editor, &Editor::brushChanged, this, &BrushToolOptions::refresh);
    connect(&BrushLibrary::instance(), &BrushLibrary::changed, this, [this] {
        m_presets->fill();
        refresh();
    });
    m_presets->fill();
    refresh();
}

void BrushToolOptions::addPresets(QHBoxLayout &row)
{
    m_presets = new BrushCombo(this);
    m_presets->setToolTip(tr("What to paint with. Click: all brushes, with pictures."));
    m_presets->setAccessibleName(tr("Brush"));
    m_presets->setPlaceholderText(tr("Own brush"));
    row.addWidget(m_presets);
    row.addSpacing(10);
    connect(m_presets, &QComboBox::activated, this,
            [this](int i) { BrushLibrary::instance().use(m_editor, m_presets->itemData(i).toString()); });
}

void BrushToolOptions::addSmoothing(QHBoxLayout &row)
{
    auto *label = new QLabel(tr("Smoothing"), this);
    m_smoothing = new QComboBox(this);
    m_smoothing->addItems(smoothingNames());
    m_smoothing->setToolTip(tr("Steadies the hand: the stroke follows the pen softly, or is pulled on a string"));
    m_smoothing->setAccessibleName(tr("Smoothing"));
    label->setBuddy(m_smoothing);
    row.addWidget(label);
    row.addWidget(m_smoothing);
    connect(m_smoothing, &QComboBox::activated, this,
            [this](int i) { change([=](Brush &b) { b.stabiliser.kind = Stabiliser::Kind(i); }); });
    m_amount = new NumberField(this);
    m_amount->setAccessibleName(tr("Amount of smoothing"));
    m_amount->setToolTip(tr("How strongly it lags behind, or how long the string is"));
    row.addWidget(m_amount);
    connect(m_amount, &NumberField::entered, this, &BrushToolOptions::takeAmount);
    connect(m_amount, &NumberField::stepped, this, &BrushToolOptions::takeAmount);
}

void BrushToolOptions::takeAmount(double value)
{
    const bool string = m_editor.brush().stabiliser.kind == Stabiliser::Kind::String;
    change([=](Brush &b) { (string ? b.stabiliser.length : b.stabiliser.strength) = float(value); });
}

void BrushToolOptions::change(const std::function<void(Brush &)> &apply)
{
    Brush brush = m_editor.brush();
    apply(brush);
    m_editor.setBrush(brush);
}

void BrushToolOptions::refresh()
{
    const Brush &brush = m_editor.brush();
    m_presets->setCurrentIndex(m_presets->findData(brush.name));
    m_size->setValue(visibleWidth(brush));
    m_flow->setValue(double(brush.peak));
    m_opacity->setValue(double(brush.colour.opacity));
    m_smoothing->setCurrentIndex(int(brush.stabiliser.kind));
    const bool string = brush.stabiliser.kind == Stabiliser::Kind::String;
    m_amount->setVisible(brush.stabiliser.kind != Stabiliser::Kind::Off);
    const FieldSpec amount = specOf(string ? Quantity::SmoothingString : Quantity::SmoothingStrength);
    m_amount->setRange(amount.minimum, amount.maximum);
    m_amount->setDisplay(amount.display);
    m_amount->setStep(amount.step);
    m_amount->setValue(double(string ? brush.stabiliser.length : brush.stabiliser.strength));
}

} // namespace suffuse
