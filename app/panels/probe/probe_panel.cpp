#include "app/panels/probe/probe_panel.h"

#include "app/session/colour_convert.h"
#include "app/session/editor.h"
#include "app/widgets/curves/age_plot.h"
#include "app/widgets/curves/cross_section.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/display.h"
#include "model/paint/half_width.h"
#include "model/paint/point_density.h"

#include <QHeaderView>
#include <QLocale>
#include <QPainter>
#include <QPointer>
#include <QTimerEvent>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace suffuse {

namespace {

constexpr int restMs = 250; ///< The pointer rests when it has not moved for so long.
constexpr int pauseMs = 40; ///< milliseconds between two probes, which leave the canvas its time
constexpr int ageSamples = 64;
constexpr int mostSegments = 200; ///< rows shown for one stroke
constexpr double leastShare = 0.0005;

enum Role { StrokeRole = Qt::UserRole, SegmentRole };

QPixmap chip(const QColor &colour)
{
    QPixmap pixmap(32, 32);
    pixmap.setDevicePixelRatio(2);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QColor(128, 128, 128, 128));
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(2.5, 2.5, 11, 11), 3, 3);
    return pixmap;
}

} // namespace

ProbePanel::ProbePanel(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    m_thread.setMaxThreadCount(1);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);
    const QString idle = tr("Rest the pointer on the painting: what it is made of there is listed here, and stays "
                            "when you come here to click it.");
    m_place = quietLabel(idle, this);
    column->addWidget(m_place);
    m_view = new QTreeWidget(this);
    m_view->setHeaderLabels({tr("Stroke"), tr("Share"), tr("Density φ")});
    m_view->headerItem()->setToolTip(ShareColumn, tr("Of strokes: share of the colour. Of segments: share of the "
                                                     "stroke's density."));
    m_view->header()->setStretchLastSection(false);
    m_view->header()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
    for (const int c : {ShareColumn, DensityColumn}) {
        m_view->header()->setSectionResizeMode(c, QHeaderView::ResizeToContents);
        m_view->headerItem()->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
    }
    m_view->header()->setMinimumSectionSize(fontMetrics().horizontalAdvance(QStringLiteral("00.0 %")) + 16);
    m_view->setUniformRowHeights(true);
    m_view->setIndentation(14);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setAccessibleName(tr("Strokes under the pointer"));
    m_view->setAccessibleDescription(tr("The topmost stroke comes first, with its share of the colour."));
    column->addWidget(m_view, 1);
    m_plot = new AgePlot(this);
    m_plot->setAccessibleName(tr("Density over the age"));
    m_plot->setToolTip(tr("The density of the chosen stroke at this place from when it was painted until it is dry. "
                          "Dashed: the density from which it is seen."));
    column->addWidget(m_plot);
    connect(m_view, &QTreeWidget::itemClicked, this, &ProbePanel::selectRow);
    connect(m_view, &QTreeWidget::currentItemChanged, this, &ProbePanel::showAges);
    connect(&editor.document(), &Document::changed, this, [this](const Change &change) {
        if (change.reset)
            m_point.reset(), m_rested.reset(), m_view->clear(), m_plot->show({}, 0, 0);
        else if (!change.strokes.empty() || change.order || change.canvas)
            want();
    });
    connect(&editor.clock(), &PaintingClock::timeChanged, this, &ProbePanel::want);
}

ProbePanel::~ProbePanel()
{
    m_thread.waitForDone();
}

void ProbePanel::setPoint(Point point)
{
    if (m_point == point)
        return;
    m_point = point;
    m_restTimer.start(restMs, this);
    want();
}

void ProbePanel::leaveCanvas()
{
    m_restTimer.stop();
    if (m_rested && m_point != m_rested) {
        m_point = m_rested;
        want();
    }
}

void ProbePanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    want();
}

void ProbePanel::timerEvent(QTimerEvent *event)
{
    if (event->timerId() == m_restTimer.timerId()) {
        m_restTimer.stop();
        m_rested = m_point;
    } else if (event->timerId() == m_pause.timerId()) {
        m_pause.stop();
        start();
    } else {
        QWidget::timerEvent(event);
    }
}

void ProbePanel::want()
{
    if (!isVisible() || !m_point)
        return;
    m_wanted = true;
    if (!m_running && !m_pause.isActive())
        m_pause.start(m_editor.isDragging() ? 4 * pauseMs : pauseMs, this);
}

void ProbePanel::start()
{
    if (!m_wanted || m_running || !m_point)
        return;
    m_wanted = false;
    m_running = true;
    const Job job{m_editor.document().painting(), m_editor.clock().time(), *m_point};
    m_thread.start([job, panel = this] {
        // The panel's destructor waits for this task. An answer that comes after it is dropped.
        auto result = std::make_shared<Result<Probe>>(
            probe(reaching(*job.painting, job.time, job.point), job.time, job.point.x, job.point.y));
        QMetaObject::invokeMethod(
            panel, [panel, job, result] { panel->take(job, *result); }, Qt::QueuedConnection);
    });
}

void ProbePanel::take(const Job &job, const Result<Probe> &result)
{
    m_running = false;
    m_shown = job;
    const QLocale l;
    if (result) {
        m_place->setText(tr("%1, %2 · paper η %3")
                             .arg(l.toString(job.point.x, 'f', 1), l.toString(job.point.y, 'f', 1),
                                  l.toString(result->paper, 'f', 2)));
        showProbe(*result);
    } else {
        m_place->setText(result.error());
        m_view->clear();
    }
    if (m_wanted)
        want();
}

void ProbePanel::showProbe(const Probe &probe)
{
    // What was open or chosen stays so while the pointer moves.
    std::set<StrokeId> open;
    for (int i = 0; i < m_view->topLevelItemCount(); ++i)
        if (m_view->topLevelItem(i)->isExpanded())
            open.insert(m_view->topLevelItem(i)->data(0, StrokeRole).toULongLong());
    const QTreeWidgetItem *current = m_view->currentItem();
    const StrokeId chosen = current ? current->data(0, StrokeRole).toULongLong() : 0;
    const QSignalBlocker blocker(m_view);
    m_view->clear();
    for (std::size_t i = probe.strokes.size(); i-- > 0;) {
        if (probe.strokes[i].opacity < leastShare)
            continue; // The stroke reaches the point, but nothing of it is seen there.
        QTreeWidgetItem *item = addStroke(probe.strokes[i]);
        item->setExpanded(open.contains(probe.strokes[i].id));
        if (probe.strokes[i].id == chosen)
            m_view->setCurrentItem(item);
    }
    auto *ground = new QTreeWidgetItem(m_view, {tr("Canvas"), shareDisplay().text(probe.canvasShare), QString()});
    ground->setIcon(NameColumn, chip(toOpaqueScreen(m_shown.painting->canvas.background)));
    ground->setTextAlignment(ShareColumn, Qt::AlignRight | Qt::AlignVCenter);
    showAges();
}

QTreeWidgetItem *ProbePanel::addStroke(const ProbeStroke &stroke)
{
    const QLocale l;
    const auto row = [&](const QString &name, double part, double density, int segment) {
        auto *item = new QTreeWidgetItem({name, shareDisplay().text(part), l.toString(density, 'g', 3)});
        item->setData(0, StrokeRole, QVariant::fromValue<qulonglong>(stroke.id));
        item->setData(0, SegmentRole, segment);
        for (const int c : {ShareColumn, DensityColumn})
            item->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
        return item;
    };
    const QString name = stroke.name.isEmpty() ? tr("Stroke %1").arg(stroke.id) : stroke.name;
    QTreeWidgetItem *item = row(name, stroke.colourShare, stroke.density, -1);
    const Colour colour{float(stroke.colour[0]), float(stroke.colour[1]), float(stroke.colour[2]), 1};
    item->setIcon(NameColumn, chip(toOpaqueScreen(colour)));
    m_view->addTopLevelItem(item);
    if (stroke.fillShare >= leastShare)
        item->addChild(row(tr("Fill"), stroke.fillShare, stroke.fillDensity, -1));
    std::vector<ProbeShare> shares = stroke.shares;
    std::sort(shares.begin(), shares.end(), [](const auto &a, const auto &b) { return a.share > b.share; });
    for (const ProbeShare &s : shares)
        if (s.share >= leastShare && item->childCount() < mostSegments)
            item->addChild(row(tr("Segment %1").arg(s.segment + 1), s.share, s.density, s.segment));
    return item;
}

void ProbePanel::showAges()
{
    const QTreeWidgetItem *item = m_view->currentItem() ? m_view->currentItem() : m_view->topLevelItem(0);
    const StrokeId id = item ? item->data(0, StrokeRole).toULongLong() : 0;
    const StrokePtr stroke = m_shown.painting ? m_shown.painting->find(id) : nullptr;
    const int only = item ? item->data(0, SegmentRole).toInt() : -1;
    if (!stroke || only >= int(stroke->segments.size())) {
        m_plot->show({}, 0, 0);
        return;
    }
    const bool whole = only < 0;
    const Segment &one = stroke->segments[std::size_t(std::max(only, 0))];
    const Microseconds born = whole ? stroke->born() : one.born, dry = whole ? stroke->driesAt() : one.driesAt();
    std::vector<QPointF> points;
    for (int i = 1; i <= ageSamples; ++i) {
        // Samples stand closer together at first, where the density changes fastest.
        const double share = double(i * i) / (ageSamples * ageSamples);
        const Microseconds time = born + Microseconds(share * double(dry - born));
        points.emplace_back(toSeconds(time - born), whole ? strokeDensityAt(*stroke, time, m_shown.point)
                                                          : segmentDensityAt(*stroke, one, time, m_shown.point));
    }
    m_plot->show(std::move(points), toSeconds(m_shown.time - born), visibleCut(stroke->styleOf(one)));
}

void ProbePanel::selectRow(QTreeWidgetItem *item)
{
    const StrokeId id = item->data(0, StrokeRole).toULongLong();
    const int segment = item->data(0, SegmentRole).toInt();
    if (!id || !m_editor.document().painting()->find(id))
        return;
    Selection selection{{id}, {}};
    if (segment >= 0)
        selection.segments.insert({id, segment});
    m_editor.document().setSelection(std::move(selection));
}

} // namespace suffuse
