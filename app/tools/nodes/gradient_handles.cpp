#include "app/tools/nodes/gradient_handles.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/editor.h"
#include "app/widgets/colour/colour_swatch.h"
#include "model/area/outline.h"
#include "model/painting/editable.h"
#include "undo/edits.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

constexpr double knobRadius = 7;     ///< logical pixels: more than that of a node, which may lie on it
constexpr double knobHitRadius = 10; ///< logical pixels
constexpr double gradientStep = std::numbers::pi / 12;

/// The selected strokes whose gradients can be changed, from bottom to top.
std::vector<StrokePtr> gradedStrokes(CanvasWidget &canvas)
{
    std::vector<StrokePtr> strokes;
    const Painting &painting = *canvas.editor().document().painting();
    const std::set<StrokeId> &shown = canvas.selection().strokes;
    if (shown.empty())
        return strokes;
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (shown.contains(stroke->id) && stroke->fill && stroke->fill->gradient && isEditable(*stroke))
            strokes.push_back(stroke);
    return strokes;
}

Point endOf(const Stroke &stroke, bool isSecond)
{
    const Gradient &gradient = *stroke.fill->gradient;
    return stroke.origin + (isSecond ? gradient.to : gradient.from);
}

/// The stroke with an end of its gradient at another place; as it was where the gradient would have no direction.
Stroke withEnd(const Stroke &before, bool isSecond, Point place)
{
    Fill fill = *before.fill;
    (isSecond ? fill.gradient->to : fill.gradient->from) = toOffset(place, before.origin);
    if (fill.gradient->from == fill.gradient->to)
        return before;
    Stroke stroke = before;
    stroke.fill = fill;
    return stroke;
}

} // namespace

QString GradientHandles::hint()
{
    return QCoreApplication::translate(
        "GradientHandles", "Drag an end of the gradient. Ctrl: steps of 15°. Click it, and colours are for it.");
}

std::optional<GradientHandles::End> GradientHandles::endAt(Point pixel) const
{
    std::optional<End> nearest;
    double least = knobHitRadius * m_canvas.devicePixelRatioF();
    for (const StrokePtr &stroke : gradedStrokes(m_canvas))
        for (const bool isSecond : {false, true})
            if (const double d = length(m_canvas.view().toPixels(endOf(*stroke, isSecond)) - pixel); d <= least) {
                least = d;
                nearest = End{stroke->id, isSecond};
            }
    return nearest;
}

bool GradientHandles::press(const PointerEvent &event)
{
    const std::optional<End> end = isBusy() ? std::nullopt : endAt(event.pixel);
    if (!end)
        return false;
    m_end = *end;
    m_chosen = end;
    m_canvas.editor().colourTarget().chooseEnd(end);
    m_grab = endOf(*m_canvas.editor().document().painting()->find(end->stroke), end->isSecond) - event.point;
    m_gesture = m_canvas.editor().begin(QCoreApplication::translate("GradientHandles", "Move gradient"));
    m_gesture.take({end->stroke});
    return true;
}

bool GradientHandles::isChosen() const
{
    return m_chosen && std::ranges::any_of(gradedStrokes(m_canvas),
                                           [this](const StrokePtr &s) { return s->id == m_chosen->stroke; });
}

bool GradientHandles::deselect()
{
    const bool was = isChosen();
    if (std::exchange(m_chosen, std::nullopt))
        m_canvas.editor().colourTarget().chooseEnd({});
    if (was)
        m_canvas.updateSelection();
    return was;
}

bool GradientHandles::nudge(Point by, ValueEntry &entry)
{
    if (!isChosen())
        return false;
    Editor &editor = m_canvas.editor();
    const Edit edit = changeStrokes(editor.document(), {m_chosen->stroke}, [&](Stroke &stroke) {
        stroke = withEnd(stroke, m_chosen->isSecond, endOf(stroke, m_chosen->isSecond) + by);
    });
    editor.push(edit, QCoreApplication::translate("GradientHandles", "Move gradient"), &entry);
    m_canvas.updateOverlay();
    return true;
}

void GradientHandles::move(const PointerEvent &event)
{
    if (!isBusy())
        return;
    const bool steps = event.modifiers & Qt::ControlModifier;
    m_gesture.show([&](const Stroke &before) {
        if (!before.fill || !before.fill->gradient)
            return before;
        Point to = event.point + m_grab;
        const Point other = endOf(before, !m_end.isSecond);
        if (steps) {
            const Point arm = to - other;
            const double angle = gradientStep * std::round(std::atan2(arm.y, arm.x) / gradientStep);
            to = other + length(arm) * Point{std::cos(angle), std::sin(angle)};
        }
        return withEnd(before, m_end.isSecond, to);
    });
    m_canvas.updateOverlay();
}

void GradientHandles::release()
{
    m_gesture.commit();
    m_canvas.updateOverlay();
}

void GradientHandles::cancel()
{
    m_gesture.giveUp();
    m_canvas.updateOverlay();
}

double GradientHandles::reach() const
{
    double reach = 0;
    for (const StrokePtr &stroke : gradedStrokes(m_canvas)) {
        Rect outline = outlineBox(*stroke);
        const Point centre = stroke->origin + Offset{float(outline.centre().x), float(outline.centre().y)};
        for (const bool isSecond : {false, true})
            reach = std::max(reach, length(endOf(*stroke, isSecond) - centre));
    }
    return reach > 0 ? reach * m_canvas.view().scale + 2 * knobHitRadius * m_canvas.devicePixelRatioF() : 0;
}

void GradientHandles::paint(QPainter &painter, const View &view, double dpr) const
{
    const QColor accent = m_canvas.overlayColours().accent;
    for (const StrokePtr &stroke : gradedStrokes(m_canvas)) {
        const auto pointOf = [&](bool isSecond) {
            const Point p = view.toPixels(endOf(*stroke, isSecond));
            return QPointF(p.x, p.y);
        };
        painter.setPen(QPen(QColor(255, 255, 255, 200), 3 * dpr));
        painter.drawLine(pointOf(false), pointOf(true));
        painter.setPen(QPen(accent, 1 * dpr));
        painter.drawLine(pointOf(false), pointOf(true));
        for (const bool isSecond : {false, true}) {
            const Colour &colour = isSecond ? stroke->fill->gradient->colour : stroke->fill->colour;
            const bool isChosen = m_chosen == End{stroke->id, isSecond};
            QPainterPath knob;
            knob.addEllipse(pointOf(isSecond), knobRadius * dpr, knobRadius * dpr);
            painter.strokePath(knob,
                               QPen(QColor(20, 20, 24, 150), (isChosen ? 7.5 : 5.5) * dpr)); // seen on white paper
            painter.strokePath(knob, QPen(Qt::white, (isChosen ? 6 : 4) * dpr));
            paintColour(painter, knob, colour); // what is transparent shows the pattern of that
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(accent, (isChosen ? 3.5 : 1.5) * dpr));
            painter.drawEllipse(pointOf(isSecond), knobRadius * dpr, knobRadius * dpr);
        }
    }
    painter.setBrush(Qt::NoBrush);
}

} // namespace suffuse
