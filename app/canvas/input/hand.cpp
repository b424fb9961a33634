#include "app/canvas/input/hand.h"

#include "app/canvas/canvas_view.h"
#include "app/canvas/handles/canvas_handles.h"
#include "app/canvas/tool.h"

namespace suffuse {

void Hand::setTool(Tool *tool)
{
    if (m_tool) {
        m_tool->cancel();
        m_tool->leave();
    }
    m_tool = tool;
    m_pressed = false;
}

void Hand::setNavigation(Navigation navigation)
{
    m_navigation = navigation;
    emit navigationChanged();
}

bool Hand::holdsHandle() const
{
    return m_handles.isHeld();
}

void Hand::noteHandle()
{
    const bool over = m_handles.cursorAt(m_lastPixel).has_value();
    if (over || m_overHandle)
        emit handleChanged();
    m_overHandle = over;
}

void Hand::press(const PointerEvent &event, Navigation navigation)
{
    m_lastPixel = event.pixel;
    if (!isFree())
        return; // A second button does not change what the first one began.
    m_button = event.button;
    if (navigation != Navigation::None) {
        setNavigation(navigation);
    } else if (event.button == Qt::LeftButton && m_handles.press(event)) {
        if (m_tool)
            m_tool->leave();
        noteHandle();
    } else if (event.button == Qt::RightButton && event.device == PointerDevice::Mouse) {
        m_button = Qt::NoButton; // what opens may hear of the release
        emit asked(event);
    } else if (m_tool && event.button == Qt::LeftButton) {
        m_pressed = true;
        emit toolPressed(event);
        m_tool->press(event);
    }
}

void Hand::move(const PointerEvent &event)
{
    if (m_navigation == Navigation::Pan) {
        m_view.panBy(event.pixel - m_lastPixel);
    } else if (m_navigation == Navigation::Rotate) {
        m_view.turnBy(m_lastPixel, event.pixel);
    } else if (holdsHandle()) {
        m_handles.move(event);
    } else if (m_tool && m_pressed) {
        emit toolMoved(event);
        m_tool->move(event);
    } else if (m_tool && m_handles.cursorAt(event.pixel)) {
        m_tool->leave(); // A press there is not the tool's.
    } else if (m_tool) {
        m_tool->hover(event);
    }
    m_lastPixel = event.pixel;
    if (isFree())
        noteHandle();
    emit moved(event.point.x, event.point.y);
}

void Hand::release(const PointerEvent &event)
{
    m_lastPixel = event.pixel;
    if (event.button != m_button)
        return;
    m_button = Qt::NoButton;
    if (m_navigation != Navigation::None) {
        setNavigation(Navigation::None);
    } else if (holdsHandle()) {
        m_handles.release(event);
        noteHandle();
    } else if (m_pressed) {
        m_pressed = false;
        if (m_tool)
            m_tool->release(event);
        emit toolReleased();
    } else if (event.button == Qt::RightButton) { // a pen's: it is up again before something opens
        emit asked(event);
    }
}

void Hand::leave()
{
    if (m_tool)
        m_tool->leave();
}

void Hand::cancel()
{
    m_pressed = false;
    m_handles.cancel();
    if (m_navigation == Navigation::None)
        m_button = Qt::NoButton;
    if (m_tool)
        m_tool->cancel();
}

} // namespace suffuse
