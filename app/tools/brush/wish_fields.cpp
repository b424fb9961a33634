#include "app/tools/brush/wish_fields.h"

#include "app/tools/tool_fields.h"
#include "app/widgets/numbers/quantity.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>

namespace suffuse {

namespace {

Quantity quantityOf(Attribute attribute)
{
    switch (attribute) {
    case Attribute::Diffusion:
        return Quantity::Diffusion;
    case Attribute::Density:
        return Quantity::Density;
    case Attribute::Granulation:
        return Quantity::Granulation;
    case Attribute::MaxAge:
        return Quantity::MaxAge;
    default:
        return Quantity::Opacity; // Differences of a colour are shares, as opacities are.
    }
}

QString attributeNameOf(Attribute attribute)
{
    return attribute == Attribute::Colour ? WishFields::tr("Colour") : specOf(quantityOf(attribute)).name;
}

/// What the value field holds for a wish; its default is the value when the quantity is chosen.
FieldSpec specOf(const AttributeWish &wish)
{
    FieldSpec spec = specOf(quantityOf(wish.attribute));
    const bool isGrain = wish.attribute == Attribute::Granulation;
    if (!wish.relative) {
        if (isGrain)
            spec.defaultValue = spec.display.toValue(100); // The default is all of it, since most segments have none.
        return spec;
    }
    spec.minimum = isRatio(wish.attribute) ? 0.001 : -1;
    spec.maximum = isRatio(wish.attribute) ? 1000 : 1;
    spec.display = isRatio(wish.attribute) ? Display{.unit = QStringLiteral(" ×")}
                   : isGrain               ? grainDifferenceDisplay()
                                           : shareDisplay();
    spec.defaultValue = isRatio(wish.attribute) ? 1.5 : spec.display.toValue(25);
    return spec;
}

} // namespace

WishFields::WishFields(QHBoxLayout &row) : QObject(row.parentWidget())
{
    QWidget *parent = row.parentWidget();
    m_attributes = new QComboBox(parent);
    for (const Attribute attribute : allAttributes)
        m_attributes->addItem(attributeNameOf(attribute));
    m_attributes->setToolTip(tr("What is painted onto the segments"));
    m_attributes->setAccessibleName(m_attributes->toolTip());
    row.addWidget(m_attributes);
    m_modes = new QComboBox(parent);
    m_modes->addItems({QString(), QString()});
    m_modes->setToolTip(tr("Towards a value, or from the value that each segment has"));
    m_modes->setAccessibleName(m_modes->toolTip());
    row.addWidget(m_modes);
    m_value = addNumber(row, tr("Value"), tr("What a segment has when it got all of it"), [this](double value) {
        m_wish.value = value;
        emit wishChanged(m_wish);
    });
    m_valueLabel = parent->findChild<QLabel *>();
    connect(m_attributes, &QComboBox::activated, this,
            [this](int i) { choose(allAttributes[std::size_t(i)], m_wish.relative); });
    connect(m_modes, &QComboBox::activated, this, [this](int i) {
        if (m_wish.relative != (i == 1))
            choose(m_wish.attribute, i == 1);
    });
}

void WishFields::choose(Attribute attribute, bool relative)
{
    m_wish.attribute = attribute;
    m_wish.relative = relative;
    m_wish.value = specOf(m_wish).defaultValue;
    show(m_wish);
    emit wishChanged(m_wish);
}

void WishFields::show(const AttributeWish &wish)
{
    m_wish = wish;
    const FieldSpec spec = specOf(m_wish);
    m_attributes->setCurrentIndex(int(m_wish.attribute));
    m_modes->setItemText(0, tr("set to"));
    m_modes->setItemText(1, isRatio(m_wish.attribute) ? tr("multiply by") : tr("add"));
    m_modes->setCurrentIndex(m_wish.relative ? 1 : 0);
    m_value->setRange(spec.minimum, spec.maximum);
    m_value->setDisplay(spec.display);
    m_value->setStep(m_wish.relative && isRatio(m_wish.attribute) ? 0 : spec.step);
    m_value->setValue(m_wish.value);
    const bool currentColour = m_wish.attribute == Attribute::Colour && !m_wish.relative;
    m_value->setVisible(!currentColour);
    m_valueLabel->setText(currentColour ? tr("the current colour") : tr("Value"));
}

} // namespace suffuse
