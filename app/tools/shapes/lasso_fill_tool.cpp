#include "app/tools/shapes/lasso_fill_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/canvas/overlay/overlay.h"
#include "app/session/commands/keys.h"
#include "app/session/editor.h"
#include "model/area/offset_curve.h"
#include "model/shaping/curves/curve_fit.h"
#include "model/shaping/nodes/node_path.h"
#include "undo/edits.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

namespace suffuse {

namespace {

constexpr double wayTolerance = 0.7; ///< logical pixels by which the outline may leave the way of the hand

} // namespace

LassoFillTool::LassoFillTool(CanvasWidget &canvas, QObject *parent)
    : DrawingTool(canvas, QStringLiteral("lassoFill"), parent)
{}

QString LassoFillTool::hint() const
{
    return isBusy() ? tr("Click: straight line. First point, double click or Return: close. Shift: steps of 15°.")
           : !said().isEmpty() ? said()
                               : tr("Draw around what is to be filled. Alt at the end, or clicks: straight lines.");
}

bool LassoFillTool::closesAt(Point pixel) const
{
    const double near = closingReach * m_canvas.devicePixelRatioF();
    return m_parts.size() > 1 && length(m_canvas.view().toPixels(m_parts.front().front()) - pixel) <= near;
}

bool LassoFillTool::isClick(const Part &part) const
{
    const double least = leastShapeDrag * m_canvas.devicePixelRatioF() / m_canvas.view().scale;
    return std::ranges::all_of(part, [&](Point p) { return length(p - part.front()) < least; });
}

void LassoFillTool::press(const PointerEvent &event)
{
    if (isBusy() && (event.doubleClick || closesAt(event.pixel)))
        return finish();
    if (!isBusy() && event.doubleClick) // Its first press has closed the outline.
        return;
    if (!isBusy()) {
        if (!mayBegin())
            return;
        begin(event);
    }
    m_takenBack.clear();
    m_parts.push_back({m_parts.empty() ? snapped(event) : placeOf(event, m_parts.back().back())});
    m_isPressed = true;
    m_next.reset();
    show();
    emit hintChanged();
}

void LassoFillTool::add(const PointerEvent &event)
{
    Part &part = m_parts.back();
    const double step = 0.5 * m_canvas.devicePixelRatioF() / m_canvas.view().scale;
    if (length(event.point - part.back()) >= step)
        part.push_back(event.point);
}

void LassoFillTool::move(const PointerEvent &event)
{
    if (!m_isPressed)
        return;
    add(event);
    show();
}

void LassoFillTool::release(const PointerEvent &event)
{
    if (!m_isPressed)
        return;
    add(event);
    m_isPressed = false;
    if (isClick(m_parts.back()))
        m_parts.back().resize(1);
    else if (!(event.modifiers & Qt::AltModifier))
        return finish();
    show();
}

void LassoFillTool::hover(const PointerEvent &event)
{
    if (!isBusy())
        return;
    m_next = closesAt(event.pixel) ? m_parts.front().front() : placeOf(event, m_parts.back().back());
    m_canvas.updateOverlay();
}

void LassoFillTool::leave()
{
    m_next.reset();
    m_canvas.updateOverlay();
}

std::vector<Cubic> LassoFillTool::outline() const
{
    const double near = wayTolerance * m_canvas.devicePixelRatioF() / m_canvas.view().scale;
    std::vector<Cubic> curves;
    const auto goStraight = [&curves](Point from, Point to) {
        if (from != to)
            curves.push_back(straightCubic(from, to));
    };
    for (const Part &part : m_parts) {
        if (&part != &m_parts.front())
            goStraight((&part - 1)->back(), part.front());
        if (part.size() > 1)
            for (const Cubic &curve : cubicsThrough(part, {}, {}, near))
                curves.push_back(curve);
    }
    if (isBusy())
        goStraight(m_parts.back().back(), m_parts.front().front());
    return curves;
}

void LassoFillTool::show()
{
    showDraft(painted(outline()));
    m_canvas.updateOverlay();
}

void LassoFillTool::finish()
{
    if (!isBusy())
        return;
    const std::vector<Cubic> curves = outline();
    // Two points enclose nothing.
    const StrokePtr stroke = curves.size() > 2 || !isClick(m_parts.back()) ? painted(curves) : nullptr;
    cancel();
    if (stroke || curves.size() > 1) // A click alone is given up without a word.
        addOrSay(stroke, tr("Lasso fill"));
}

bool LassoFillTool::takeBack()
{
    if (!isBusy())
        return false;
    m_isPressed = false;
    m_takenBack.push_back(std::move(m_parts.back()));
    m_parts.pop_back();
    if (!m_parts.empty()) {
        show();
        return true;
    }
    std::vector<Part> takenBack = std::move(m_takenBack); // All of it can come back.
    cancel();
    m_takenBack = std::move(takenBack);
    return true;
}

void LassoFillTool::forget()
{
    m_parts.clear();
    m_takenBack.clear();
    m_isPressed = false;
    m_next.reset();
}

bool LassoFillTool::wantsKey(const QKeyEvent &event) const
{
    if (meansRedo(event))
        return !m_takenBack.empty();
    return isBusy() && (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter);
}

bool LassoFillTool::keyPress(QKeyEvent *event)
{
    if (!wantsKey(*event))
        return false;
    if (!meansRedo(*event)) {
        finish();
        return true;
    }
    if (!isBusy())
        resume();
    m_parts.push_back(std::move(m_takenBack.back()));
    m_takenBack.pop_back();
    show();
    return true;
}

void LassoFillTool::paint(QPainter &painter, const View &view, double dpr) const
{
    if (!isBusy())
        return;
    const auto pixel = [&view](Point p) {
        const Point at = view.toPixels(p);
        return QPointF(at.x, at.y);
    };
    QPainterPath path(pixel(m_parts.front().front()));
    for (const Part &part : m_parts)
        for (const Point p : part)
            path.lineTo(pixel(p));
    const OverlayColours &colours = m_canvas.overlayColours();
    strokeTwoTone(painter, path, colours.accent, dpr);
    QPainterPath rest(pixel(m_parts.back().back()));
    if (m_next && !m_isPressed)
        rest.lineTo(pixel(*m_next));
    rest.lineTo(pixel(m_parts.front().front()));
    strokeTwoTone(painter, rest, colours.accent, dpr, Qt::DashLine);
    paintNode(painter, view.toPixels(m_parts.front().front()), colours, dpr);
}

} // namespace suffuse
