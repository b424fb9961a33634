#include "app/panels/brushes/brush_curves_page.h"

#include "app/widgets/curves/response_editor.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/quantity.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QTableWidget>
#include <QVBoxLayout>

namespace suffuse {

namespace {

/// The curve that a switch begins with. For haste, distance and slant it takes away, for the others it adds.
ResponseCurve usualCurve(BrushInput input)
{
    switch (input) {
    case BrushInput::Pressure:
        return {{{0, 0.2f}, {1, 1}}};
    case BrushInput::StrokeRandom:
    case BrushInput::Drift:
        return {{{0, 0.5f}, {1, 1}}};
    default:
        return {{{0, 1}, {1, 0.5f}}};
    }
}

} // namespace

void BrushCurvesPage::makeTable()
{
    m_curves = new QTableWidget(brushQuantities, brushInputs, this);
    QStringList rows;
    for (const Quantity quantity :
         {Quantity::Size, Quantity::Flow, Quantity::Granulation, Quantity::Opacity, Quantity::MaxAge})
        rows << specOf(quantity).name;
    m_curves->setVerticalHeaderLabels(rows << tr("Second colour"));
    m_curves->setHorizontalHeaderLabels(
        {tr("Pressure"), tr("Tilt"), tr("Speed"), tr("Distance"), tr("By stroke"), tr("Drift")});
    m_curves->setAccessibleName(tr("Curves"));
    m_curves->setToolTip(tr("What changes with what: a tick switches a curve on, a click shows it below"));
    // Empty boxes are seen on this ground in dark themes, too.
    m_curves->viewport()->setBackgroundRole(QPalette::Button);
    m_curves->setSelectionMode(QAbstractItemView::SingleSelection);
    m_curves->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_curves->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    int widest = 0; // The columns have one width, which cuts no name.
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

BrushCurvesPage::BrushCurvesPage(QWidget *parent) : BrushPage(parent)
{
    makeTable();
    column().addWidget(m_curves);
    m_curve = new ResponseEditor(this);
    m_curve->setAccessibleName(tr("Curve"));
    m_curve->setToolTip(tr("Drag points; click for another one, drag it out to take it away"));
    column().addWidget(m_curve, 1);
    m_curves->setCurrentCell(int(BrushQuantity::Density), int(BrushInput::Pressure));
    connect(m_curves, &QTableWidget::itemChanged, this, &BrushCurvesPage::cellChanged);
    connect(m_curves, &QTableWidget::currentCellChanged, this, &BrushCurvesPage::showCell);
    const auto takeCurve = [this] {
        const auto quantity = BrushQuantity(m_curves->currentRow());
        const auto input = BrushInput(m_curves->currentColumn());
        emit changed([&](Brush &b) { b.setCurve(quantity, input, m_curve->curve()); });
    };
    connect(m_curve, &ResponseEditor::edited, this, takeCurve);
    connect(m_curve, &ResponseEditor::givenUp, this, takeCurve);
    QGridLayout *grid = addFieldGrid(column());
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
}

void BrushCurvesPage::cellChanged(QTableWidgetItem *item)
{
    const auto quantity = BrushQuantity(item->row());
    const auto input = BrushInput(item->column());
    const bool on = item->checkState() == Qt::Checked;
    if (on == (m_brush.curve(quantity, input) != nullptr))
        return;
    m_curves->setCurrentItem(item);
    emit changed(
        [=](Brush &b) { on ? b.setCurve(quantity, input, usualCurve(input)) : b.removeCurve(quantity, input); });
}

void BrushCurvesPage::showCell()
{
    const int q = m_curves->currentRow(), i = m_curves->currentColumn();
    const ResponseCurve *curve = m_brush.curve(BrushQuantity(q), BrushInput(i));
    m_curve->setEnabled(curve != nullptr);
    // Curves multiply ω, but the grain is shown, which grows as ω falls. So the curve is drawn upside down.
    m_curve->setUpsideDown(BrushQuantity(q) == BrushQuantity::Granulation);
    m_curve->setTexts(m_curves->verticalHeaderItem(q)->text(), {}, m_curves->horizontalHeaderItem(i)->text());
    m_curve->setCurve(curve ? *curve : ResponseCurve{{{0, 1}, {1, 1}}});
}

void BrushCurvesPage::showBrush(const Brush &brush)
{
    BrushPage::showBrush(brush);
    m_brush = brush;
    const QSignalBlocker blocker(m_curves);
    for (int q = 0; q < brushQuantities; ++q)
        for (int i = 0; i < brushInputs; ++i)
            m_curves->item(q, i)->setCheckState(brush.curve(BrushQuantity(q), BrushInput(i)) ? Qt::Checked
                                                                                             : Qt::Unchecked);
    showCell();
}

} // namespace suffuse
