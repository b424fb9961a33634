#include "app/tools/shaping/eraser_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/editor.h"
#include "app/tools/tool_fields.h"
#include "undo/node_edits.h"

#include <QHBoxLayout>

namespace suffuse {

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
    m_gesture = m_editor.begin(tr("Erase"));
    m_last = event.point;
    m_fromSelected = !document.selection().isEmpty();
    eraseTo(event.point);
    showCircleAt(event.pixel);
}

void EraserTool::eraseTo(Point point)
{
    Document &document = m_editor.document();
    if (const std::set<StrokeId> strokes = targets(m_last, point); !strokes.empty())
        m_gesture.show(eraseAlong(document, strokes, {m_last, point}, radius(), m_editor.clock().time()));
    m_last = point;
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
    m_gesture.commit();
}

void EraserTool::cancel()
{
    // If something else has changed the painting, what was erased before that stays as a step of its own.
    m_gesture.giveUp();
}

} // namespace suffuse
