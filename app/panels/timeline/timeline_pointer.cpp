#include "app/panels/timeline/timeline_pointer.h"

#include "app/session/editor.h"
#include "app/session/playback.h"
#include "app/widgets/numbers/time_text.h"
#include "model/painting/editable.h"

#include <QApplication>
#include <QMouseEvent>
#include <QWidget>

namespace suffuse {

namespace {

constexpr double gripReach = 4; ///< logical pixels around an end
constexpr double leastForGrips = 14;

/// The segment that is the last one born before a moment.
int segmentAt(const Stroke &stroke, Microseconds T)
{
    int found = 0;
    for (int k = 0; k < int(stroke.segments.size()); ++k)
        if (const Microseconds born = stroke.segments[std::size_t(k)].born;
            born <= T && born >= stroke.segments[std::size_t(found)].born)
            found = k;
    return found;
}

} // namespace

std::optional<QRectF> TimelinePointer::band() const
{
    if (m_drag != Drag::Band || m_pressed == m_pointer)
        return {};
    return QRectF(m_pressed, m_pointer).normalized();
}

TimelinePointer::Hit TimelinePointer::hitAt(QPointF at, const TimelineAxes &axes) const
{
    if (at.y() < axes.rulerHeight)
        return {Part::Ruler, 0};
    const int lane = axes.laneAt(at.y());
    if (lane < 0 || lane >= m_bars.laneCount())
        return {};
    Hit hit;
    const auto reach = Microseconds(gripReach * axes.scale);
    m_bars.forEachIn(lane, {axes.timeAt(at.x()) - reach, axes.timeAt(at.x()) + reach}, 0, [&](std::size_t i) {
        const TimelineBar &bar = m_bars[i];
        const double begin = axes.xOf(bar.begin), drawn = axes.xOf(bar.drawn),
                     end = std::max(axes.xOf(bar.end), begin + 3);
        const bool inside = at.x() >= begin && at.x() < end;
        // Ends can be taken hold of where there is room between them. If all was painted at once, they lie side by
        // side.
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

void TimelinePointer::hover(QPointF at, const TimelineAxes &axes)
{
    const Hit hit = hitAt(at, axes);
    const bool grip = hit.part == Part::Begin || hit.part == Part::End;
    if (grip && !m_bars.painting().isLocked(*m_bars.painting().strokes[hit.bar]))
        m_viewport.setCursor(Qt::SizeHorCursor);
    else
        m_viewport.unsetCursor();
}

void TimelinePointer::scrubTo(double x, const TimelineAxes &axes)
{
    m_playback.seek(std::max(axes.timeAt(x), m_playback.begin()));
}

void TimelinePointer::press(const QMouseEvent &event, const TimelineAxes &axes)
{
    if (isBusy())
        return;
    m_pressed = m_pointer = event.position();
    m_pressedWith = event.modifiers();
    if (event.button() == Qt::MiddleButton) {
        m_drag = Drag::Pan;
        return;
    }
    if (event.button() != Qt::LeftButton)
        return;
    m_hit = hitAt(m_pressed, axes);
    m_selectionBefore = m_editor.document().selection();
    if (m_hit.part == Part::Ruler) {
        m_drag = Drag::Scrub;
        m_timeBefore = m_editor.clock().time();
        scrubTo(m_pressed.x(), axes);
    } else if (m_hit.part == Part::None) {
        m_drag = Drag::Band;
        if (!(event.modifiers() & Qt::ShiftModifier))
            m_editor.document().setSelection({});
    } else {
        m_drag = Drag::Press;
        selectPressed(m_hit, event.modifiers());
    }
}

bool TimelinePointer::selectForMenu(QPointF at, const TimelineAxes &axes)
{
    const Hit hit = hitAt(at, axes);
    if (hit.isOnBar())
        selectPressed(hit, {});
    return hit.isOnBar();
}

QString TimelinePointer::toolTipAt(QPointF at, const TimelineAxes &axes) const
{
    const Hit hit = hitAt(at, axes);
    if (!hit.isOnBar())
        return {};
    const TimelineBar &bar = m_bars[hit.bar];
    const Stroke &stroke = *m_bars.painting().strokes[hit.bar];
    QStringList lines{stroke.name.isEmpty() ? tr("Stroke %1").arg(stroke.id) : stroke.name,
                      tr("Drawn from %1 to %2").arg(clockText(bar.begin), clockText(bar.drawn)),
                      tr("Dry at %1").arg(clockText(bar.dry))};
    if (bar.end > bar.dry)
        lines << tr("Wetted again, dry at %1").arg(clockText(bar.end));
    if (const std::vector<TimeSpan> erasures = erasuresOf(stroke); !erasures.empty())
        lines << tr("Erased in part from %1 on").arg(clockText(erasures.front().begin));
    if (m_bars.painting().isLocked(stroke))
        lines << tr("Locked");
    return lines.join('\n');
}

void TimelinePointer::selectPressed(const Hit &hit, Qt::KeyboardModifiers modifiers)
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

void TimelinePointer::move(const QMouseEvent &event, const TimelineAxes &axes)
{
    const QPointF at = event.position();
    const QPointF moved = at - m_pointer;
    m_pointer = at;
    switch (m_drag) {
    case Drag::None:
        hover(at, axes);
        break;
    case Drag::Scrub:
        scrubTo(at.x(), axes);
        break;
    case Drag::Band:
        selectBand(axes);
        break;
    case Drag::Press:
        if ((at - m_pressed).manhattanLength() >= QApplication::startDragDistance() &&
            m_editor.document().selection().strokes.contains(m_bars[m_hit.bar].stroke))
            beginRetiming(axes);
        break;
    case Drag::Pan:
        emit panned(moved);
        break;
    case Drag::Retime:
        retimeTo(at, axes);
    }
}

void TimelinePointer::selectBand(const TimelineAxes &axes)
{
    const QRectF band = QRectF(m_pressed, m_pointer).normalized();
    const TimeSpan span{axes.timeAt(band.left()), axes.timeAt(band.right())};
    Selection selection;
    if (QApplication::keyboardModifiers() & Qt::ShiftModifier)
        selection = m_selectionBefore;
    const Painting &painting = m_bars.painting();
    const Editable isEditable(painting.groups);
    for (int lane = 0; lane < m_bars.laneCount(); ++lane)
        if (axes.laneTop(lane + 1) > band.top() && axes.laneTop(lane) < band.bottom())
            m_bars.forEachIn(lane, span, 0, [&](std::size_t i) {
                const Stroke &stroke = *painting.strokes[i];
                if (isEditable(stroke))
                    selection.strokes.insert(stroke.id);
            });
    m_editor.document().setSelection(std::move(selection));
    m_viewport.update();
}

void TimelinePointer::beginRetiming(const TimelineAxes &axes)
{
    using Kind = Retiming::Kind;
    const bool eases = m_pressedWith & Qt::AltModifier;
    const Kind kind = m_hit.part == Part::Begin ? (eases ? Kind::EaseBegin : Kind::StretchBegin)
                      : m_hit.part == Part::End ? (eases ? Kind::EaseEnd : Kind::StretchEnd)
                                                : Kind::Shift;
    m_retiming = Retiming::begin(m_editor, kind, m_bars[m_hit.bar]);
    if (!m_retiming)
        return;
    m_playback.pause();
    m_drag = Drag::Retime;
    retimeTo(m_pointer, axes);
}

void TimelinePointer::retimeTo(QPointF at, const TimelineAxes &axes)
{
    emit dragged(m_retiming->moveBy(Microseconds(std::llround((at.x() - m_pressed.x()) * axes.scale))));
    m_viewport.update();
}

void TimelinePointer::endRetiming(bool isKept)
{
    m_retiming->commit();
    forget();
    emit retimingEnded(isKept);
    emit dragged({});
}

void TimelinePointer::forget()
{
    m_drag = Drag::None;
    m_retiming.reset();
}

void TimelinePointer::giveUp()
{
    if (m_retiming) {
        m_retiming->giveUp();
        endRetiming(false);
    } else if (m_drag == Drag::Band) {
        m_editor.document().setSelection(m_selectionBefore);
    } else if (m_drag == Drag::Scrub) {
        m_playback.seek(m_timeBefore);
    }
    m_drag = Drag::None;
    m_viewport.update();
}

bool TimelinePointer::release(const QMouseEvent &event)
{
    if (event.button() != (m_drag == Drag::Pan ? Qt::MiddleButton : Qt::LeftButton))
        return false;
    if (m_retiming)
        endRetiming(true);
    m_drag = Drag::None;
    m_viewport.update();
    return true;
}

void TimelinePointer::doubleClick(const QMouseEvent &event, const TimelineAxes &axes)
{
    const Hit hit = hitAt(event.position(), axes);
    if (event.button() != Qt::LeftButton || !hit.isOnBar())
        return press(event, axes);
    const Stroke &stroke = *m_bars.painting().strokes[hit.bar];
    Selection selection = m_editor.document().selection();
    if (!(event.modifiers() & Qt::ShiftModifier))
        selection = {{stroke.id}, {}};
    selection.segments.insert({stroke.id, segmentAt(stroke, axes.timeAt(event.position().x()))});
    m_editor.document().setSelection(std::move(selection));
}

} // namespace suffuse
