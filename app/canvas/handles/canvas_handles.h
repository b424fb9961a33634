#pragma once

#include "app/canvas/handles/canvas_handle.h"

#include <memory>
#include <vector>

namespace suffuse {

/// All handles of a canvas. The hand gives it each press of the main button before the tool sees it.
class CanvasHandles {
public:
    /// Adds one above the others.
    void add(std::unique_ptr<CanvasHandle> handle) { m_handles.push_back(std::move(handle)); }

    /// Takes a press that means one of them. Returns false, and does nothing, where none is meant.
    bool press(const PointerEvent &event);
    /// Between press and release.
    bool isHeld() const { return m_held != nullptr; }
    void move(const PointerEvent &event);
    void release(const PointerEvent &event);
    void cancel();
    /// The cursor over a handle at a pixel, or of the one that is held; no value: there is none.
    std::optional<QCursor> cursorAt(Point pixel) const;
    void paint(QPainter &painter, const View &view, const OverlayColours &colours, double dpr) const;

private:
    CanvasHandle *handleAt(Point pixel) const;

    std::vector<std::unique_ptr<CanvasHandle>> m_handles; ///< the lowest first
    CanvasHandle *m_held = nullptr;
};

} // namespace suffuse
