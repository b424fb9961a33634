#include "app/panels/brushes/brush_colour_page.h"

#include "app/widgets/colour/colour_swatch.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/quantity.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace suffuse {

BrushColourPage::BrushColourPage(QWidget *parent) : BrushPage(parent)
{
    auto *row = new QHBoxLayout;
    m_second = new ColourSwatch(this);
    m_second->setAccessibleName(tr("Second colour"));
    m_second->setAccessibleDescription(tr("The row Second colour of the curves says when it comes through."));
    auto *take = new QPushButton(tr("&Take the Current Colour"), this);
    take->setToolTip(tr("Makes the current colour the second one"));
    row->addWidget(new QLabel(tr("Second colour"), this));
    row->addWidget(m_second);
    row->addWidget(take);
    row->addStretch();
    column().addLayout(row);
    column().addWidget(quietLabel(tr("The row Second colour of the curves says when it comes through."), this));
    connect(take, &QPushButton::clicked, this, [this] { emit changed([](Brush &b) { b.secondColour = b.colour; }); });
    column().addSpacing(8);
    column().addWidget(sectionTitle(tr("Strays from the colour by"), this));
    QGridLayout *grid = addFieldGrid(column());
    const auto stray = [&](const QString &name, const QString &tip, float ColourJitter::*member) {
        FieldSpec spec = shareSpec(name, tip, 0);
        spec.sliderMaximum = 0.5;
        spec.sliderStep = 0.001;
        bind(
            *grid, spec, [member](const Brush &b) { return double(b.jitter.*member); },
            [member](Brush &b, double v) { b.jitter.*member = float(v); });
    };
    stray(tr("Red"), tr("At most so much redder or less red"), &ColourJitter::red);
    stray(tr("Yellow"), tr("At most so much more or less yellow"), &ColourJitter::yellow);
    stray(tr("Blue"), tr("At most so much bluer or less blue"), &ColourJitter::blue);
    stray(tr("Lightness"), tr("At most so much lighter or darker"), &ColourJitter::lightness);
    m_jitterAlong = new QCheckBox(tr("Drifts along the stroke"), this);
    m_jitterAlong->setToolTip(tr("Else each stroke has one colour"));
    column().addWidget(m_jitterAlong);
    connect(m_jitterAlong, &QCheckBox::clicked, this,
            [this](bool on) { emit changed([=](Brush &b) { b.jitter.along = on; }); });
    column().addStretch();
}

void BrushColourPage::showBrush(const Brush &brush)
{
    BrushPage::showBrush(brush);
    m_jitterAlong->setChecked(brush.jitter.along);
    m_second->setColour(brush.secondColour);
}

} // namespace suffuse
