#include "app/tools/select_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/editor.h"
#include "app/tools/pick.h"
#include "undo/edits.h"

namespace suffuse {

QString SelectTool::hint() const
{
    return tr("Click paint to select its stroke, click again for a segment, Shift+click for more. Drag to move.");
}

void SelectTool::pressed(const PointerEvent &event)
{
    m_hit = pick(event);
    m_selectedByPress = m_hit && !(event.modifiers & Qt::ShiftModifier) && !selection().strokes.contains(m_hit->stroke);
    if (m_selectedByPress)
        select(Selection{{m_hit->stroke}, {}});
}

void SelectTool::clicked(const PointerEvent &event)
{
    const bool add = event.modifiers & Qt::ShiftModifier;
    if (!m_hit) {
        if (!add)
            select({});
        return;
    }
    if (m_selectedByPress)
        return;
    if (add) {
        if (selectRun(event))
            return;
        Selection chosen = selection();
        if (!chosen.strokes.erase(m_hit->stroke))
            chosen.strokes.insert(m_hit->stroke);
        std::erase_if(chosen.segments, [&](const SegmentRef &s) { return s.stroke == m_hit->stroke; });
        select(std::move(chosen));
    } else if (selection().strokes.size() > 1) {
        select(Selection{{m_hit->stroke}, {}});
    } else {
        selectSegment(*m_hit);
    }
}

void SelectTool::banded(const Rect &band, const PointerEvent &event)
{
    Selection chosen;
    if (event.modifiers & Qt::ShiftModifier)
        chosen = selection();
    chosen.strokes.merge(strokesWithin(*m_editor.document().painting(), m_canvas.view(), band));
    select(std::move(chosen));
}

bool SelectTool::beginDrag(const PointerEvent &)
{
    if (!m_hit || !selection().strokes.contains(m_hit->stroke))
        return false;
    m_origins.clear();
    const Painting &painting = *m_editor.document().painting();
    for (const StrokePtr &stroke : painting.strokes)
        if (selection().strokes.contains(stroke->id) && !painting.isLocked(*stroke))
            m_origins[stroke->id] = stroke->origin;
    m_run = beginEditRun();
    return !m_origins.empty();
}

void SelectTool::drag(const PointerEvent &event)
{
    Point by = event.point - start().point;
    if (event.modifiers & Qt::ControlModifier) { // along one axis of the screen, as in Inkscape
        const Point pixels = event.pixel - start().pixel;
        const Point kept = std::abs(pixels.x) > std::abs(pixels.y) ? Point{pixels.x, 0} : Point{0, pixels.y};
        by = m_canvas.view().toCanvas(start().pixel + kept) - start().point;
    }
    moveTo(by);
}

void SelectTool::moveTo(Point by)
{
    const Document &document = m_editor.document();
    std::set<StrokeId> moved;
    for (const auto &[id, origin] : m_origins)
        if (document.painting()->find(id))
            moved.insert(id);
    m_editor.push(changeStrokes(document, moved, [&](Stroke &stroke) { stroke.origin = m_origins.at(stroke.id) + by; }),
                  tr("Move"), m_run);
}

void SelectTool::endDrag(bool cancelled)
{
    if (cancelled)
        moveTo({0, 0}); // a run that comes back to its start leaves no step
    m_origins.clear();
}

QString SegmentTool::hint() const
{
    return tr("Click a segment to select it, Shift+click for a run, Ctrl+click to add or remove one.");
}

void SegmentTool::clicked(const PointerEvent &event)
{
    const std::optional<SegmentRef> hit = pick(event);
    if (!hit) {
        if (!(event.modifiers & (Qt::ShiftModifier | Qt::ControlModifier)))
            select({});
        return;
    }
    if (event.modifiers & Qt::ShiftModifier && selectRun(event))
        return;
    if (event.modifiers & Qt::ControlModifier) {
        Selection chosen = selection();
        if (!chosen.segments.erase(*hit))
            chosen.segments.insert(*hit);
        chosen.strokes.insert(hit->stroke);
        select(std::move(chosen));
        return;
    }
    selectSegment(*hit);
}

void SegmentTool::banded(const Rect &band, const PointerEvent &event)
{
    Selection chosen;
    if (event.modifiers & Qt::ShiftModifier)
        chosen = selection();
    for (const SegmentRef &segment : segmentsWithin(*m_editor.document().painting(), m_canvas.view(), band)) {
        chosen.segments.insert(segment);
        chosen.strokes.insert(segment.stroke);
    }
    select(std::move(chosen));
}

} // namespace suffuse
