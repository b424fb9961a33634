// What the timeline looks like.
#include "app/panels/timeline/timeline_view.h"
#include "app/session/colour_convert.h"
#include "app/session/editor.h"
#include "app/widgets/theme.h"

#include <QLocale>
#include <QPaintEvent>
#include <QPainter>
#include <QPainterPath>
#include <QScrollBar>

#include <array>

namespace suffuse {

namespace {

constexpr double laneHeight = 14, laneGap = 3;
constexpr double leastForSegments = 5; ///< pixels a segment
constexpr double tickDistance = 80;    ///< pixels at least

/// A step of ticks that people count in: seconds · 1, 2, 5, 10, 15, 30, minutes, hours.
double tickStep(double leastSeconds)
{
    constexpr std::array<double, 14> coarse{1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200};
    if (leastSeconds > 1) {
        for (const double step : coarse)
            if (step >= leastSeconds)
                return step;
        return 3600 * std::pow(10, std::ceil(std::log10(leastSeconds / 3600)));
    }
    const double power = std::pow(10, std::floor(std::log10(leastSeconds)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= leastSeconds * 0.999999)
            return digit * power;
    return 10 * power;
}

QString tickLabel(double seconds, double step)
{
    const int decimals = step >= 1 ? 0 : int(std::ceil(-std::log10(step) - 1e-9));
    const QLocale locale;
    if (std::abs(seconds) < 60)
        return TimelineView::tr("%1 s").arg(locale.toString(seconds, 'f', decimals));
    const double minutes = std::floor(std::abs(seconds) / 60);
    const double rest = std::abs(seconds) - 60 * minutes;
    const QString text = locale.toString(rest, 'f', decimals);
    return QStringLiteral("%1%2:%3").arg(seconds < 0 ? QStringLiteral("−") : QString(),
                                         locale.toString(minutes, 'f', 0),
                                         (rest < 10 ? QStringLiteral("0") : QString()) + text);
}

} // namespace

double TimelineView::laneTop(int lane) const
{
    return rulerHeight() + 4 + lane * (laneHeight + laneGap) - verticalScrollBar()->value();
}

QRectF TimelineView::drawnRect(StrokeId id)
{
    catchUp();
    for (std::size_t i = 0; i < m_bars.size(); ++i)
        if (const TimelineBar &bar = m_bars[i]; bar.stroke == id)
            return {QPointF(xOf(bar.begin), laneTop(bar.lane)),
                    QPointF(xOf(bar.drawn), laneTop(bar.lane) + laneHeight)};
    return {};
}

void TimelineView::paintEvent(QPaintEvent *event)
{
    QPainter painter(viewport());
    painter.fillRect(event->rect(), palette().color(QPalette::Base));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.setClipRect(QRectF(0, rulerHeight(), viewport()->width(), viewport()->height() - rulerHeight()),
                        Qt::IntersectClip);
    paintLanes(painter, event->rect());
    if (m_drag == Drag::Band && m_pressed != m_pointer) {
        QColor fill = palette().color(QPalette::Highlight);
        painter.setPen(fill);
        fill.setAlpha(40);
        painter.setBrush(fill);
        painter.drawRect(QRectF(m_pressed, m_pointer).normalized());
    }
    painter.restore();
    paintRuler(painter, event->rect());
    paintPlayhead(painter);
}

double TimelineView::labelLeft(double tick, double width, double head, double view)
{
    constexpr double beside = 4, clear = 8; // of a tick's line, of the playhead's middle
    for (const double left : {tick + beside, tick - beside - width, head + clear, head - clear - width}) {
        const bool isClear = left >= head + clear - 1 || left + width <= head - clear + 1;
        if (tick >= 0 && tick <= view && left >= 0 && left + width <= view && isClear)
            return left;
    }
    return tick + beside;
}

QRect TimelineView::headArea(Microseconds time) const
{
    const int at = int(std::clamp(xOf(time), -100.0, viewport()->width() + 100.0));
    return {at - int(2 * tickDistance), 0, int(4 * tickDistance), rulerHeight()};
}

void TimelineView::paintRuler(QPainter &painter, const QRect &area) const
{
    const double height = rulerHeight(), width = viewport()->width();
    painter.fillRect(QRectF(0, 0, width, height), palette().color(QPalette::AlternateBase));
    painter.setPen(hairline());
    painter.drawLine(QPointF(0, height - 0.5), QPointF(width, height - 0.5));
    const double pixelsPerSecond = 1e6 / m_scale;
    const double step = tickStep(tickDistance / pixelsPerSecond);
    const double first = std::floor(toSeconds(timeAt(std::max(area.left() - 2 * tickDistance, 0.0))) / step);
    const double last = toSeconds(timeAt(area.right() + 1 + tickDistance)) / step;
    const double head = xOf(m_editor.clock().shown());
    for (double k = first; k <= last; ++k) {
        const double x = std::floor((k * step * 1e6 - double(m_from)) / m_scale) + 0.5;
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawLine(QPointF(x, height - 7), QPointF(x, height - 1));
        const QString label = tickLabel(k * step, step);
        const double left = labelLeft(x, fontMetrics().horizontalAdvance(label), head, width);
        painter.drawText(QRectF(left, 0, 2 * tickDistance, height - 2), Qt::AlignLeft | Qt::AlignVCenter, label);
        painter.setPen(hairline());
        for (int part = 1; part < 5; ++part) {
            const double at = std::floor(x + part * step * pixelsPerSecond / 5) + 0.5;
            painter.drawLine(QPointF(at, height - 4), QPointF(at, height - 1));
        }
    }
}

void TimelineView::paintLanes(QPainter &painter, const QRect &area) const
{
    const TimeSpan span{timeAt(area.left() - 4), timeAt(area.right() + 4)};
    const auto grain = Microseconds(m_scale);
    const std::set<StrokeId> *dragged = m_before ? &m_selectionBefore.strokes : nullptr;
    const auto isShown = [&](int lane) {
        return laneTop(lane + 1) >= std::max(rulerHeight(), area.top()) && laneTop(lane) <= area.bottom() + 1;
    };
    for (int lane = 0; lane < m_bars.laneCount(); ++lane) {
        if (isShown(lane))
            m_bars.forEachIn(lane, span, grain, [&](std::size_t i) {
                if (!dragged || !dragged->contains(m_bars[i].stroke))
                    paintBar(painter, m_bars[i], *m_bars.painting().strokes[i]);
            });
    }
    // What is dragged is where it is now, in the lanes of before.
    const Painting &now = *m_editor.document().painting();
    for (std::size_t i = 0; dragged && i < std::min(m_bars.size(), now.strokes.size()); ++i) {
        if (!isShown(m_bars[i].lane) || !dragged->contains(m_bars[i].stroke) || now.strokes[i]->id != m_bars[i].stroke)
            continue;
        TimelineBar bar = barOf(*now.strokes[i]);
        bar.lane = m_bars[i].lane;
        if (bar.begin <= span.end && bar.end >= span.begin)
            paintBar(painter, bar, *now.strokes[i]);
    }
    if (const std::optional<TimelineBar> draft = draftBar())
        paintBar(painter, *draft, *m_editor.document().draft());
    else if (m_bars.size() == 0) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(QRectF(0, rulerHeight(), viewport()->width(), viewport()->height() - rulerHeight()),
                         Qt::AlignCenter, tr("Each stroke is a bar here: from when it is painted until it is dry."));
    }
}

std::optional<TimelineBar> TimelineView::draftBar() const
{
    const StrokePtr &draft = m_editor.document().draft();
    if (!draft)
        return {};
    TimelineBar bar = barOf(*draft);
    bar.lane = m_bars.laneFrom(bar.begin); // where it will be when the pen has lifted
    return bar;
}

void TimelineView::paintBar(QPainter &painter, const TimelineBar &bar, const Stroke &stroke) const
{
    const double top = laneTop(bar.lane), begin = xOf(bar.begin), end = std::max(xOf(bar.end), begin + 2);
    QColor colour = toOpaqueScreen(bar.colour);
    colour.setAlphaF(m_bars.painting().isVisible(stroke) ? 1.0f : 0.35f);
    const bool selected = m_editor.document().selection().strokes.contains(bar.stroke);
    if (end - begin < 3) { // too small for parts
        const QRectF bar(begin, top, end - begin, laneHeight);
        painter.fillRect(bar.adjusted(-0.5, -0.5, 0.5, 0.5), edgeOfColours()); // colours may be the ground's
        painter.fillRect(bar, selected ? palette().color(QPalette::Highlight) : colour);
        return;
    }
    const double drawn = std::max(xOf(bar.drawn), begin + 2), dry = std::max(xOf(bar.dry), drawn);
    QColor wet = colour;
    wet.setAlphaF(0.4f * wet.alphaF());
    const QRectF body(begin, top, dry - begin, laneHeight), later(dry, top + laneHeight - 4, end - dry, 4);
    for (const QRectF &ground : {body, later}) // paint is seen on paper, in dark themes too
        painter.fillRect(ground, previewPaper());
    painter.fillRect(later, wet);
    painter.fillRect(QRectF(drawn, top, dry - drawn, laneHeight), wet);
    painter.fillRect(QRectF(begin, top, drawn - begin, laneHeight), colour);
    if ((drawn - begin) / double(stroke.segments.size()) >= leastForSegments) {
        painter.setPen(QPen(qGray(colour.rgb()) > 127 ? QColor(0, 0, 0, 90) : QColor(255, 255, 255, 110), 1));
        for (const Segment &s : stroke.segments)
            if (const double x = xOf(s.born); x > begin + 1)
                painter.drawLine(QPointF(x, top + 3), QPointF(x, top + laneHeight - 3));
    }
    painter.setBrush(Qt::NoBrush);
    // A line around: paint may have the colour of the ground.
    painter.setPen(selected ? QPen(palette().color(isDarkTheme() ? QPalette::Link : QPalette::Highlight), 2)
                            : QPen(edgeOfColours(), 1));
    painter.drawRect(body.adjusted(0.5, 0.5, -0.5, -0.5));
    if (selected)
        paintSelectedRuns(painter, stroke, body);
}

void TimelineView::paintSelectedRuns(QPainter &painter, const Stroke &stroke, const QRectF &rect) const
{
    const std::set<SegmentRef> &segments = m_editor.document().selection().segments;
    const QColor accent = painter.pen().color();
    // Bars wait for a pause: the stroke that is selected may have more segments by now.
    const auto end = segments.lower_bound({stroke.id, int(stroke.segments.size())});
    for (auto it = segments.lower_bound({stroke.id, 0}); it != end; ++it) {
        const std::size_t k = std::size_t(it->segment), next = k + 1;
        const double from = xOf(stroke.segments[k].born);
        const double to = next < stroke.segments.size() ? xOf(stroke.segments[next].born) : from + 6;
        painter.fillRect(QRectF(std::min(from, to), rect.bottom() - 4, std::max(std::abs(to - from), 2.0), 4), accent);
    }
}

void TimelineView::paintPlayhead(QPainter &painter) const
{
    const double x = std::floor(xOf(m_editor.clock().shown())) + 0.5;
    // In the past it warns: what is painted now lies below what came later.
    const QColor colour = m_editor.clock().isInPast() ? warningText() : palette().color(QPalette::Text);
    painter.setPen(QPen(colour, 1.4));
    painter.drawLine(QPointF(x, rulerHeight() - 6), QPointF(x, viewport()->height()));
    QPainterPath head(QPointF(x, rulerHeight() - 1));
    head.lineTo(x - 5, rulerHeight() - 8);
    head.lineTo(x - 5, rulerHeight() - 14);
    head.lineTo(x + 5, rulerHeight() - 14);
    head.lineTo(x + 5, rulerHeight() - 8);
    head.closeSubpath();
    painter.fillPath(head, colour);
}

} // namespace suffuse
