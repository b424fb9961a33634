// The pages of the brush's settings.
#include "app/panels/brushes/brush_dialog.h"
#include "app/session/editor.h"
#include "app/widgets/colour_swatch.h"
#include "app/widgets/quantity.h"
#include "app/widgets/response_editor.h"
#include "app/widgets/section.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace suffuse {

void BrushDialog::addValues(QGridLayout &grid)
{
    bind(
        grid, specOf(Quantity::Size), [](const Brush &b) { return b.spread(); },
        [](Brush &b, double v) { b.setSpread(v); });
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

QWidget *BrushDialog::makePaintPage()
{
    QVBoxLayout *column = nullptr;
    QWidget *page = makePage(column);
    auto *row = new QHBoxLayout;
    m_style = new QComboBox(page);
    m_style->addItems(styleNames());
    m_style->setAccessibleName(tr("Style"));
    m_style->setToolTip(tr("How density becomes coverage."));
    m_mix = new QComboBox(page);
    m_mix->addItems(mixingNames());
    m_mix->setAccessibleName(tr("Mixing"));
    m_mix->setToolTip(tr("How the paint mixes with what lies below it: it covers, or pigments add up."));
    for (auto [name, box] : {std::pair(tr("Style"), m_style), std::pair(tr("Mixing"), m_mix)}) {
        auto *label = new QLabel(name, page);
        label->setBuddy(box);
        row->addWidget(label);
        row->addWidget(box, 1);
    }
    column->addLayout(row);
    connect(m_style, &QComboBox::activated, this, &BrushDialog::chooseStyle);
    connect(m_mix, &QComboBox::activated, this, [this](int mode) {
        change([=](Brush &b) { b.mix = mode == 0 ? Mix{} : Mix{MixMode::Beta, 0.6f}; });
    });
    QGridLayout *grid = addFieldGrid(*column);
    for (std::size_t i = 0; i < m_xi.size(); ++i) {
        FieldSpec spec = xiSpec(StyleKind::Edge, int(i));
        spec.name = QStringLiteral("ξ%1").arg(i + 1); // until refresh() has the name that it has in this kind of style
        spec.minimum = 0.001;
        spec.maximum = i < 2 ? 1000 : 1;
        spec.sliderMinimum = i < 2 ? 0.005 : 0.05;
        spec.sliderMaximum = i < 2 ? 10 : 1;
        bind(
            *grid, spec, [i](const Brush &b) { return double(b.style.xi[i]); },
            [i](Brush &b, double v) { b.style.xi[i] = float(v); });
        m_xi[i] = m_bound.back().field;
    }
    bind(
        *grid, specOf(Quantity::Beta), [](const Brush &b) { return double(b.mix.beta); },
        [](Brush &b, double v) { b.mix.beta = float(v); });
    m_beta = m_bound.back().field;
    addValues(*grid);
    column->addStretch();
    return page;
}

void BrushDialog::makeTable(QWidget *page)
{
    m_curves = new QTableWidget(brushQuantities, brushInputs, page);
    QStringList rows;
    for (const Quantity quantity :
         {Quantity::Size, Quantity::Flow, Quantity::Granulation, Quantity::Opacity, Quantity::MaxAge})
        rows << specOf(quantity).name;
    m_curves->setVerticalHeaderLabels(rows << tr("Second colour"));
    m_curves->setHorizontalHeaderLabels(
        {tr("Pressure"), tr("Tilt"), tr("Speed"), tr("Distance"), tr("By stroke"), tr("Drift")});
    m_curves->setAccessibleName(tr("Curves"));
    m_curves->setToolTip(tr("What changes with what: a tick switches a curve on, a click shows it below"));
    m_curves->viewport()->setBackgroundRole(QPalette::Button); // empty boxes show on it in the dark, too
    m_curves->setSelectionMode(QAbstractItemView::SingleSelection);
    m_curves->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_curves->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    int widest = 0; // the columns are alike, and none cuts its name
    for (int i = 0; i < brushInputs; ++i)
        widest = std::max(widest, m_curves->horizontalHeader()->sectionSizeHint(i));
    m_curves->horizontalHeader()->setMinimumSectionSize(widest);
    m_curves->setMinimumWidth(brushInputs * (widest + 4) + m_curves->verticalHeader()->sizeHint().width() +
                              2 * m_curves->frameWidth());
    m_curves->horizontalHeader()->setSectionsClickable(false);
    m_curves->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    m_curves->verticalHeader()->setSectionsClickable(false);
    for (int q = 0; q < brushQuantities; ++q)
        for (int i = 0; i < brushInputs; ++i) {
            auto *item = new QTableWidgetItem;
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
            item->setCheckState(Qt::Unchecked);
            m_curves->setItem(q, i, item);
        }
    m_curves->setFixedHeight(m_curves->horizontalHeader()->sizeHint().height() +
                             brushQuantities * m_curves->verticalHeader()->defaultSectionSize() + 4);
}

QWidget *BrushDialog::makeCurvesPage()
{
    QVBoxLayout *column = nullptr;
    QWidget *page = makePage(column);
    makeTable(page);
    column->addWidget(m_curves);
    m_curve = new ResponseEditor(page);
    m_curve->setAccessibleName(tr("Curve"));
    m_curve->setToolTip(tr("Drag points; click for another one, drag it out to take it away"));
    column->addWidget(m_curve, 1);
    m_curves->setCurrentCell(int(BrushQuantity::Density), int(BrushInput::Pressure));
    connect(m_curves, &QTableWidget::itemChanged, this, &BrushDialog::cellChanged);
    connect(m_curves, &QTableWidget::currentCellChanged, this, &BrushDialog::showCell);
    connect(m_curve, &ResponseEditor::edited, this, [this] {
        const auto quantity = BrushQuantity(m_curves->currentRow());
        const auto input = BrushInput(m_curves->currentColumn());
        change([&](Brush &b) { b.setCurve(quantity, input, m_curve->curve()); });
    });
    QGridLayout *grid = addFieldGrid(*column);
    const auto scale = [&](const QString &name, const QString &tip, const QString &unit, float Brush::*member) {
        bind(
            *grid,
            {.name = name,
             .toolTip = tip,
             .display = {.unit = unit},
             .minimum = 0.01,
             .maximum = 1e6,
             .sliderMinimum = 0.5,
             .sliderMaximum = 500,
             .logarithmic = true},
            [member](const Brush &b) { return double(b.*member); },
            [member](Brush &b, double v) { b.*member = float(v); });
    };
    scale(tr("Full speed"), tr("Speed at the right end of its curves, in sizes a second"), tr(" sizes/s"),
          &Brush::fullSpeed);
    scale(tr("Full distance"), tr("Distance at the right end of its curves, in sizes"), tr(" sizes"),
          &Brush::fullDistance);
    scale(tr("Drift"), tr("Way on which what drifts becomes another, in sizes"), tr(" sizes"), &Brush::driftLength);
    return page;
}

QWidget *BrushDialog::makeColourPage()
{
    QVBoxLayout *column = nullptr;
    QWidget *page = makePage(column);
    auto *row = new QHBoxLayout;
    m_second = new ColourSwatch(page);
    m_second->setAccessibleName(tr("Second colour"));
    auto *take = new QPushButton(tr("&Take the Current Colour"), page);
    take->setToolTip(tr("Makes the current colour the second one"));
    row->addWidget(new QLabel(tr("Second colour"), page));
    row->addWidget(m_second);
    row->addWidget(take);
    row->addStretch();
    column->addLayout(row);
    column->addWidget(quietLabel(tr("The row Second colour of the curves says when it comes through."), page));
    connect(take, &QPushButton::clicked, this, [this] { change([](Brush &b) { b.secondColour = b.colour; }); });
    column->addSpacing(8);
    column->addWidget(sectionTitle(tr("Strays from the colour by"), page));
    QGridLayout *grid = addFieldGrid(*column);
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
    m_jitterAlong = new QCheckBox(tr("Drifts along the stroke"), page);
    m_jitterAlong->setToolTip(tr("Else each stroke has one colour"));
    column->addWidget(m_jitterAlong);
    connect(m_jitterAlong, &QCheckBox::clicked, this,
            [this](bool on) { change([=](Brush &b) { b.jitter.along = on; }); });
    column->addStretch();
    return page;
}

void BrushDialog::addHand(QVBoxLayout &column, QWidget *page)
{
    column.addWidget(sectionTitle(tr("Hand"), page));
    m_stabiliser = new QComboBox(page);
    m_stabiliser->addItems({tr("No smoothing"), tr("Weighted"), tr("Pulled string")});
    m_stabiliser->setAccessibleName(tr("Smoothing"));
    m_stabiliser->setToolTip(tr("Steadies the hand: the stroke follows the pen softly, or is pulled on a string"));
    auto *row = new QHBoxLayout;
    auto *label = new QLabel(tr("Smoothing"), page);
    label->setBuddy(m_stabiliser);
    row->addWidget(label);
    row->addWidget(m_stabiliser, 1);
    column.addLayout(row);
    connect(m_stabiliser, &QComboBox::activated, this,
            [this](int kind) { change([=](Brush &b) { b.stabiliser.kind = Stabiliser::Kind(kind); }); });
    QGridLayout *hand = addFieldGrid(column);
    bind(
        *hand, specOf(Quantity::SmoothingStrength), [](const Brush &b) { return double(b.stabiliser.strength); },
        [](Brush &b, double v) { b.stabiliser.strength = float(v); });
    m_strength = m_bound.back().field;
    bind(
        *hand, specOf(Quantity::SmoothingString), [](const Brush &b) { return double(b.stabiliser.length); },
        [](Brush &b, double v) { b.stabiliser.length = float(v); });
    m_string = m_bound.back().field;
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

QWidget *BrushDialog::makeHandPage()
{
    QVBoxLayout *column = nullptr;
    QWidget *page = makePage(column);
    column->addWidget(sectionTitle(tr("Tip"), page));
    QGridLayout *tip = addFieldGrid(*column);
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
    m_followsPath = new QCheckBox(tr("Turns with the path"), page);
    m_followsPath->setToolTip(tr("Else it keeps its angle on the canvas, as a broad nib does"));
    column->addWidget(m_followsPath);
    connect(m_followsPath, &QCheckBox::clicked, this,
            [this](bool on) { change([=](Brush &b) { b.tip.followsPath = on; }); });
    column->addWidget(sectionTitle(tr("Ends"), page));
    QGridLayout *taper = addFieldGrid(*column);
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
    addHand(*column, page);
    column->addStretch();
    return page;
}

} // namespace suffuse
