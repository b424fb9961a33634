// The attribute brush's row over the canvas.
#include "app/widgets/number_field.h"
#include "app/tools/attribute_brush_tool.h"
#include "app/tools/tool_fields.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>

namespace suffuse {

namespace {

/// What the value field holds for a wish.
struct ValueSpec {
    double minimum;
    double maximum;
    double usual; ///< value when the quantity is chosen
    double factor;
    QString unit;
};

ValueSpec specOf(const AttributeWish &wish)
{
    if (wish.relative)
        return isRatio(wish.attribute) ? ValueSpec{0.001, 1000, 1.5, 1, QStringLiteral(" ×")}
                                       : ValueSpec{-1, 1, 0.25, 100, QStringLiteral(" %")};
    switch (wish.attribute) {
    case Attribute::Diffusion:
        return {1e-9, 1e12, Segment{}.diffusion, 1, NumberField::diffusionUnit()};
    case Attribute::Density:
        return {0, 1e12, Segment{}.density, 1, NumberField::canvasUnit()};
    case Attribute::MaxAge:
        return {1e-9, 1e6, Segment{}.maxAge, 1, NumberField::secondsUnit()};
    default:
        return {0, 1, 1, 100, QStringLiteral(" %")};
    }
}

} // namespace

QWidget *AttributeBrushTool::options()
{
    if (m_options)
        return m_options;
    m_options = new QWidget;
    QHBoxLayout *row = toolRow(m_options);
    m_attributes = new QComboBox(m_options);
    m_attributes->addItems(
        {tr("Diffusion D"), tr("Density φ"), tr("Granulation ω"), tr("Colour"), tr("Opacity"), tr("Drying time")});
    m_attributes->setToolTip(tr("What is painted onto the segments"));
    m_attributes->setAccessibleName(m_attributes->toolTip());
    row->addWidget(m_attributes);
    m_modes = new QComboBox(m_options);
    m_modes->addItems({QString(), QString()});
    m_modes->setToolTip(tr("Towards a value, or from the value that each segment has"));
    m_modes->setAccessibleName(m_modes->toolTip());
    row->addWidget(m_modes);
    m_value = addNumber(*row, tr("Value"), tr("What a segment has when it got all of it"),
                        [this](double value) { m_wish.value = value; });
    m_valueLabel = m_options->findChild<QLabel *>();
    addSizeField(*row);
    NumberField *flow =
        addNumber(*row, tr("Flow"), tr("How fast it is laid down"), [this](double value) { setFlow(value); });
    flow->setRange(0.001, 1);
    flow->setDisplayFactor(100);
    flow->setUnit(QStringLiteral(" %"));
    flow->setValue(m_flow);
    row->addStretch();
    connect(m_attributes, &QComboBox::activated, this,
            [this](int i) { chooseAttribute(allAttributes[std::size_t(i)]); });
    connect(m_modes, &QComboBox::activated, this, [this](int i) {
        if (m_wish.relative == (i == 1))
            return;
        m_wish.relative = i == 1;
        chooseAttribute(m_wish.attribute);
    });
    refreshOptions();
    return m_options;
}

void AttributeBrushTool::chooseAttribute(Attribute attribute)
{
    m_wish.attribute = attribute;
    m_wish.value = specOf(m_wish).usual;
    refreshOptions();
}

void AttributeBrushTool::refreshOptions()
{
    if (!m_options)
        return;
    const ValueSpec spec = specOf(m_wish);
    m_attributes->setCurrentIndex(int(m_wish.attribute));
    m_modes->setItemText(0, tr("set to"));
    m_modes->setItemText(1, isRatio(m_wish.attribute) ? tr("multiply by") : tr("add"));
    m_modes->setCurrentIndex(m_wish.relative ? 1 : 0);
    m_value->setRange(spec.minimum, spec.maximum);
    m_value->setDisplayFactor(spec.factor);
    m_value->setUnit(spec.unit);
    m_value->setValue(m_wish.value);
    const bool currentColour = m_wish.attribute == Attribute::Colour && !m_wish.relative;
    m_value->setVisible(!currentColour);
    m_valueLabel->setText(currentColour ? tr("the current colour") : tr("Value"));
}

} // namespace suffuse
