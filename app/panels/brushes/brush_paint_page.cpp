#include "app/panels/brushes/brush_paint_page.h"

#include "app/widgets/look/section.h"
#include "app/widgets/numbers/quantity.h"
#include "model/brush/brush_width.h"
#include "model/paint/style_function.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace suffuse {

namespace {

Style usualStyle(StyleKind kind)
{
    if (kind == StyleKind::Feathering)
        return {kind, {1, 1.2f, 0}};
    if (kind == StyleKind::Edge)
        return {kind, {0.5f, 0.5f, 0.4f}};
    return {kind, {0.5f, 0.05f, 0}};
}

} // namespace

BrushPaintPage::BrushPaintPage(QWidget *parent) : BrushPage(parent)
{
    auto *row = new QHBoxLayout;
    m_style = new QComboBox(this);
    m_style->addItems(styleNames());
    m_style->setAccessibleName(tr("Style"));
    m_style->setToolTip(tr("How density becomes coverage."));
    m_mix = new QComboBox(this);
    m_mix->addItems(mixingNames());
    m_mix->setAccessibleName(tr("Mixing"));
    m_mix->setToolTip(tr("How the paint mixes with what lies below it: it covers, or pigments add up."));
    for (auto [name, box] : {std::pair(tr("Style"), m_style), std::pair(tr("Mixing"), m_mix)}) {
        auto *label = new QLabel(name, this);
        label->setBuddy(box);
        row->addWidget(label);
        row->addWidget(box, 1);
    }
    column().addLayout(row);
    connect(m_style, &QComboBox::activated, this, [this](int kind) {
        emit changed([=](Brush &b) {
            if (StyleKind(kind) != b.style.kind)
                b.style = usualStyle(StyleKind(kind));
        });
    });
    connect(m_mix, &QComboBox::activated, this, [this](int mode) {
        emit changed([=](Brush &b) { b.mix = mode == 0 ? Mix{} : Mix{MixMode::Beta, 0.6f}; });
    });
    QGridLayout *grid = addFieldGrid(column());
    for (std::size_t i = 0; i < m_xi.size(); ++i) {
        FieldSpec spec = xiSpec(StyleKind::Edge, int(i));
        // The name depends on the kind of style, so it is known only when a brush is shown.
        spec.name = QStringLiteral("ξ%1").arg(i + 1);
        spec.minimum = 0.001;
        spec.maximum = i < 2 ? 1000 : 1;
        spec.sliderMinimum = i < 2 ? 0.005 : 0.05;
        spec.sliderMaximum = i < 2 ? 10 : 1;
        m_xi[i] = bind(
            *grid, spec, [i](const Brush &b) { return double(b.style.xi[i]); },
            [i](Brush &b, double v) { b.style.xi[i] = float(v); });
    }
    m_beta = bind(
        *grid, specOf(Quantity::Beta), [](const Brush &b) { return double(b.mix.beta); },
        [](Brush &b, double v) { b.mix.beta = float(v); });
    addValues(*grid);
    column().addStretch();
}

void BrushPaintPage::addValues(QGridLayout &grid)
{
    bind(
        grid, specOf(Quantity::Size), [](const Brush &b) { return visibleWidth(b); },
        [](Brush &b, double v) { setVisibleWidth(b, v); });
    bind(
        grid, specOf(Quantity::Flow), [](const Brush &b) { return double(b.peak); },
        [](Brush &b, double v) { b.peak = float(v); });
    bind(
        grid, specOf(Quantity::Opacity), [](const Brush &b) { return double(b.colour.opacity); },
        [](Brush &b, double v) { b.colour.opacity = float(v); });
    bind(
        grid, specOf(Quantity::Granulation), [](const Brush &b) { return double(b.granulation); },
        [](Brush &b, double v) { b.granulation = float(v); });
    FieldSpec drying = specOf(Quantity::MaxAge);
    drying.toolTip = tr("How long the paint spreads; the size stays");
    drying.minimum = 0.001;
    bind(
        grid, drying, [](const Brush &b) { return double(b.maxAge); },
        [](Brush &b, double v) {
            const double spread = b.spread();
            b.maxAge = float(v);
            b.setSpread(spread);
        });
}

void BrushPaintPage::showBrush(const Brush &brush)
{
    BrushPage::showBrush(brush);
    m_style->setCurrentIndex(int(brush.style.kind));
    m_mix->setCurrentIndex(int(brush.mix.mode));
    for (std::size_t i = 0; i < m_xi.size(); ++i) {
        const FieldSpec spec = xiSpec(brush.style.kind, int(i));
        if (m_xi[i]->number()->accessibleName() != spec.name)
            m_xi[i]->rename(spec.name, spec.toolTip);
    }
    m_xi[2]->setVisible(xiCount(brush.style.kind) > 2);
    m_beta->setVisible(brush.mix.mode == MixMode::Beta);
}

} // namespace suffuse
