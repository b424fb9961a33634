#include "app/tools/eraser_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/editor.h"
#include "app/tools/tool_fields.h"
#include "undo/node_edits.h"

#include <QHBoxLayout>

#include <unordered_map>

namespace suffuse {

namespace {

/// Brings a painting's strokes and their order back.
Edit backTo(const Painting &before, const Painting &now, const Selection &selection)
{
    std::unordered_map<StrokeId, StrokePtr> old;
    Edit edit;
    edit.order.emplace();
    for (const StrokePtr &stroke : before.strokes) {
        old.emplace(stroke->id, stroke);
        edit.order->push_back(stroke->id);
    }
    for (const StrokePtr &stroke : now.strokes) {
        const auto it = old.find(stroke->id);
        if (it == old.end())
            edit.strokes[stroke->id] = nullptr;
        else if (it->second != stroke)
            edit.strokes[stroke->id] = it->second;
        if (it != old.end())
            old.erase(it);
    }
    edit.strokes.insert(old.begin(), old.end());
    edit.selection = selection;
    return edit;
}

} // namespace

EraserTool::EraserTool(CanvasWidget &canvas, QObject *parent) : SizedTool("eraser", 10, canvas, parent) {}

QString EraserTool::hint() const
{
    return m_editor.document().selection().isEmpty()
               ? tr("Drag over strokes to erase what lies under the circle. [ and ] change its size.")
               : tr("Drag over the selected strokes to erase what lies under the circle. [ and ] change its size.");
}

QWidget *EraserTool::options()
{
    if (m_options)
        return m_options;
    m_options = new QWidget;
    QHBoxLayout *row = toolRow(m_options);
    addSizeField(*row);
    row->addStretch();
    return m_options;
}

void EraserTool::press(const PointerEvent &event)
{
    const Document &document = m_editor.document();
    m_run = beginEditRun();
    m_last = event.point;
    m_selection = document.selection();
    m_fromSelected = !m_selection.isEmpty();
    m_before = m_shown = document.painting();
    eraseTo(event.point);
    showCircleAt(event.pixel);
}

void EraserTool::eraseTo(Point point)
{
    Document &document = m_editor.document();
    if (const std::set<StrokeId> strokes = targets(m_last, point); !strokes.empty())
        m_editor.push(eraseAlong(document, strokes, {m_last, point}, radius(), m_editor.clock().time()), tr("Erase"),
                      m_run);
    m_last = point;
    m_shown = document.painting();
}

std::set<StrokeId> EraserTool::targets(Point from, Point to)
{
    const StrokeList &strokes = m_editor.document().painting()->strokes;
    const std::set<StrokeId> &selected = m_editor.document().selection().strokes;
    m_boxes.follow(strokes);
    Rect path;
    path.include(from);
    path.include(to);
    path = path.grown(radius());
    std::set<StrokeId> result;
    for (std::size_t i = 0; i < strokes.size(); ++i)
        if (m_boxes[i].intersects(path) && (!m_fromSelected || selected.contains(strokes[i]->id)))
            result.insert(strokes[i]->id);
    return result;
}

void EraserTool::move(const PointerEvent &event)
{
    showCircleAt(event.pixel);
    if (isBusy() && event.point != m_last)
        eraseTo(event.point);
}

void EraserTool::release(const PointerEvent &event)
{
    if (isBusy() && event.point != m_last)
        eraseTo(event.point);
    m_run = 0;
    m_before.reset();
    m_shown.reset();
}

void EraserTool::cancel()
{
    // Where something else has changed the painting since, what is erased stays, as a step of its own.
    if (isBusy() && m_shown == m_editor.document().painting() && m_shown != m_before)
        m_editor.push(backTo(*m_before, *m_shown, m_selection), tr("Erase"), m_run);
    m_run = 0;
    m_before.reset();
    m_shown.reset();
}

} // namespace suffuse
