#pragma once

#include "app/tools/canvas_tool.h"

namespace suffuse {

/// Drags the canvas under the window, as space-drag does with any tool.
class PanTool : public CanvasTool {
    Q_OBJECT

public:
    using CanvasTool::CanvasTool;

    QString hint() const override;
    ColourTarget::ToolUse colourUse() const override { return ColourTarget::ToolUse::Either; }
    QCursor cursor() const override { return m_dragging ? Qt::ClosedHandCursor : Qt::OpenHandCursor; }
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    bool isBusy() const override { return m_dragging; }
    void cancel() override { m_dragging = false; }

private:
    bool m_dragging = false;
    Point m_last;
};

} // namespace suffuse
