#include "app/tools/pan_tool.h"

#include "app/canvas/canvas_widget.h"

namespace suffuse {

QString PanTool::hint() const
{
    return tr("Drag to move the canvas. The wheel zooms; R and drag turns.");
}

void PanTool::press(const PointerEvent &event)
{
    m_dragging = true;
    m_last = event.pixel;
    m_canvas.refreshCursor();
}

void PanTool::move(const PointerEvent &event)
{
    if (m_dragging)
        m_canvas.panBy(event.pixel - m_last);
    m_last = event.pixel;
}

void PanTool::release(const PointerEvent &)
{
    m_dragging = false;
    m_canvas.refreshCursor();
}

} // namespace suffuse
