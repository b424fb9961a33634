#include "app/panels/inspector/figures/figures_section.h"

#include "app/panels/inspector/figures/cross_section_plot.h"
#include "app/panels/inspector/figures/density_plot.h"
#include "app/panels/inspector/figures/figure_warnings.h"
#include "app/session/editor.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/length_units.h"
#include "app/widgets/numbers/number_field.h"

#include <QGridLayout>
#include <QLocale>
#include <QVBoxLayout>

#include <algorithm>

namespace suffuse {

namespace {

constexpr int figuresLaterMs = 40;

/// A range as "3.2 – 5.6", or one number as "3.2".
QString rangeText(double low, double high, const QString &unit)
{
    const QLocale locale;
    const QString from = locale.toString(low, 'g', 3), to = locale.toString(high, 'g', 3);
    return (from == to ? from : from + QStringLiteral(" – ") + to) + unit;
}

QString shareRange(const Extent &share)
{
    const QString from = shareDisplay().text(share.least), to = shareDisplay().text(share.most);
    return from == to ? from : from + QStringLiteral(" – ") + to;
}

/// Where the plot cuts: a stroke that is selected whole in the middle of its paint, a run of segments at the first that
/// lays paint, an erasure at its first segment.
SegmentRef placeOfCut(const Inspected &inspected, bool whole)
{
    const auto &segments = inspected.segments;
    const auto ofFirst = [&](const InspectedSegment &s) { return s.stroke == segments.front().stroke; };
    const auto paints = [](const InspectedSegment &s) { return !s.segment->takesPaint(); };
    if (whole)
        return inspected.refs[std::size_t(std::ranges::count_if(segments, ofFirst)) / 2];
    const auto at = std::ranges::find_if(segments, paints);
    return inspected.refs[at == segments.end() ? 0 : std::size_t(at - segments.begin())];
}

} // namespace

FiguresSection::FiguresSection(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    m_plot = new DensityPlot(this);
    m_plot->setAccessibleName(tr("Density function"));
    m_plot->setToolTip(tr("How density becomes coverage. The mark is the peak density of the selected segments."));
    column->addWidget(m_plot);
    m_cut = new CrossSectionPlot(this);
    m_cut->setAccessibleName(tr("Cross-section"));
    m_cut->setToolTip(tr("The cut through the stroke at the first selected segment, at the moment shown: coverage, on "
                         "the colour that it has on the background."));
    column->addWidget(m_cut);
    addFigures(*column);
    m_warnings = new HintLabel(this);
    m_warnings->setMargin(0);
    m_warnings->setAccessibleName(tr("Warnings"));
    column->addWidget(m_warnings);
    m_fillAlone = quietLabel(tr("The outline lays no paint: its density φ is 0. What is seen is the fill."), this);
    column->addWidget(m_fillAlone);
    m_later.setSingleShot(true);
    m_later.setInterval(figuresLaterMs);
    connect(&m_later, &QTimer::timeout, this, [this] {
        if (isVisible())
            refreshCut();
    });
    // While paint spreads, the cut through the stroke changes with time.
    connect(&editor.clock(), &PaintingClock::timeChanged, this, &FiguresSection::refreshCutSoon);
}

void FiguresSection::addFigures(QVBoxLayout &column)
{
    QGridLayout *grid = addFieldGrid(column);
    const std::array<QString, figureCount> names{tr("Spread s"),   tr("Spread along"), tr("Peak density"),
                                                 tr("Half-width"), tr("Fades away"),   tr("Spread s"),
                                                 tr("Takes away")};
    const std::array<QString, figureCount> tips{
        tr("How far the paint has spread across the curve once it is dry: √(4·D·t_max)."),
        tr("How far it has spread along the curve."),
        tr("Density in the middle of a long straight stroke, dry."),
        tr("From the middle to the visible edge of a long straight stroke, dry."),
        tr("When the paint has spread so thin that nothing of it is visible any more."),
        tr("How softly the erasure ends: how far it has spread beside its curve, √(4·D·t_max)."),
        tr("What one segment of the erasure takes away in its middle: the share of the paint if it fades; density if "
           "it "
           "lifts, and paint that is thinner is gone there.")};
    for (int i = 0; i < figureCount; ++i) {
        auto *name = quietLabel(names[std::size_t(i)], this);
        name->setWordWrap(false);
        auto *figure = new QLabel(this);
        figure->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        figure->setTextInteractionFlags(Qt::TextSelectableByMouse);
        figure->setAccessibleName(names[std::size_t(i)]);
        name->setToolTip(tips[std::size_t(i)]);
        figure->setToolTip(tips[std::size_t(i)]);
        grid->addWidget(name, i, 0);
        grid->addWidget(figure, i, 1, 1, 2);
        m_names[std::size_t(i)] = name;
        m_figures[std::size_t(i)] = figure;
    }
}

void FiguresSection::refresh(const Inspected &inspected)
{
    if (inspected.isEmpty())
        return;
    m_cutAt = placeOfCut(inspected, m_editor.unsettled().selection().segments.empty());
    refreshCutSoon();
    m_shown = m_keeper.summaryOf(inspected);
    showFigures();
    m_warnings->showHint(figureWarnings(m_shown).join('\n'));
}

void FiguresSection::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (LengthUnits *units = LengthUnits::of(this)) // It is in its window now.
        connect(units, &LengthUnits::changed, this, &FiguresSection::showFigures, Qt::UniqueConnection);
    showFigures();
    refreshCutSoon();
}

void FiguresSection::refreshCutSoon()
{
    if (!m_later.isActive())
        m_later.start();
}

void FiguresSection::refreshCut()
{
    const PaintingPtr &painting = m_editor.unsettled().painting();
    const StrokePtr stroke = painting->find(m_cutAt.stroke);
    if (stroke && m_cutAt.segment < int(stroke->segments.size()))
        m_cut->show(
            crossSectionOf(*painting, *stroke, m_cutAt.segment, m_editor.clock().time(), CrossSectionPlot::samples));
}

void FiguresSection::showFigures()
{
    const FiguresSummary &figures = m_shown;
    if (figures.segments + figures.erasing == 0)
        return;
    const auto range = [](const Extent &extent, const QString &unit) {
        return rangeText(extent.least, extent.most, unit);
    };
    const bool erasure = figures.isErasure(), fill = figures.isFillAlone();
    m_plot->setVisible(!erasure && !fill);
    m_cut->setVisible(!fill && !(erasure && figures.share.count > 0)); // It shows density, of which a fade takes none.
    m_fillAlone->setVisible(fill);
    for (int i = 0; i < figureCount; ++i)
        for (QLabel *label : {m_names[std::size_t(i)], m_figures[std::size_t(i)]})
            label->setVisible(!fill && (i == 1 ? figures.uneven : erasure == (i >= firstOfErasures)));
    if (fill)
        return;
    const auto lengths = [shown = lengthDisplay(this)](const Extent &extent) {
        return rangeText(shown.toShown(extent.least), shown.toShown(extent.most), shown.unit);
    };
    if (erasure) {
        m_figures[5]->setText(lengths(figures.reach));
        QStringList taken;
        if (figures.share.count > 0)
            taken << shareRange(figures.share);
        if (figures.taken.count > 0)
            taken << range(figures.taken, QString());
        m_figures[6]->setText(taken.join(QStringLiteral(" · ")));
        return;
    }
    const Extent &dries = figures.driesOut;
    const bool stays = dries.count < figures.segments;
    const QString seconds = secondsUnit();
    m_names[0]->setText(figures.uneven ? tr("Spread across") : tr("Spread s"));
    m_figures[0]->setText(lengths(figures.spread));
    m_figures[1]->setText(lengths(figures.along));
    m_figures[2]->setText(range(figures.peak, QString()));
    m_figures[3]->setText(lengths(figures.halfWidth));
    m_figures[4]->setText(dries.count == 0 ? tr("never")
                          : stays          ? tr("partly, from %1").arg(rangeText(dries.least, dries.least, seconds))
                                           : tr("after %1").arg(range(dries, seconds)));
    m_plot->show(figures.styles.front(), figures.peak.least, figures.peak.most, figures.styles.size() > 1);
}

} // namespace suffuse
