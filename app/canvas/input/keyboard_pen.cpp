#include "app/canvas/input/keyboard_pen.h"

#include "app/canvas/canvas_view.h"
#include "app/canvas/input/hand.h"
#include "app/canvas/tool.h"
#include "app/session/painting_clock.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWidget>

#include <algorithm>
#include <optional>

namespace suffuse {

namespace {

constexpr double keyStep = 10;    ///< logical pixels by which an arrow key moves the pen
constexpr double edgeMargin = 40;  ///< logical pixels between the pen and the edge of the view
constexpr int fullTenths = 10; ///< of the pressure

/// The way that a key of the keypad, or an arrow key, goes; nothing for other keys.
std::optional<Point> wayOf(const QKeyEvent &event)
{
    const bool keypad = event.modifiers() & Qt::KeypadModifier;
    switch (event.key()) {
    case Qt::Key_Left:
        return Point{-1, 0};
    case Qt::Key_Right:
        return Point{1, 0};
    case Qt::Key_Up:
        return Point{0, -1};
    case Qt::Key_Down:
        return Point{0, 1};
    default:
        break;
    }
    if (!keypad)
        return {};
    switch (event.key()) {
    case Qt::Key_1:
    case Qt::Key_End:
        return Point{-1, 1};
    case Qt::Key_2:
        return Point{0, 1};
    case Qt::Key_3:
    case Qt::Key_PageDown:
        return Point{1, 1};
    case Qt::Key_4:
        return Point{-1, 0};
    case Qt::Key_6:
        return Point{1, 0};
    case Qt::Key_7:
    case Qt::Key_Home:
        return Point{-1, -1};
    case Qt::Key_8:
        return Point{0, -1};
    case Qt::Key_9:
    case Qt::Key_PageUp:
        return Point{1, -1};
    default:
        return {};
    }
}

bool pressesPen(const QKeyEvent &event)
{
    return event.key() == Qt::Key_Space || event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

/// By how many tenths a key changes the pressure; 0 for other keys.
int pressureStep(const QKeyEvent &event)
{
    switch (event.key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: // the key of "+" without Shift on many keyboards
        return 1;
    case Qt::Key_Minus:
        return -1;
    default:
        return 0;
    }
}

} // namespace

KeyboardPen::KeyboardPen(QWidget &canvas, Hand &hand, CanvasView &view, const PaintingClock &clock, QObject *parent)
    : QObject(parent), m_canvas(canvas), m_hand(hand), m_view(view), m_clock(clock)
{}

void KeyboardPen::setOn(bool on, Point pixel)
{
    if (on == m_on)
        return;
    finish();
    m_on = on;
    m_held = {};
    m_point = m_view.view().toCanvas(pixel);
    if (on)
        m_hand.move(report({}));
    else
        m_hand.leave();
    emit overlayChanged();
    emit onChanged(on);
}

bool KeyboardPen::isDown() const
{
    return m_down && m_hand.isPressed();
}

PointerEvent KeyboardPen::report(Qt::KeyboardModifiers modifiers) const
{
    PointerEvent event;
    event.point = m_point;
    event.pixel = m_view.view().toPixels(m_point);
    event.pressure = pressure();
    event.time = m_clock.time();
    event.button = Qt::LeftButton;
    event.buttons = m_down ? Qt::LeftButton : Qt::NoButton;
    event.modifiers = modifiers & ~Qt::KeypadModifier;
    return event;
}

bool KeyboardPen::wantsKey(const QKeyEvent &event) const
{
    if (!m_on)
        return false;
    if (event.modifiers() & Qt::MetaModifier)
        return false;
    const bool held = event.modifiers() & (Qt::ControlModifier | Qt::AltModifier);
    // Between two presses a tool may hold an outline, which Return ends and Esc gives up.
    if (event.key() != Qt::Key_Space && !wayOf(event) && !m_down && m_hand.tool() && m_hand.tool()->isBusy())
        return false;
    if (pressesPen(event) || wayOf(event))
        return true;
    return !held && (event.key() == Qt::Key_Escape || pressureStep(event) != 0);
}

void KeyboardPen::keyPress(const QKeyEvent &event)
{
    if (const auto way = wayOf(event)) {
        m_held.left |= event.key() == Qt::Key_Left;
        m_held.right |= event.key() == Qt::Key_Right;
        m_held.up |= event.key() == Qt::Key_Up;
        m_held.down |= event.key() == Qt::Key_Down;
        Point all{double(m_held.right) - double(m_held.left), double(m_held.down) - double(m_held.up)};
        if (length(all) == 0)
            all = *way;
        const bool fine = event.modifiers() & (Qt::ControlModifier | Qt::AltModifier);
        const double far = fine ? 1 : event.modifiers() & Qt::ShiftModifier ? 10 * keyStep : keyStep;
        moveBy(far * m_canvas.devicePixelRatioF() * all);
    } else if (pressesPen(event)) {
        if (event.isAutoRepeat())
            return; // A key that is held does not let go again.
        if (isDown())
            lift(event.modifiers());
        else
            press(event.modifiers());
    } else if (event.key() != Qt::Key_Escape) {
        stepPressure(pressureStep(event));
    } else if (isDown()) {
        giveUp();
    } else {
        setOn(false, m_view.view().toPixels(m_point));
    }
}

void KeyboardPen::keyRelease(const QKeyEvent &event)
{
    if (event.isAutoRepeat())
        return;
    m_held.left &= event.key() != Qt::Key_Left;
    m_held.right &= event.key() != Qt::Key_Right;
    m_held.up &= event.key() != Qt::Key_Up;
    m_held.down &= event.key() != Qt::Key_Down;
}

void KeyboardPen::moveBy(Point pixels)
{
    m_point = m_view.view().toCanvas(m_view.view().toPixels(m_point) + pixels);
    const Point at = m_view.view().toPixels(m_point);
    m_view.bringIntoView({at.x, at.y, at.x, at.y}, edgeMargin * m_canvas.devicePixelRatioF());
    m_hand.move(report({}));
    emit overlayChanged();
    emit moved();
}

void KeyboardPen::press(Qt::KeyboardModifiers modifiers)
{
    if (!m_hand.isFree())
        return; // The mouse or a finger holds the tool.
    m_down = true;
    m_hand.press(report(modifiers), Navigation::None);
    emit overlayChanged();
    emit lowered();
}

void KeyboardPen::lift(Qt::KeyboardModifiers modifiers)
{
    m_down = false;
    m_hand.release(report(modifiers));
    emit overlayChanged();
    emit lifted();
}

void KeyboardPen::finish()
{
    if (isDown())
        lift({});
    m_down = false;
}

void KeyboardPen::giveUp()
{
    m_down = false;
    m_hand.cancel();
    emit overlayChanged();
    emit gaveUp();
}

void KeyboardPen::stepPressure(int by)
{
    m_tenths = std::clamp(m_tenths + by, 1, fullTenths);
    if (isDown())
        m_hand.move(report({}));
    emit overlayChanged();
    emit pressureChanged();
}

void KeyboardPen::paint(QPainter &painter, double dpr) const
{
    if (!m_on)
        return;
    constexpr double arm = 16, gap = 4; // logical pixels
    const Point at = m_view.view().toPixels(m_point);
    const double a = arm * dpr, g = gap * dpr;
    QPainterPath cross;
    for (const Point way : {Point{1, 0}, Point{-1, 0}, Point{0, 1}, Point{0, -1}}) {
        cross.moveTo(at.x + g * way.x, at.y + g * way.y);
        cross.lineTo(at.x + a * way.x, at.y + a * way.y);
    }
    painter.setBrush(Qt::NoBrush);
    // One of the two tones is seen on any picture.
    for (const auto &[colour, width] : {std::pair(QColor(255, 255, 255), 5.0), std::pair(QColor(12, 12, 16), 2.0)}) {
        painter.setPen(QPen(colour, width * dpr, Qt::SolidLine, Qt::FlatCap));
        painter.drawPath(cross);
    }
    painter.setPen(QPen(QColor(255, 255, 255), 1.5 * dpr));
    painter.setBrush(isDown() ? QBrush(QColor(12, 12, 16)) : QBrush(Qt::NoBrush));
    const double dot = (isDown() ? 3.5 : 1.5) * dpr;
    painter.drawEllipse(QPointF(at.x, at.y), dot, dot);
}

} // namespace suffuse
