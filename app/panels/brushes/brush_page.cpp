#include "app/panels/brushes/brush_page.h"

#include "app/widgets/numbers/slider_field.h"

#include <QGridLayout>
#include <QVBoxLayout>

namespace suffuse {

BrushPage::BrushPage(QWidget *parent) : QWidget(parent), m_column(new QVBoxLayout(this))
{
    m_column->setContentsMargins(12, 12, 12, 12);
    m_column->setSpacing(8);
}

SliderField *BrushPage::bind(QGridLayout &grid, const FieldSpec &spec, const Get &get, const Set &set)
{
    auto *field = new SliderField(spec, grid, grid.rowCount(), this);
    m_bound.push_back({field, spec.name, get});
    connect(field, &SliderField::edited, this,
            [=, this](double value) { emit changed([&](Brush &b) { set(b, value); }); });
    connect(field, &SliderField::refused, this, &BrushPage::refused);
    return field;
}

SliderField *BrushPage::field(const QString &name) const
{
    for (const Bound &b : m_bound)
        if (b.name == name)
            return b.field;
    return nullptr;
}

void BrushPage::showBrush(const Brush &brush)
{
    for (const Bound &b : m_bound)
        b.field->setValue(b.get(brush));
}

} // namespace suffuse
