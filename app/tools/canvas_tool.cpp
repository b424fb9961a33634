#include "app/tools/canvas_tool.h"

#include "app/canvas/canvas_widget.h"

namespace suffuse {

CanvasTool::CanvasTool(CanvasWidget &canvas, QObject *parent)
    : Tool(parent), m_canvas(canvas), m_editor(canvas.editor())
{}

} // namespace suffuse
