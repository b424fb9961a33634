#include "app/panels/brushes/brush_hand_page.h"

#include "app/widgets/look/section.h"
#include "app/widgets/numbers/quantity.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace suffuse {

BrushHandPage::BrushHandPage(QWidget *parent) : BrushPage(parent)
{
    column().addWidget(sectionTitle(tr("Tip"), this));
    QGridLayout *tip = addFieldGrid(column());
    FieldSpec ratio = specOf(Quantity::Anisotropy);
    ratio.minimum = 0.01;
    ratio.maximum = 100;
    bind(
        *tip, ratio, [](const Brush &b) { return double(b.tip.ratio); },
        [](Brush &b, double v) { b.tip.ratio = float(v); });
    FieldSpec angle = specOf(Quantity::Angle);
    angle.toolTip = tr("Of the tip, against the path or the canvas");
    angle.minimum = angle.display.toValue(-180);
    angle.maximum = angle.display.toValue(180);
    bind(
        *tip, angle, [](const Brush &b) { return double(b.tip.angle); },
        [](Brush &b, double v) { b.tip.angle = float(v); });
    m_followsPath = new QCheckBox(tr("Turns with the path"), this);
    m_followsPath->setToolTip(tr("Else it keeps its angle on the canvas, as a broad nib does"));
    column().addWidget(m_followsPath);
    connect(m_followsPath, &QCheckBox::clicked, this,
            [this](bool on) { emit changed([=](Brush &b) { b.tip.followsPath = on; }); });
    column().addWidget(sectionTitle(tr("Ends"), this));
    QGridLayout *taper = addFieldGrid(column());
    const auto end = [&](const QString &name, const QString &hint, float Taper::*member) {
        bind(
            *taper,
            {.name = name,
             .toolTip = hint,
             .display = {.unit = tr(" sizes")},
             .maximum = 1000,
             .sliderMaximum = 20,
             .step = 0.5},
            [member](const Brush &b) { return double(b.taper.*member); },
            [member](Brush &b, double v) { b.taper.*member = float(v); });
    };
    end(tr("Taper in"), tr("Length on which the stroke grows from its tip"), &Taper::in);
    end(tr("Taper out"), tr("Length on which it runs out when the pen lifts"), &Taper::out);
    bind(
        *taper, shareSpec(tr("Tip size"), tr("Size at the very end"), 0),
        [](const Brush &b) { return double(b.taper.tip); }, [](Brush &b, double v) { b.taper.tip = float(v); });
    addHand();
    column().addStretch();
}

void BrushHandPage::addHand()
{
    column().addWidget(sectionTitle(tr("Hand"), this));
    m_stabiliser = new QComboBox(this);
    m_stabiliser->addItems(smoothingNames());
    m_stabiliser->setAccessibleName(tr("Smoothing"));
    m_stabiliser->setToolTip(tr("Steadies the hand: the stroke follows the pen softly, or is pulled on a string"));
    auto *row = new QHBoxLayout;
    auto *label = new QLabel(tr("Smoothing"), this);
    label->setBuddy(m_stabiliser);
    row->addWidget(label);
    row->addWidget(m_stabiliser, 1);
    column().addLayout(row);
    connect(m_stabiliser, &QComboBox::activated, this,
            [this](int kind) { emit changed([=](Brush &b) { b.stabiliser.kind = Stabiliser::Kind(kind); }); });
    QGridLayout *hand = addFieldGrid(column());
    m_strength = bind(
        *hand, specOf(Quantity::SmoothingStrength), [](const Brush &b) { return double(b.stabiliser.strength); },
        [](Brush &b, double v) { b.stabiliser.strength = float(v); });
    m_string = bind(
        *hand, specOf(Quantity::SmoothingString), [](const Brush &b) { return double(b.stabiliser.length); },
        [](Brush &b, double v) { b.stabiliser.length = float(v); });
    bind(
        *hand,
        {.name = tr("Sampling"),
         .toolTip = tr("Time between the points that the curve is fitted through"),
         .display = {.unit = QStringLiteral(" ms"), .factor = 1000},
         .minimum = 0.002,
         .maximum = 0.2,
         .sliderMinimum = 0.004,
         .sliderMaximum = 0.1,
         .logarithmic = true,
         .defaultValue = toSeconds(samplingInterval)},
        [](const Brush &b) { return toSeconds(b.interval); },
        [](Brush &b, double v) { b.interval = toMicroseconds(v); });
}

void BrushHandPage::showBrush(const Brush &brush)
{
    BrushPage::showBrush(brush);
    m_stabiliser->setCurrentIndex(int(brush.stabiliser.kind));
    m_strength->setVisible(brush.stabiliser.kind == Stabiliser::Kind::Weighted);
    m_string->setVisible(brush.stabiliser.kind == Stabiliser::Kind::String);
    m_followsPath->setChecked(brush.tip.followsPath);
}

} // namespace suffuse
