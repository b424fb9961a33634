#include "app/canvas/handles/symmetry_handle.h"

#include "app/canvas/canvas_view.h"
#include "app/canvas/overlay/overlay.h"
#include "app/session/drawing_aids.h"

#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

constexpr double gripInset = 34; ///< logical pixels between the border of the view, or a ruler there, and the grips
constexpr double gripReach = 11; ///< logical pixels around the middle of a grip in which a press takes it
constexpr double gripStep = std::numbers::pi / 12;

/// The direction on the screen, length 1.
Point directionOnScreen(const View &view, Point centre, Point direction)
{
    const Point way = view.toPixels(centre + direction) - view.toPixels(centre);
    return 1 / std::max(length(way), 1e-300) * way;
}

} // namespace

SymmetryHandle::SymmetryHandle(DrawingAids &aids, const CanvasView &view, std::function<bool()> isShown,
                               std::function<double()> dpr)
    : m_aids(aids), m_view(view), m_isShown(std::move(isShown)), m_dpr(std::move(dpr))
{}

std::optional<SymmetryHandle::Grips> SymmetryHandle::grips() const
{
    const Symmetry &symmetry = m_aids.symmetry();
    if (!symmetry.isOn || !m_isShown())
        return std::nullopt;
    const View &view = m_view.view();
    const double in = gripInset * m_dpr();
    const Point centre = view.toPixels(symmetry.centre),
                way = directionOnScreen(view, symmetry.centre, symmetry.direction());
    const double far = 2.0 * (view.width + view.height) + length(centre);
    Point a = centre + far * way, b = centre - far * way;
    if (!clipLine(a, b, Rect::of(in, in, view.width - 2 * in, view.height - 2 * in)))
        return std::nullopt;
    return Grips{a, b};
}

SymmetryHandle::Part SymmetryHandle::partAt(Point pixel) const
{
    const std::optional<Grips> at = grips();
    const double near = gripReach * m_dpr();
    if (!at)
        return Part::None;
    return length(at->move - pixel) <= near ? Part::Move : length(at->turn - pixel) <= near ? Part::Turn : Part::None;
}

std::optional<QCursor> SymmetryHandle::cursorAt(Point pixel) const
{
    const Part part = m_held != Part::None ? m_held : partAt(pixel);
    if (part == Part::None)
        return std::nullopt;
    return QCursor(part == Part::Move ? Qt::SizeAllCursor : Qt::PointingHandCursor);
}

void SymmetryHandle::press(const PointerEvent &event)
{
    m_held = partAt(event.pixel);
    m_before = m_aids.symmetry();
    m_from = event.point;
}

void SymmetryHandle::move(const PointerEvent &event)
{
    Symmetry symmetry = m_before;
    const bool steps = event.modifiers & Qt::ShiftModifier;
    if (m_held == Part::Move) {
        Point by = event.point - m_from;
        if (steps)
            (std::abs(by.x) < std::abs(by.y) ? by.x : by.y) = 0;
        symmetry.centre = symmetry.centre + by;
    } else if (m_held == Part::Turn) {
        const Point from = m_from - symmetry.centre, to = event.point - symmetry.centre;
        symmetry.angle += std::atan2(cross(from, to), dot(from, to));
        if (steps)
            symmetry.angle = gripStep * std::round(symmetry.angle / gripStep);
    }
    m_aids.setSymmetry(symmetry);
}

void SymmetryHandle::release(const PointerEvent &event)
{
    if (m_held != Part::None)
        move(event);
    m_held = Part::None;
}

void SymmetryHandle::cancel()
{
    if (m_held != Part::None)
        m_aids.setSymmetry(m_before);
    m_held = Part::None;
}

void SymmetryHandle::paint(QPainter &painter, const View &view, const OverlayColours &colours, double dpr) const
{
    const Symmetry &symmetry = m_aids.symmetry();
    if (!symmetry.isOn || !m_isShown())
        return;
    const Point centre = view.toPixels(symmetry.centre);
    const double far = 2.0 * (view.width + view.height) + length(centre);
    QPainterPath lines;
    for (const Point &spoke : symmetry.spokes()) {
        Point a = centre, b = centre + far * directionOnScreen(view, symmetry.centre, spoke);
        if (clipLine(a, b, Rect::of(0, 0, view.width, view.height).grown(dpr))) {
            lines.moveTo(a.x, a.y);
            lines.lineTo(b.x, b.y);
        }
    }
    strokeTwoTone(painter, lines, colours.accent, dpr, Qt::DashLine, 0.7);
    const std::optional<Grips> at = grips();
    if (!at)
        return;
    painter.setBrush(Qt::white);
    painter.setPen(QPen(colours.accent, 1.4 * dpr));
    const double r = 5 * dpr;
    painter.drawRect(QRectF(at->move.x - r, at->move.y - r, 2 * r, 2 * r));
    painter.drawEllipse(QPointF(at->turn.x, at->turn.y), 1.1 * r, 1.1 * r);
    painter.setBrush(Qt::NoBrush);
}

} // namespace suffuse
