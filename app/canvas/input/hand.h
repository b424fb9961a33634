// What the pointer holds between press and release.
#pragma once

#include "app/canvas/input/held_keys.h"
#include "app/canvas/input/pointer_event.h"

#include <QObject>

namespace suffuse {

class CanvasView;
class Tool;

/// Takes the pointer's reports, whatever device they come from, and gives them to the tool, or moves the view by them.
class Hand : public QObject {
    Q_OBJECT

public:
    explicit Hand(CanvasView &view, QObject *parent = nullptr) : QObject(parent), m_view(view) {}

    /// The tool belongs to the caller; null: none. The old one is cancelled.
    void setTool(Tool *tool);
    Tool *tool() const { return m_tool; }
    /// The tool has seen a press and no release yet.
    bool isPressed() const { return m_pressed; }
    Navigation navigation() const { return m_navigation; }
    /// Neither is the tool pressed nor the view in the hand.
    bool isFree() const { return !m_pressed && m_navigation == Navigation::None; }
    /// Whose release is awaited.
    Qt::MouseButton button() const { return m_button; }
    Point lastPixel() const { return m_lastPixel; }

    /// The pointer comes in at a pixel.
    void enter(Point pixel) { m_lastPixel = pixel; }
    void press(const PointerEvent &event, Navigation navigation);
    void move(const PointerEvent &event);
    void release(const PointerEvent &event);
    /// The pointer is over the canvas no more, or the pen out of reach.
    void leave();
    /// The tool gives up what it has in hand.
    void cancel();

signals:
    void moved(double x, double y); ///< canvas units
    void navigationChanged();

private:
    void setNavigation(Navigation navigation);

    CanvasView &m_view;
    Tool *m_tool = nullptr;
    bool m_pressed = false;
    Navigation m_navigation = Navigation::None;
    Qt::MouseButton m_button = Qt::NoButton;
    Point m_lastPixel;
};

} // namespace suffuse
