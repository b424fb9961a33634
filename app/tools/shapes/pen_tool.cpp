#include "app/tools/shapes/pen_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/canvas/overlay/overlay.h"
#include "app/session/commands/keys.h"
#include "app/session/editor.h"
#include "app/tools/shapes/next_node_fields.h"
#include "app/tools/stroke_ends.h"
#include "model/painting/validate.h"
#include "undo/edits.h"
#include "undo/node_edits.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

namespace suffuse {

PenTool::PenTool(CanvasWidget &canvas, QObject *parent) : DrawingTool(canvas, QStringLiteral("pen"), parent) {}

void PenTool::addFields(QHBoxLayout &row)
{
    DrawingTool::addFields(row);
    row.addSpacing(10);
    m_fields = new NextNodeFields(row);
    connect(m_fields, &NextNodeFields::changed, this, [this] {
        showNumbers();
        m_canvas.updateOverlay();
    });
    connect(m_fields, &NextNodeFields::placed, this, &PenTool::setTyped);
    const auto finishAtCanvas = [this](bool isClosed) {
        m_canvas.setFocus(Qt::OtherFocusReason);
        finish(isClosed);
    };
    connect(m_fields, &NextNodeFields::ended, this, [finishAtCanvas] { finishAtCanvas(false); });
    connect(m_fields, &NextNodeFields::closed, this, [finishAtCanvas] { finishAtCanvas(true); });
    showNumbers();
}

bool PenTool::isTyped() const
{
    return m_fields && m_fields->typed().isAnyTyped();
}

std::optional<Point> PenTool::lastPlace() const
{
    return m_nodes.empty() ? std::nullopt : std::optional(m_nodes.back().at);
}

Point PenTool::placeFor(Point pointed) const
{
    return isTyped() ? m_fields->typed().place(pointed, lastPlace()) : pointed;
}

std::optional<Point> PenTool::nextPlace() const
{
    if (m_nodes.empty() || (!m_pointed && !isTyped()))
        return std::nullopt;
    return placeFor(m_pointed.value_or(m_nodes.back().at));
}

bool PenTool::isFirstNode(Point place) const
{
    constexpr double least = 1e-6; // canvas units
    return canClose() && length(place - m_nodes.front().at) < least;
}

void PenTool::showNumbers()
{
    if (m_fields)
        m_fields->show(lastPlace(), nextPlace().value_or(lastPlace().value_or(Point{})), canClose());
}

/// Sets the node where the row says that it is.
void PenTool::setTyped()
{
    if (!isBusy() && !mayBegin())
        return;
    const Point place = placeFor(lastPlace().value_or(Point{}));
    m_fields->clear();
    m_takenBack.clear();
    m_pointed.reset();
    if (isFirstNode(place)) {
        m_canvas.setFocus(Qt::OtherFocusReason);
        return finish(true);
    }
    if (!isBusy())
        beginWithoutPointer(m_editor.clock().time());
    m_nodes.push_back(cornerAt(place));
    show();
    emit hintChanged();
}

QString PenTool::hint() const
{
    if (isBusy())
        return tr(
            "Click: corner. Drag: curve, Alt: one handle alone. First node: close. Return: end. Backspace: one back.");
    if (!said().isEmpty())
        return said();
    if (m_nearEnd)
        return tr("Click or drag to go on with the selected stroke from its end.");
    return tr("Click for corners, drag for curves. Shift: steps of 15°. An end of a selected stroke: go on with it.");
}

bool PenTool::isNear(Point place, Point pixel) const
{
    return length(m_canvas.view().toPixels(place) - pixel) <= closingReach * m_canvas.devicePixelRatioF();
}

bool PenTool::closesAt(Point pixel) const
{
    if (m_extended) { // at the other end of the chain
        const StrokePtr stroke = m_editor.document().painting()->find(m_extended->stroke);
        const std::optional<NodeRef> end = selectedEndAt(m_canvas, *m_editor.document().painting(), pixel);
        if (!stroke || !end || *end == *m_extended || end->stroke != m_extended->stroke)
            return false;
        const NodeSides one = sidesOf(*stroke, end->node), other = sidesOf(*stroke, m_extended->node);
        return chainAt(*stroke, std::max(one.before, one.after)) ==
               chainAt(*stroke, std::max(other.before, other.after));
    }
    return m_nodes.size() > 1 && isNear(m_nodes.front().at, pixel);
}

void PenTool::setFirst(const PointerEvent &event)
{
    begin(event);
    if (!isTyped())
        m_extended = selectedEndAt(m_canvas, *m_editor.document().painting(), event.pixel);
    const Point from = m_extended
                           ? nodePosition(*m_editor.document().painting()->find(m_extended->stroke), m_extended->node)
                           : placeFor(snapped(event));
    m_nodes.push_back(cornerAt(from));
}

void PenTool::press(const PointerEvent &event)
{
    if (isBusy() && event.doubleClick && !m_isClosing) {
        finish(false); // The click before it has set the last node.
        return;
    }
    if (!isBusy() && event.doubleClick) // The click before it has closed the outline.
        return;
    if (m_fields)
        m_fields->takeEdited();
    const bool goesOn = !isTyped() && selectedEndAt(m_canvas, *m_editor.document().painting(), event.pixel);
    if (!isBusy() && !goesOn && !mayBegin())
        return;
    m_isPressed = true;
    m_takenBack.clear();
    m_pressPixel = event.pixel;
    const bool wasTyped = isTyped();
    const Point next = isBusy() ? placeFor(placeOf(event, m_nodes.back().at)) : Point{};
    m_isClosing = isBusy() && (wasTyped ? isFirstNode(next) : closesAt(event.pixel));
    if (!isBusy())
        setFirst(event);
    else if (m_isClosing && m_extended)
        m_nodes.push_back(
            cornerAt(nodePosition(*m_editor.document().painting()->find(m_extended->stroke),
                                  selectedEndAt(m_canvas, *m_editor.document().painting(), event.pixel)->node)));
    else if (!m_isClosing)
        m_nodes.push_back(cornerAt(next));
    m_handleShift = wasTyped ? (m_isClosing ? m_nodes.front() : m_nodes.back()).at - event.point : Point{};
    m_pointed.reset();
    if (m_fields)
        m_fields->clear();
    show();
    emit hintChanged();
}

void PenTool::dragHandle(const PointerEvent &event)
{
    if (length(event.pixel - m_pressPixel) < leastShapeDrag * m_canvas.devicePixelRatioF())
        return;
    PathNode &node = m_isClosing && !m_extended ? m_nodes.front() : m_nodes.back();
    const Point handle = event.point + m_handleShift;
    const Point to = event.modifiers & Qt::ShiftModifier ? inSteps(node.at, handle) : handle;
    const Point opposite = 2 * node.at - to;
    const bool isBroken = event.modifiers & Qt::AltModifier;
    if (m_isClosing) { // The curve arrives against the drag; the other handle is there already.
        node.in = opposite;
        if (!isBroken && !m_extended)
            node.out = to;
    } else {
        node.out = to;
        if (!isBroken)
            node.in = opposite;
    }
}

void PenTool::move(const PointerEvent &event)
{
    if (!m_isPressed || !isBusy())
        return;
    dragHandle(event);
    show();
}

void PenTool::release(const PointerEvent &event)
{
    if (!m_isPressed || !isBusy())
        return;
    dragHandle(event);
    m_isPressed = false;
    if (m_isClosing)
        finish(true);
    else
        show();
}

void PenTool::hover(const PointerEvent &event)
{
    if (isBusy()) {
        m_pointed = closesAt(event.pixel) && !m_extended ? m_nodes.front().at : placeOf(event, m_nodes.back().at);
        showNumbers();
        m_canvas.updateOverlay();
        return;
    }
    if (const auto end = selectedEndAt(m_canvas, *m_editor.document().painting(), event.pixel); end != m_nearEnd) {
        m_nearEnd = end;
        m_canvas.updateOverlay();
        emit hintChanged();
    }
}

void PenTool::leave()
{
    m_pointed.reset();
    m_nearEnd.reset();
    showNumbers();
    m_canvas.updateOverlay();
}

bool PenTool::takeBack()
{
    if (!isBusy())
        return false;
    takeBackNode();
    return true;
}

void PenTool::takeBackNode()
{
    m_takenBack.push_back(m_nodes.back());
    m_nodes.pop_back();
    m_isPressed = m_isClosing = false;
    if (!m_nodes.empty())
        return show();
    // Nothing is in hand then, and all of it can come back.
    const std::vector<PathNode> takenBack = m_takenBack;
    const std::optional<NodeRef> extended = m_extended;
    cancel();
    m_takenBack = takenBack;
    m_extended = extended;
}

void PenTool::bringBackNode()
{
    if (!isBusy())
        resume();
    m_nodes.push_back(m_takenBack.back());
    m_takenBack.pop_back();
    show();
    emit hintChanged();
}

StrokePtr PenTool::strokeInHand(bool isClosed) const
{
    const std::vector<Cubic> curves = curvesThrough(m_nodes, isClosed && !m_extended);
    if (!m_extended)
        return painted(curves);
    const StrokePtr whole = m_editor.document().painting()->find(m_extended->stroke);
    if (!whole)
        return nullptr;
    const NodeSides sides = sidesOf(*whole, m_extended->node);
    const Segment &values = whole->segments[std::size_t(std::max(sides.before, sides.after))];
    Stroke added = strokeAlong(curves, m_editor.brush(), m_id, m_born);
    added.style = whole->style;
    added.mix = whole->mix;
    const Point shift = added.origin - whole->origin;
    added.origin = whole->origin;
    for (Segment &segment : added.segments) {
        Segment like = values;
        for (std::size_t i = 0; i < 4; ++i)
            like.bezier[i] = toOffset(shift + segment.bezier[i], {});
        like.node = segment.node;
        like.born = m_born;
        like.rewet.clear();
        like.start = like.lift = like.fade = false;
        segment = std::move(like);
    }
    for (std::size_t k = 1; k < added.segments.size(); ++k)
        added.segments[k].bezier[0] = added.segments[k - 1].bezier[3];
    return !added.segments.empty() && problemOf(added).isEmpty() ? std::make_shared<const Stroke>(std::move(added))
                                                                 : nullptr;
}

void PenTool::show()
{
    showDraft(strokeInHand(m_isClosing), m_extended.has_value());
    showNumbers();
    m_canvas.updateOverlay();
}

void PenTool::finish(bool isClosed)
{
    if (!isBusy())
        return;
    const StrokePtr stroke = strokeInHand(isClosed);
    const std::optional<NodeRef> end = m_extended;
    const bool isLine = m_nodes.size() > 1; // A click alone is given up without a word.
    cancel();
    if (stroke && end)
        m_editor.push(extendStroke(m_editor.document(), *end, *stroke), tr("Extend outline"));
    else if (isLine && !end)
        addOrSay(stroke, tr("Outline"));
}

void PenTool::forget()
{
    m_nodes.clear();
    m_takenBack.clear();
    m_extended.reset();
    m_pointed.reset();
    m_isPressed = m_isClosing = false;
    if (m_fields)
        m_fields->clear();
    showNumbers();
}

bool PenTool::wantsKey(const QKeyEvent &event) const
{
    const int key = event.key();
    if (meansRedo(event))
        return !m_takenBack.empty();
    const bool isReturn = key == Qt::Key_Return || key == Qt::Key_Enter;
    return isBusy() ? isReturn || key == Qt::Key_Backspace
                    : isReturn && m_fields && !m_fields->typed().needsPointer(true);
}

bool PenTool::keyPress(QKeyEvent *event)
{
    if (!wantsKey(*event))
        return false;
    if (event->key() == Qt::Key_Backspace)
        takeBackNode();
    else if (meansRedo(*event))
        bringBackNode();
    else if (event->modifiers() & Qt::ShiftModifier && canClose())
        finish(true);
    else if (isTyped())
        setTyped();
    else
        finish(false);
    return true;
}

void PenTool::paint(QPainter &painter, const View &view, double dpr) const
{
    const OverlayColours &colours = m_canvas.overlayColours();
    const auto pixel = [&view](Point p) {
        const Point at = view.toPixels(p);
        return QPointF(at.x, at.y);
    };
    if (!isBusy()) {
        const StrokePtr near = m_nearEnd ? m_editor.document().painting()->find(m_nearEnd->stroke) : nullptr;
        if (near && m_nearEnd->node < nodeCount(*near))
            paintSnapMark(painter, view.toPixels(nodePosition(*near, m_nearEnd->node)), colours, dpr);
        return;
    }
    QPainterPath path;
    for (const Cubic &curve : curvesThrough(m_nodes, m_isClosing && !m_extended))
        addCurve(path, curve, view);
    strokeTwoTone(painter, path, colours.accent, dpr);
    const std::optional<Point> next = nextPlace();
    if (next && !m_isPressed) {
        QPainterPath line;
        const PathNode &last = m_nodes.back();
        addCurve(line, curvesThrough({last, cornerAt(*next)}, false).front(), view);
        strokeTwoTone(painter, line, colours.accent, dpr, Qt::DashLine);
    }
    for (const PathNode &node : m_nodes) {
        for (const Point handle : {node.in, node.out})
            if (handle != node.at) {
                QPainterPath line(pixel(node.at));
                line.lineTo(pixel(handle));
                strokeTwoTone(painter, line, colours.accent, dpr, Qt::SolidLine, 0.6);
                paintNode(painter, view.toPixels(handle), colours, 0.7 * dpr);
            }
        paintNode(painter, view.toPixels(node.at), colours, dpr);
    }
    if (next && isFirstNode(*next))
        paintSnapMark(painter, view.toPixels(m_nodes.front().at), colours, dpr);
}

} // namespace suffuse
