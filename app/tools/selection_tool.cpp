#include "app/tools/selection_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/commands/selection_commands.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/session/selecting/pick.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPainter>

namespace suffuse {

namespace {

constexpr double clickSlack = 3; ///< logical pixels around the pointer in which hairlines are found

} // namespace

void SelectionTool::press(const PointerEvent &event)
{
    m_start = m_now = event;
    m_state = State::Pressed;
    pressed(event);
}

void SelectionTool::move(const PointerEvent &event)
{
    if (m_state == State::Idle)
        return;
    updateBand();
    m_now = event;
    const double slack = QApplication::startDragDistance() * 0.5 * m_canvas.devicePixelRatioF();
    if (m_state == State::Pressed && length(event.pixel - m_start.pixel) > slack)
        beginMoving();
    if (m_state == State::Drag)
        drag(event);
    else if (m_state == State::Band && m_shape != BandShape::Rectangle)
        addToTrace(event);
    updateBand();
}

void SelectionTool::beginMoving()
{
    if (beginDrag(m_start)) {
        m_state = State::Drag;
        return;
    }
    m_canvas.updateSelection(); // Handles are hidden while there is a band.
    m_state = State::Band;
    m_shape = bandShape(m_start);
    m_trace = {m_start.point};
    if (m_shape != BandShape::Rectangle)
        tracing(m_start.point, m_shape);
}

void SelectionTool::addToTrace(const PointerEvent &event)
{
    if (length(event.point - m_trace.back()) * m_canvas.view().scale < 1)
        return;
    m_trace.push_back(event.point);
    tracing(event.point, m_shape);
}

void SelectionTool::finishBand(const PointerEvent &event)
{
    if (m_shape == BandShape::Rectangle)
        banded(band(), event);
    else
        traced(m_trace, m_shape, event);
    m_trace.clear();
}

void SelectionTool::release(const PointerEvent &event)
{
    const State state = m_state;
    updateBand();
    m_state = State::Idle;
    if (state == State::Pressed)
        clicked(event);
    else if (state == State::Band)
        finishBand(event);
    else if (state == State::Drag)
        endDrag(false);
    m_canvas.updateSelection();
}

void SelectionTool::cancel()
{
    const State state = m_state;
    updateBand();
    m_state = State::Idle;
    if (state == State::Drag)
        endDrag(true);
    if (state != State::Idle)
        m_canvas.updateSelection();
}

bool SelectionTool::keyPress(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape) {
        commands::deselect(m_editor);
        return true;
    }
    const std::optional<Point> way = nudgeOf(*event);
    const std::set<StrokeId> &moved = m_canvas.selection().strokes;
    if (!way || isBusy() || moved.empty())
        return false;
    m_nudges.noteStep(event->isAutoRepeat());
    commands::moveStrokes(m_editor, moved, *way, &m_nudges);
    return true;
}

Rect SelectionTool::band() const
{
    Rect r;
    r.include(m_start.pixel);
    r.include(m_now.pixel);
    return r;
}

void SelectionTool::updateBand() const
{
    constexpr double line = 4; // logical pixels that the line takes beside its path
    const double r = line * m_canvas.devicePixelRatioF();
    if (m_state == State::Band)
        m_canvas.updateOverlay(bandPath(m_canvas.view()).boundingRect().adjusted(-r, -r, r, r));
}

QPainterPath SelectionTool::bandPath(const View &view) const
{
    QPainterPath path;
    if (m_shape == BandShape::Rectangle) {
        const Rect r = band();
        path.addRect(QRectF(r.left, r.top, r.width(), r.height()));
        return path;
    }
    QPolygonF line;
    for (const Point &point : m_trace) {
        const Point p = view.toPixels(point);
        line << QPointF(p.x, p.y);
    }
    path.addPolygon(line);
    if (m_shape == BandShape::Lasso)
        path.closeSubpath();
    return path;
}

void SelectionTool::paint(QPainter &painter, const View &view, double dpr) const
{
    if (m_state != State::Band)
        return;
    const QPainterPath path = bandPath(view);
    QColor fill = m_canvas.overlayColours().accent;
    if (m_shape == BandShape::Touch) {
        strokeTwoTone(painter, path, fill, 2 * dpr);
        return;
    }
    fill.setAlpha(28);
    painter.fillPath(path, fill);
    strokeTwoTone(painter, path, m_canvas.overlayColours().accent, dpr, Qt::DashLine);
}

double SelectionTool::tolerance() const
{
    return clickSlack * m_canvas.devicePixelRatioF() / m_canvas.view().scale;
}

std::optional<SegmentRef> SelectionTool::pick(const PointerEvent &event) const
{
    return pickSeen(*m_editor.layer().reached(), m_editor.clock().time(), event.point, tolerance());
}

const Selection &SelectionTool::selection() const
{
    return m_editor.selection();
}

void SelectionTool::select(Selection selection)
{
    m_editor.document().setSelection(std::move(selection));
}

void SelectionTool::selectSegment(const SegmentRef &segment)
{
    m_anchor = segment;
    select(Selection{{segment.stroke}, {segment}});
}

void SelectionTool::addSegment(const SegmentRef &segment)
{
    m_anchor = segment;
    Selection chosen = selection();
    chosen.strokes.insert(segment.stroke);
    chosen.segments.insert(segment);
    select(std::move(chosen));
}

bool SelectionTool::selectRun(const PointerEvent &event)
{
    if (!selection().segments.contains(m_anchor))
        return false;
    const std::optional<SegmentRef> to =
        pickOn(*m_editor.layer().reached(), m_anchor.stroke, m_editor.clock().time(), event.point, tolerance());
    if (!to)
        return false;
    Selection chosen = selection();
    const auto [first, last] = std::minmax(m_anchor.segment, to->segment);
    for (int k = first; k <= last; ++k)
        chosen.segments.insert({to->stroke, k});
    m_anchor = *to;
    select(std::move(chosen));
    return true;
}

} // namespace suffuse
