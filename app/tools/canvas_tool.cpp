#include "app/tools/canvas_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/editor.h"
#include "app/widgets/habits/at_next_change.h"

#include <utility>

namespace suffuse {

CanvasTool::CanvasTool(CanvasWidget &canvas, QObject *parent)
    : Tool(parent), m_canvas(canvas), m_editor(canvas.editor())
{}

void CanvasTool::say(const QString &text)
{
    if (std::exchange(m_said, text) == text)
        return;
    emit hintChanged();
    if (!text.isEmpty())
        atNextChange(m_editor.document(), this, [this] { say({}); });
}

} // namespace suffuse
