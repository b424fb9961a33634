// The mouse on the timeline: the playhead, selecting, retiming.
#include "app/panels/timeline/timeline_view.h"
#include "app/session/editor.h"
#include "app/session/playback.h"
#include "app/widgets/time_text.h"
#include "undo/time_edits.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QScrollBar>

namespace suffuse {

namespace {

constexpr double gripReach = 4; ///< pixels around an end
constexpr double leastForGrips = 14;

QString signedSeconds(Microseconds t)
{
    return (t < 0 ? QStringLiteral("−") : QStringLiteral("+")) + QLocale().toString(std::abs(toSeconds(t)), 'f', 3);
}

} // namespace

bool TimelineView::isRetimable(std::size_t bar) const
{
    return !m_bars.painting().isLocked(*m_bars.painting().strokes[bar]);
}

TimelineView::Hit TimelineView::hitAt(QPointF at) const
{
    if (at.y() < rulerHeight())
        return {Part::Ruler, 0};
    const int lane = int(std::floor((at.y() - laneTop(0)) / (laneTop(1) - laneTop(0))));
    if (lane < 0 || lane >= m_bars.laneCount())
        return {};
    Hit hit;
    const auto reach = Microseconds(gripReach * m_scale);
    m_bars.forEachIn(lane, {timeAt(at.x()) - reach, timeAt(at.x()) + reach}, 0, [&](std::size_t i) {
        const TimelineBar &bar = m_bars[i];
        const double begin = xOf(bar.begin), drawn = xOf(bar.drawn), end = std::max(xOf(bar.end), begin + 3);
        const bool inside = at.x() >= begin && at.x() < end;
        // Ends are taken hold of where there is room between them. Of what was there at once, they lie side by side.
        const bool grips = end - begin >= leastForGrips, atOnce = drawn - begin < gripReach;
        const bool atBegin = std::abs(at.x() - begin) <= gripReach, atDrawn = std::abs(at.x() - drawn) <= gripReach;
        if (grips && atBegin && (!atOnce || !inside))
            hit = {Part::Begin, i};
        else if (grips && (atDrawn || (atOnce && atBegin)))
            hit = {Part::End, i};
        else if (inside || hit.part == Part::None)
            hit = {Part::Body, i};
    });
    return hit;
}

void TimelineView::updateCursor(QPointF at)
{
    const Hit hit = hitAt(at);
    const bool grip = hit.part == Part::Begin || hit.part == Part::End;
    if (grip && isRetimable(hit.bar))
        viewport()->setCursor(Qt::SizeHorCursor);
    else
        viewport()->unsetCursor();
}

void TimelineView::mousePressEvent(QMouseEvent *event)
{
    if (m_drag != Drag::None)
        return;
    m_pressed = m_pointer = event->position();
    m_pressedWith = event->modifiers();
    if (event->button() == Qt::MiddleButton) {
        m_drag = Drag::Pan;
        return;
    }
    if (event->button() != Qt::LeftButton)
        return;
    catchUp();
    m_hit = hitAt(m_pressed);
    m_selectionBefore = m_editor.document().selection();
    if (m_hit.part == Part::Ruler) {
        m_drag = Drag::Scrub;
        m_playback.seek(std::max(timeAt(m_pressed.x()), m_playback.begin()));
    } else if (m_hit.part == Part::None) {
        m_drag = Drag::Band;
        if (!(event->modifiers() & Qt::ShiftModifier))
            m_editor.document().setSelection({});
    } else {
        m_drag = Drag::Press;
        selectPressed(m_hit, event->modifiers());
    }
}

void TimelineView::contextMenuEvent(QContextMenuEvent *event)
{
    if (m_drag != Drag::None)
        return;
    catchUp();
    const Hit hit = hitAt(event->pos());
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    const bool onBar =
        byKey ? !m_editor.document().selection().isEmpty() : hit.part != Part::None && hit.part != Part::Ruler;
    if (onBar && !byKey)
        selectPressed(hit, {});
    emit menuWanted(event->globalPos(), onBar);
}

QString TimelineView::toolTipAt(QPointF at) const
{
    const Hit hit = hitAt(at);
    if (hit.part == Part::None || hit.part == Part::Ruler)
        return {};
    const TimelineBar &bar = m_bars[hit.bar];
    const Stroke &stroke = *m_bars.painting().strokes[hit.bar];
    QStringList lines{stroke.name.isEmpty() ? tr("Stroke %1").arg(stroke.id) : stroke.name,
                      tr("Drawn from %1 to %2").arg(clockText(bar.begin), clockText(bar.drawn)),
                      tr("Dry at %1").arg(clockText(bar.dry))};
    if (bar.end > bar.dry)
        lines << tr("Wetted again, dry at %1").arg(clockText(bar.end));
    if (m_bars.painting().isLocked(stroke))
        lines << tr("Locked");
    return lines.join('\n');
}

void TimelineView::selectPressed(const Hit &hit, Qt::KeyboardModifiers modifiers)
{
    Document &document = m_editor.document();
    const StrokeId id = m_bars[hit.bar].stroke;
    Selection selection = document.selection();
    if (modifiers & Qt::ShiftModifier) {
        if (selection.strokes.erase(id) == 0)
            selection.strokes.insert(id);
        else
            std::erase_if(selection.segments, [id](const SegmentRef &ref) { return ref.stroke == id; });
    } else if (!selection.strokes.contains(id)) {
        selection = {{id}, {}};
    }
    document.setSelection(std::move(selection));
}

void TimelineView::mouseMoveEvent(QMouseEvent *event)
{
    const QPointF at = event->position();
    const QPointF moved = at - m_pointer;
    m_pointer = at;
    switch (m_drag) {
    case Drag::None:
        updateCursor(at);
        break;
    case Drag::Scrub:
        m_playback.seek(std::max(timeAt(at.x()), m_playback.begin()));
        break;
    case Drag::Band:
        selectBand();
        break;
    case Drag::Press:
        if ((at - m_pressed).manhattanLength() >= QApplication::startDragDistance() &&
            m_editor.document().selection().strokes.contains(m_bars[m_hit.bar].stroke))
            beginRetiming();
        break;
    case Drag::Pan:
        horizontalScrollBar()->setValue(horizontalScrollBar()->value() - int(moved.x()));
        verticalScrollBar()->setValue(verticalScrollBar()->value() - int(moved.y()));
        break;
    case Drag::Shift:
    case Drag::StretchBegin:
    case Drag::StretchEnd:
    case Drag::EaseBegin:
    case Drag::EaseEnd:
        retimeTo(at);
    }
}

void TimelineView::selectBand()
{
    const QRectF band = QRectF(m_pressed, m_pointer).normalized();
    const TimeSpan span{timeAt(band.left()), timeAt(band.right())};
    Selection selection;
    if (QApplication::keyboardModifiers() & Qt::ShiftModifier)
        selection = m_selectionBefore;
    const Painting &painting = m_bars.painting();
    for (int lane = 0; lane < m_bars.laneCount(); ++lane)
        if (laneTop(lane + 1) > band.top() && laneTop(lane) < band.bottom())
            m_bars.forEachIn(lane, span, 0, [&](std::size_t i) {
                const Stroke &stroke = *painting.strokes[i];
                if (painting.isVisible(stroke) && !painting.isLocked(stroke))
                    selection.strokes.insert(stroke.id);
            });
    m_editor.document().setSelection(std::move(selection));
    viewport()->update();
}

void TimelineView::beginRetiming()
{
    const Document &document = m_editor.document();
    m_drawnBefore = drawnSpan(*document.painting(), document.selection());
    if (m_drawnBefore.end < m_drawnBefore.begin)
        return; // all is locked
    m_playback.pause();
    m_before = document.painting();
    m_selectionBefore = document.selection();
    m_run = beginEditRun();
    const bool eases = m_pressedWith & Qt::AltModifier;
    m_drag = m_hit.part == Part::Begin ? (eases ? Drag::EaseBegin : Drag::StretchBegin)
             : m_hit.part == Part::End ? (eases ? Drag::EaseEnd : Drag::StretchEnd)
                                       : Drag::Shift;
    retimeTo(m_pointer);
}

QString TimelineView::retimingText() const
{
    if (m_drag == Drag::EaseBegin || m_drag == Drag::EaseEnd)
        return tr("Ease in time");
    return m_drag == Drag::Shift ? tr("Move in time") : tr("Stretch in time");
}

void TimelineView::retimeTo(QPointF at)
{
    const auto by = Microseconds(std::llround((at.x() - m_pressed.x()) * m_scale));
    std::pair<Edit, QString> result;
    if (m_drag == Drag::Shift)
        result = {retime(*m_before, m_selectionBefore, {.by = by}), tr("Later by %1 s").arg(signedSeconds(by))};
    else if (m_drag == Drag::EaseBegin || m_drag == Drag::EaseEnd)
        result = easedBy(by);
    else
        result = stretched(by);
    m_editor.push(std::move(result.first), retimingText(), m_run);
    emit dragged(result.second);
    viewport()->update();
}

std::pair<Edit, QString> TimelineView::stretched(Microseconds by) const
{
    // The end that is held follows the pointer, whichever stroke's it is.
    const bool begin = m_drag == Drag::StretchBegin;
    TimeSpan span = m_drawnBefore;
    const Microseconds held = begin ? m_bars[m_hit.bar].begin : m_bars[m_hit.bar].drawn;
    const Microseconds fixed = begin ? span.end : span.begin;
    const double share = held == fixed ? 1 : double(held - fixed) / double((begin ? span.begin : span.end) - fixed);
    (begin ? span.begin : span.end) += Microseconds(std::llround(double(by) / share));
    if (begin)
        span.begin = std::min(span.begin, span.end);
    const double seconds = toSeconds(std::max<Microseconds>(span.end - span.begin, 0));
    return {by != 0 ? stretch(*m_before, m_selectionBefore, span) : retime(*m_before, m_selectionBefore, {}),
            tr("Drawn in %1 s").arg(QLocale().toString(seconds, 'f', 3))};
}

std::pair<Edit, QString> TimelineView::easedBy(Microseconds by) const
{
    // Half of the bar inwards, and the pen is as slow there as it can be.
    const bool begin = m_drag == Drag::EaseBegin;
    const TimelineBar &bar = m_bars[m_hit.bar];
    const double half = 0.5 * double(std::max<Microseconds>(bar.drawn - bar.begin, 1));
    const double slower = std::pow(Ease::most, std::clamp(double(begin ? by : -by) / half, -1.0, 1.0));
    const QString pace = QLocale().toString(100 / slower, 'f', 0);
    return {ease(*m_before, m_selectionBefore, begin ? Ease{slower, 1} : Ease{1, slower}),
            begin ? tr("Begins at %1 % of its pace").arg(pace) : tr("Ends at %1 % of its pace").arg(pace)};
}

void TimelineView::endRetiming()
{
    m_drag = Drag::None;
    m_before.reset();
    m_stale = true;
    refresh();
    emit dragged({});
}

void TimelineView::giveUp()
{
    if (m_before) {
        m_editor.giveUp(m_run);
        endRetiming();
    } else if (m_drag == Drag::Band) {
        m_editor.document().setSelection(m_selectionBefore);
    }
    m_drag = Drag::None;
    viewport()->update();
}

void TimelineView::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() != (m_drag == Drag::Pan ? Qt::MiddleButton : Qt::LeftButton))
        return;
    if (m_before)
        endRetiming();
    m_drag = Drag::None;
    viewport()->update();
    updateCursor(event->position());
}

void TimelineView::mouseDoubleClickEvent(QMouseEvent *event)
{
    catchUp();
    const Hit hit = hitAt(event->position());
    if (event->button() != Qt::LeftButton || hit.part == Part::None || hit.part == Part::Ruler)
        return mousePressEvent(event);
    // The segment that is born last before the place.
    const Stroke &stroke = *m_bars.painting().strokes[hit.bar];
    const Microseconds T = timeAt(event->position().x());
    int found = 0;
    for (int k = 0; k < int(stroke.segments.size()); ++k)
        if (const Microseconds born = stroke.segments[std::size_t(k)].born;
            born <= T && born >= stroke.segments[std::size_t(found)].born)
            found = k;
    Selection selection = m_editor.document().selection();
    if (!(event->modifiers() & Qt::ShiftModifier))
        selection = {{stroke.id}, {}};
    selection.segments.insert({stroke.id, found});
    m_editor.document().setSelection(std::move(selection));
}

} // namespace suffuse
