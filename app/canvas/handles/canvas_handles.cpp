#include "app/canvas/handles/canvas_handles.h"

#include <algorithm>
#include <utility>

namespace suffuse {

CanvasHandle *CanvasHandles::handleAt(Point pixel) const
{
    const auto at = std::find_if(m_handles.rbegin(), m_handles.rend(),
                                 [&](const auto &handle) { return handle->cursorAt(pixel).has_value(); });
    return at == m_handles.rend() ? nullptr : at->get();
}

bool CanvasHandles::press(const PointerEvent &event)
{
    m_held = handleAt(event.pixel);
    if (m_held)
        m_held->press(event);
    return m_held;
}

void CanvasHandles::move(const PointerEvent &event)
{
    if (m_held)
        m_held->move(event);
}

void CanvasHandles::release(const PointerEvent &event)
{
    if (CanvasHandle *held = std::exchange(m_held, nullptr))
        held->release(event);
}

void CanvasHandles::cancel()
{
    if (CanvasHandle *held = std::exchange(m_held, nullptr))
        held->cancel();
}

std::optional<QCursor> CanvasHandles::cursorAt(Point pixel) const
{
    const CanvasHandle *handle = m_held ? m_held : handleAt(pixel);
    return handle ? handle->cursorAt(pixel) : std::nullopt;
}

void CanvasHandles::paint(QPainter &painter, const View &view, const OverlayColours &colours, double dpr) const
{
    for (const auto &handle : m_handles)
        handle->paint(painter, view, colours, dpr);
}

} // namespace suffuse
