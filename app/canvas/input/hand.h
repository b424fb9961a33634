// What the pointer holds between press and release.
#pragma once

#include "app/canvas/input/held_keys.h"
#include "app/canvas/input/pointer_event.h"

#include <QObject>

namespace suffuse {

class CanvasHandles;
class CanvasView;
class Tool;

/// Takes the pointer's reports, whatever device they come from. It gives them to the tool, to what is to be dragged on the
/// canvas whatever the tool, or moves the view by them.
class Hand : public QObject {
    Q_OBJECT

public:
    Hand(CanvasView &view, CanvasHandles &handles, QObject *parent = nullptr)
        : QObject(parent), m_view(view), m_handles(handles)
    {}

    /// Sets the tool, which belongs to the caller, or none (null). The tool before it is cancelled.
    void setTool(Tool *tool);
    Tool *tool() const { return m_tool; }
    /// Whether the tool has seen a press and no release yet.
    bool isPressed() const { return m_pressed; }
    Navigation navigation() const { return m_navigation; }
    /// Whether a handle of the canvas is being dragged.
    bool holdsHandle() const;
    /// Whether neither the tool is pressed nor a handle or the view is being moved.
    bool isFree() const { return !m_pressed && m_navigation == Navigation::None && !holdsHandle(); }
    /// The button whose release is awaited.
    Qt::MouseButton button() const { return m_button; }
    Point lastPixel() const { return m_lastPixel; }

    /// Notes that the pointer comes over the canvas at a pixel.
    void enter(Point pixel) { m_lastPixel = pixel; }
    void press(const PointerEvent &event, Navigation navigation);
    void move(const PointerEvent &event);
    void release(const PointerEvent &event);
    /// To be called when the pointer leaves the canvas, or the pen gets out of reach.
    void leave();
    /// Makes the tool give up what it has in hand.
    void cancel();

signals:
    void moved(double x, double y); ///< canvas units
    /// What the tool in use has been given: a press, its moves and its release.
    void toolPressed(const suffuse::PointerEvent &event);
    void toolMoved(const suffuse::PointerEvent &event);
    void toolReleased();
    void navigationChanged();
    void handleChanged(); ///< the pointer comes over another handle, or one is taken or let go
    /// The right button, or the pen's button, has asked what is there.
    void asked(const suffuse::PointerEvent &event);

private:
    void setNavigation(Navigation navigation);

    void noteHandle();

    CanvasView &m_view;
    CanvasHandles &m_handles;
    bool m_overHandle = false;
    Tool *m_tool = nullptr;
    bool m_pressed = false;
    Navigation m_navigation = Navigation::None;
    Qt::MouseButton m_button = Qt::NoButton;
    Point m_lastPixel;
};

} // namespace suffuse
