// What all tools have: the canvas that they work on, and its editor.
#pragma once

#include "app/canvas/tool.h"

namespace suffuse {

class CanvasWidget;
class Editor;

/// What a step of Tool::stepSize multiplies a size by: four steps double it.
inline constexpr double sizeStep = 1.189207115002721;

/// A tool of one canvas.
class CanvasTool : public Tool {
public:
    explicit CanvasTool(CanvasWidget &canvas, QObject *parent = nullptr);

protected:
    /// Says something in place of the tool's hint until the painting changes, or until something else is said; an empty
    /// text brings the hint back. The tool's `hint` has to return it.
    void say(const QString &text);
    const QString &said() const { return m_said; }
    /// How far an arrow key moves what is chosen, canvas units; no value for other keys.
    std::optional<Point> nudgeOf(const QKeyEvent &event) const;

    CanvasWidget &m_canvas;
    Editor &m_editor;

private:
    QString m_said;
};

} // namespace suffuse
