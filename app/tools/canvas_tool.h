// What all tools have: the canvas that they work on, and its editor.
#pragma once

#include "app/canvas/tool.h"

namespace suffuse {

class CanvasWidget;
class Editor;

/// A tool of one canvas.
class CanvasTool : public Tool {
public:
    explicit CanvasTool(CanvasWidget &canvas, QObject *parent = nullptr);

protected:
    CanvasWidget &m_canvas;
    Editor &m_editor;
};

} // namespace suffuse
