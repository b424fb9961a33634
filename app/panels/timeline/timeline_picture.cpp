#include "app/panels/timeline/timeline_picture.h"

#include "app/session/colour_convert.h"
#include "app/session/painting_clock.h"
#include "app/widgets/look/theme.h"
#include "model/document/document.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QWidget>

#include <array>

namespace suffuse {

namespace {

constexpr double leastForSegments = 5; ///< logical pixels of each segment from which on segments are shown
constexpr double tickDistance = 80;    ///< logical pixels between two ticks, at least

/// A step for ticks in which people count: 1, 2, 5, 10, 15 or 30 seconds, the same in minutes, or hours.
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
        return TimelinePicture::tr("%1 s").arg(locale.toString(seconds, 'f', decimals));
    const double minutes = std::floor(std::abs(seconds) / 60);
    const double rest = std::abs(seconds) - 60 * minutes;
    const QString text = locale.toString(rest, 'f', decimals);
    return QStringLiteral("%1%2:%3").arg(seconds < 0 ? QStringLiteral("−") : QString(),
                                         locale.toString(minutes, 'f', 0),
                                         (rest < 10 ? QStringLiteral("0") : QString()) + text);
}

} // namespace

TimelinePicture::TimelinePicture(const QWidget &viewport, const Document &document, const PaintingClock &clock,
                                 const TimelineBars &bars, const TimelineAxes &axes)
    : m_viewport(viewport), m_document(document), m_clock(clock), m_bars(bars), m_axes(axes),
      m_palette(viewport.palette())
{}

void TimelinePicture::paint(QPainter &painter, const QRect &area, const std::set<StrokeId> *dragged,
                            const std::optional<QRectF> &band) const
{
    painter.fillRect(area, m_palette.color(QPalette::Base));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.setClipRect(lanesRect(), Qt::IntersectClip);
    paintLanes(painter, area, dragged);
    paintErasures(painter, area, dragged);
    if (band) {
        QColor fill = m_palette.color(QPalette::Highlight);
        painter.setPen(fill);
        fill.setAlpha(40);
        painter.setBrush(fill);
        painter.drawRect(*band);
    }
    painter.restore();
    paintRuler(painter, area);
    paintPlayhead(painter);
}

QRectF TimelinePicture::lanesRect() const
{
    return QRectF(0, m_axes.rulerHeight, m_viewport.width(), m_viewport.height() - m_axes.rulerHeight);
}

double TimelinePicture::labelLeft(double tick, double width, double head, double view)
{
    constexpr double beside = 4, clear = 8; // pixels beside the line of a tick, and from the middle of the playhead
    for (const double left : {tick + beside, tick - beside - width, head + clear, head - clear - width}) {
        const bool isClear = left >= head + clear - 1 || left + width <= head - clear + 1;
        if (tick >= 0 && tick <= view && left >= 0 && left + width <= view && isClear)
            return left;
    }
    return tick + beside;
}

QRect TimelinePicture::headArea(const TimelineAxes &axes, Microseconds time, int width)
{
    const int at = int(std::clamp(axes.xOf(time), -100.0, width + 100.0));
    return {at - int(2 * tickDistance), 0, int(4 * tickDistance), axes.rulerHeight};
}

void TimelinePicture::paintRuler(QPainter &painter, const QRect &area) const
{
    const double height = m_axes.rulerHeight, width = m_viewport.width();
    painter.fillRect(QRectF(0, 0, width, height), m_palette.color(QPalette::AlternateBase));
    painter.setPen(hairline());
    painter.drawLine(QPointF(0, height - 0.5), QPointF(width, height - 0.5));
    const double pixelsPerSecond = 1e6 / m_axes.scale;
    const double step = tickStep(tickDistance / pixelsPerSecond);
    const double first = std::floor(toSeconds(m_axes.timeAt(std::max(area.left() - 2 * tickDistance, 0.0))) / step);
    const double last = toSeconds(m_axes.timeAt(area.right() + 1 + tickDistance)) / step;
    const double head = m_axes.xOf(m_clock.shown());
    const auto tickAt = [&](double k) {
        return std::floor((k * step * 1e6 - double(m_axes.from)) / m_axes.scale) + 0.5;
    };
    const auto labelAt = [&](double k) { // from left to right
        const double wide = m_viewport.fontMetrics().horizontalAdvance(tickLabel(k * step, step));
        const double left = labelLeft(tickAt(k), wide, head, width);
        return std::pair(left, left + wide);
    };
    for (double k = first; k <= last; ++k) {
        const double x = tickAt(k);
        painter.setPen(m_palette.color(QPalette::PlaceholderText));
        painter.drawLine(QPointF(x, height - 7), QPointF(x, height - 1));
        // What the edge or the playhead pushes onto the label before it is left out.
        if (const double left = labelAt(k).first; k < 1 || left >= labelAt(k - 1).second + 4)
            painter.drawText(QRectF(left, 0, 2 * tickDistance, height - 2), Qt::AlignLeft | Qt::AlignVCenter,
                             tickLabel(k * step, step));
        painter.setPen(hairline());
        for (int part = 1; part < 5; ++part) {
            const double at = std::floor(x + part * step * pixelsPerSecond / 5) + 0.5;
            painter.drawLine(QPointF(at, height - 4), QPointF(at, height - 1));
        }
    }
}

void TimelinePicture::paintLanes(QPainter &painter, const QRect &area, const std::set<StrokeId> *dragged) const
{
    const TimeSpan span{m_axes.timeAt(area.left() - 4), m_axes.timeAt(area.right() + 4)};
    const auto grain = Microseconds(m_axes.scale);
    const auto isShown = [&](int lane) {
        return m_axes.laneTop(lane + 1) >= std::max(m_axes.rulerHeight, area.top()) &&
               m_axes.laneTop(lane) <= area.bottom() + 1;
    };
    const Visibility isVisible(m_bars.painting().groups);
    for (int lane = 0; lane < m_bars.laneCount(); ++lane) {
        if (isShown(lane))
            m_bars.forEachIn(lane, span, grain, [&](std::size_t i) {
                if (!dragged || !dragged->contains(m_bars[i].stroke))
                    paintBar(painter, m_bars[i], *m_bars.painting().strokes[i],
                             isVisible(*m_bars.painting().strokes[i]));
            });
    }
    // What is dragged is shown where it is now, in the lanes from before the drag.
    const Painting &now = *m_document.painting();
    for (std::size_t i = 0; dragged && i < std::min(m_bars.size(), now.strokes.size()); ++i) {
        if (!isShown(m_bars[i].lane) || !dragged->contains(m_bars[i].stroke) || now.strokes[i]->id != m_bars[i].stroke)
            continue;
        TimelineBar bar = barOf(*now.strokes[i]);
        bar.lane = m_bars[i].lane;
        if (bar.begin <= span.end && bar.end >= span.begin)
            paintBar(painter, bar, *now.strokes[i], isVisible(*now.strokes[i]));
    }
    if (const std::optional<TimelineBar> draft = draftBar(m_bars, m_document))
        paintBar(painter, *draft, *m_document.draft(), isVisible(*m_document.draft()));
    else if (m_bars.size() == 0) {
        painter.setPen(m_palette.color(QPalette::PlaceholderText));
        painter.drawText(lanesRect(), Qt::AlignCenter,
                         tr("Each stroke is a bar here: from when it is painted until it is dry."));
    }
}

void TimelinePicture::paintBar(QPainter &painter, const TimelineBar &bar, const Stroke &stroke, bool isVisible) const
{
    const double top = m_axes.laneTop(bar.lane), begin = m_axes.xOf(bar.begin),
                 end = std::max(m_axes.xOf(bar.end), begin + 2);
    QColor colour = toOpaqueScreen(bar.colour);
    colour.setAlphaF(isVisible ? 1.0f : 0.35f);
    const bool selected = m_document.selection().strokes.contains(bar.stroke);
    if (end - begin < 3) { // The bar is too small to show parts.
        const QRectF bar(begin, top, end - begin, TimelineAxes::laneHeight);
        // The colours of the bar may be those of the ground.
        painter.fillRect(bar.adjusted(-0.5, -0.5, 0.5, 0.5), edgeOfColours());
        painter.fillRect(bar, selected ? m_palette.color(QPalette::Highlight) : colour);
        return;
    }
    const double drawn = std::max(m_axes.xOf(bar.drawn), begin + 2), dry = std::max(m_axes.xOf(bar.dry), drawn);
    QColor wet = colour;
    wet.setAlphaF(0.4f * wet.alphaF());
    const QRectF body(begin, top, dry - begin, TimelineAxes::laneHeight),
        later(dry, top + TimelineAxes::laneHeight - 4, end - dry, 4);
    for (const QRectF &ground : {body, later}) // Paint is shown on paper, in dark themes too.
        painter.fillRect(ground, previewPaper());
    painter.fillRect(later, wet);
    painter.fillRect(QRectF(drawn, top, dry - drawn, TimelineAxes::laneHeight), wet);
    painter.fillRect(QRectF(begin, top, drawn - begin, TimelineAxes::laneHeight), colour);
    const auto segments = double(std::ranges::count(stroke.segments, false, &Segment::takesPaint));
    if ((drawn - begin) / segments >= leastForSegments) {
        painter.setPen(QPen(qGray(colour.rgb()) > 127 ? QColor(0, 0, 0, 90) : QColor(255, 255, 255, 110), 1));
        for (const Segment &s : stroke.segments)
            if (const double x = m_axes.xOf(s.born); x > begin + 1 && !s.takesPaint())
                painter.drawLine(QPointF(x, top + 3), QPointF(x, top + TimelineAxes::laneHeight - 3));
    }
    painter.setBrush(Qt::NoBrush);
    // Each bar has a line around it, since paint may have the colour of the ground.
    painter.setPen(selected ? QPen(m_palette.color(isDarkTheme() ? QPalette::Link : QPalette::Highlight), 2)
                            : QPen(edgeOfColours(), 1));
    painter.drawRect(body.adjusted(0.5, 0.5, -0.5, -0.5));
    if (selected)
        paintSelectedRuns(painter, stroke, body);
}

/// What erases a selected stroke is marked in its lane at its time, dashed as it is on the canvas. Other bars may be
/// there, so it covers none of them.
void TimelinePicture::paintErasures(QPainter &painter, const QRect &area, const std::set<StrokeId> *dragged) const
{
    const std::set<StrokeId> &selected = m_document.selection().strokes;
    const StrokeList &strokes = dragged ? m_document.painting()->strokes : m_bars.painting().strokes;
    const QColor accent = m_palette.color(isDarkTheme() ? QPalette::Link : QPalette::Highlight);
    for (std::size_t i = 0; !selected.empty() && i < std::min(m_bars.size(), strokes.size()); ++i) {
        const double top = m_axes.laneTop(m_bars[i].lane);
        const Stroke &stroke = *strokes[i];
        if (!selected.contains(stroke.id) || stroke.id != m_bars[i].stroke || top > area.bottom() ||
            top + TimelineAxes::laneHeight < area.top())
            continue;
        double from = m_axes.xOf(barOf(stroke).end);
        for (const TimeSpan &span : erasuresOf(stroke)) {
            const QRectF mark(m_axes.xOf(span.begin), top + 3,
                              std::max(m_axes.xOf(span.end) - m_axes.xOf(span.begin), 5.0),
                              TimelineAxes::laneHeight - 6);
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(previewPaper(), 3));
            painter.drawRect(mark);
            painter.setPen(QPen(accent, 1.5, Qt::DashLine));
            if (mark.left() > from) // which stroke it belongs to
                painter.drawLine(QPointF(from, mark.center().y()), QPointF(mark.left(), mark.center().y()));
            painter.setPen(QPen(accent, 1.5));
            painter.drawRect(mark);
            from = std::max(from, mark.right());
        }
    }
}

void TimelinePicture::paintSelectedRuns(QPainter &painter, const Stroke &stroke, const QRectF &rect) const
{
    const std::set<SegmentRef> &segments = m_document.selection().segments;
    const QColor accent = painter.pen().color();
    // Bars are brought up to date in a pause, so the selected stroke may have more segments than its bar knows.
    const auto end = segments.lower_bound({stroke.id, int(stroke.segments.size())});
    for (auto it = segments.lower_bound({stroke.id, 0}); it != end; ++it) {
        const std::size_t k = std::size_t(it->segment), next = k + 1;
        const double from = m_axes.xOf(stroke.segments[k].born);
        const double to = next < stroke.segments.size() ? m_axes.xOf(stroke.segments[next].born) : from + 6;
        painter.fillRect(QRectF(std::min(from, to), rect.bottom() - 4, std::max(std::abs(to - from), 2.0), 4), accent);
    }
}

void TimelinePicture::paintPlayhead(QPainter &painter) const
{
    const double x = std::floor(m_axes.xOf(m_clock.shown())) + 0.5;
    // In the past the playhead warns: what is painted there lies below what was painted later.
    const QColor colour = m_clock.isInPast() ? warningText() : m_palette.color(QPalette::Text);
    painter.setPen(QPen(colour, 1.4));
    painter.drawLine(QPointF(x, m_axes.rulerHeight - 6), QPointF(x, m_viewport.height()));
    QPainterPath head(QPointF(x, m_axes.rulerHeight - 1));
    head.lineTo(x - 5, m_axes.rulerHeight - 8);
    head.lineTo(x - 5, m_axes.rulerHeight - 14);
    head.lineTo(x + 5, m_axes.rulerHeight - 14);
    head.lineTo(x + 5, m_axes.rulerHeight - 8);
    head.closeSubpath();
    painter.fillPath(head, colour);
}

} // namespace suffuse
