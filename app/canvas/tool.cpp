#include "app/canvas/tool.h"

#include "app/canvas/canvas_widget.h"

namespace suffuse {

Tool::Tool(CanvasWidget &canvas, QObject *parent) : QObject(parent), m_canvas(canvas), m_editor(canvas.editor())
{
}

} // namespace suffuse
