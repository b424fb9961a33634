// The pages of the brush's settings.
#include "app/dialogs/brush_dialog.h"
#include "app/editor.h"
#include "app/widgets/colour_swatch.h"
#include "app/widgets/response_editor.h"
#include "app/widgets/section.h"
#include "app/widgets/slider_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <numbers>

namespace suffuse {

namespace {

constexpr double degree = std::numbers::pi / 180;

} // namespace

void BrushDialog::addValues(QGridLayout &grid)
{
    bind(
        grid,
        {.name = tr("Size"),
         .toolTip = tr("How far the paint spreads, in units; sets the diffusion."),
         .unit = NumberField::canvasUnit(),
         .minimum = 1e-7,
         .maximum = 1e5,
         .sliderMinimum = 0.5,
         .sliderMaximum = 300,
         .logarithmic = true},
        [](const Brush &b) { return b.spread(); }, [](Brush &b, double v) { b.setSpread(v); });
    bind(
        grid,
        {.name = tr("Flow"),
         .toolTip = tr("Density in the middle of the stroke where no curve takes away"),
         .minimum = 0.001,
         .maximum = 1e6,
         .sliderMinimum = 0.1,
         .sliderMaximum = 10,
         .logarithmic = true},
        [](const Brush &b) { return double(b.peak); }, [](Brush &b, double v) { b.peak = float(v); });
    bind(
        grid,
        {.name = tr("Opacity"),
         .toolTip = tr("How much the paint covers at full density"),
         .unit = QStringLiteral(" %"),
         .factor = 100,
         .step = 0.01},
        [](const Brush &b) { return double(b.colour.opacity); },
        [](Brush &b, double v) { b.colour.opacity = float(v); });
    bind(
        grid, {.name = tr("Granulation ω"), .toolTip = tr("1 hides the paper's grain, 0 shows it fully")},
        [](const Brush &b) { return double(b.granulation); }, [](Brush &b, double v) { b.granulation = float(v); });
    bind(
        grid,
        {.name = tr("Drying time"),
         .toolTip = tr("How long the paint spreads; the size stays"),
         .unit = NumberField::secondsUnit(),
         .minimum = 0.001,
         .maximum = 1e6,
         .sliderMinimum = 0.05,
         .sliderMaximum = 20,
         .logarithmic = true},
        [](const Brush &b) { return double(b.maxAge); },
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
    m_style->addItems({tr("Uniform"), tr("Feathering"), tr("Edge darkening")});
    m_style->setAccessibleName(tr("Style"));
    m_style->setToolTip(tr("How density becomes opacity"));
    m_mix = new QComboBox(page);
    m_mix->addItems({tr("Covers (alpha)"), tr("Mixes as pigment (beta)")});
    m_mix->setAccessibleName(tr("Mixing"));
    m_mix->setToolTip(tr("How the paint mixes with what lies below"));
    row->addWidget(m_style, 1);
    row->addWidget(m_mix, 1);
    column->addLayout(row);
    connect(m_style, &QComboBox::activated, this, &BrushDialog::chooseStyle);
    connect(m_mix, &QComboBox::activated, this, [this](int mode) {
        change([=](Brush &b) { b.mix = mode == 0 ? Mix{} : Mix{MixMode::Beta, 0.6f}; });
    });
    QGridLayout *grid = addFieldGrid(*column);
    const auto xi = [&](int i, const QString &name, const QString &tip, double most) {
        bind(
            *grid,
            {.name = name,
             .toolTip = tip,
             .minimum = 0.001,
             .maximum = 1000,
             .sliderMinimum = 0.005,
             .sliderMaximum = most,
             .logarithmic = true},
            [i](const Brush &b) { return double(b.style.xi[std::size_t(i)]); },
            [i](Brush &b, double v) { b.style.xi[std::size_t(i)] = float(v); });
    };
    xi(0, tr("ξ1"), tr("Density at which the paint begins to cover"), 10);
    xi(1, tr("ξ2"), tr("Uniform: softness of the edge; feathering: exponent; edge darkening: width of the rim"), 10);
    bind(
        *grid,
        {.name = tr("ξ3"), .toolTip = tr("Opacity inside the dark edge"), .minimum = 0.001, .sliderMinimum = 0.001},
        [](const Brush &b) { return double(b.style.xi[2]); }, [](Brush &b, double v) { b.style.xi[2] = float(v); });
    m_xi3 = m_bound.back().field;
    bind(
        *grid, {.name = tr("β"), .toolTip = tr("How much of what lies below shows through the pigment")},
        [](const Brush &b) { return double(b.mix.beta); }, [](Brush &b, double v) { b.mix.beta = float(v); });
    m_beta = m_bound.back().field;
    addValues(*grid);
    column->addStretch();
    return page;
}

void BrushDialog::makeTable(QWidget *page)
{
    m_curves = new QTableWidget(brushQuantities, brushInputs, page);
    m_curves->setVerticalHeaderLabels(
        {tr("Size"), tr("Flow"), tr("Granulation"), tr("Opacity"), tr("Drying time"), tr("Second colour")});
    m_curves->setHorizontalHeaderLabels(
        {tr("Pressure"), tr("Tilt"), tr("Speed"), tr("Distance"), tr("By stroke"), tr("Drift")});
    m_curves->setAccessibleName(tr("Curves"));
    m_curves->setToolTip(tr("What changes with what: a tick switches a curve on, a click shows it below"));
    m_curves->viewport()->setBackgroundRole(QPalette::Button); // empty boxes show on it in the dark, too
    m_curves->setSelectionMode(QAbstractItemView::SingleSelection);
    m_curves->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_curves->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
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
             .unit = unit,
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
    auto *take = new QPushButton(tr("Take the current colour"), page);
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
        bind(
            *grid,
            {.name = name,
             .toolTip = tip,
             .unit = QStringLiteral(" %"),
             .sliderMaximum = 0.5,
             .factor = 100,
             .step = 0.01},
            [member](const Brush &b) { return double(b.jitter.*member); },
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
    column.addWidget(m_stabiliser);
    connect(m_stabiliser, &QComboBox::activated, this,
            [this](int kind) { change([=](Brush &b) { b.stabiliser.kind = Stabiliser::Kind(kind); }); });
    QGridLayout *hand = addFieldGrid(column);
    bind(
        *hand,
        {.name = tr("Strength"),
         .toolTip = tr("How far the stroke lags behind"),
         .unit = QStringLiteral(" %"),
         .factor = 100,
         .step = 0.05},
        [](const Brush &b) { return double(b.stabiliser.strength); },
        [](Brush &b, double v) { b.stabiliser.strength = float(v); });
    m_strength = m_bound.back().field;
    bind(
        *hand,
        {.name = tr("String"),
         .toolTip = tr("Its length on the screen"),
         .unit = QStringLiteral(" px"),
         .maximum = 1000,
         .sliderMaximum = 200,
         .step = 5},
        [](const Brush &b) { return double(b.stabiliser.length); },
        [](Brush &b, double v) { b.stabiliser.length = float(v); });
    m_string = m_bound.back().field;
    bind(
        *hand,
        {.name = tr("Sampling"),
         .toolTip = tr("Time between the points that the curve is fitted through"),
         .unit = QStringLiteral(" ms"),
         .minimum = 0.002,
         .maximum = 0.2,
         .sliderMinimum = 0.004,
         .sliderMaximum = 0.1,
         .logarithmic = true,
         .factor = 1000,
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
    bind(
        *tip,
        {.name = tr("Ratio"),
         .toolTip = tr("How much faster the paint spreads along the tip's angle than across"),
         .minimum = 0.01,
         .maximum = 100,
         .sliderMinimum = 0.05,
         .sliderMaximum = 20,
         .logarithmic = true,
         .defaultValue = 1},
        [](const Brush &b) { return double(b.tip.ratio); }, [](Brush &b, double v) { b.tip.ratio = float(v); });
    bind(
        *tip,
        {.name = tr("Angle"),
         .toolTip = tr("Of the tip, against the path or the canvas"),
         .unit = QStringLiteral("°"),
         .minimum = -180 * degree,
         .maximum = 180 * degree,
         .sliderMinimum = -90 * degree,
         .sliderMaximum = 90 * degree,
         .factor = 1 / degree,
         .step = degree},
        [](const Brush &b) { return double(b.tip.angle); }, [](Brush &b, double v) { b.tip.angle = float(v); });
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
            {.name = name, .toolTip = hint, .unit = tr(" sizes"), .maximum = 1000, .sliderMaximum = 20, .step = 0.5},
            [member](const Brush &b) { return double(b.taper.*member); },
            [member](Brush &b, double v) { b.taper.*member = float(v); });
    };
    end(tr("Taper in"), tr("Length on which the stroke grows from its tip"), &Taper::in);
    end(tr("Taper out"), tr("Length on which it runs out when the pen lifts"), &Taper::out);
    bind(
        *taper,
        {.name = tr("Tip size"),
         .toolTip = tr("Size at the very end"),
         .unit = QStringLiteral(" %"),
         .factor = 100,
         .step = 0.01},
        [](const Brush &b) { return double(b.taper.tip); }, [](Brush &b, double v) { b.taper.tip = float(v); });
    addHand(*column, page);
    column->addStretch();
    return page;
}

} // namespace suffuse
