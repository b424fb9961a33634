#include "app/tools/brush/brush_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/canvas/overlay/assistant_lines.h"
#include "app/session/current_layer.h"
#include "app/session/drawing_aids.h"
#include "app/session/editor.h"
#include "app/session/settings/brush_library.h"
#include "app/session/settings/settings.h"
#include "app/tools/brush/brush_tool_options.h"
#include "app/tools/stroke_ends.h"
#include "model/brush/brush_dynamics.h"
#include "model/brush/brush_width.h"
#include "model/paint/half_width.h"
#include "model/painting/validate.h"
#include "undo/node_edits.h"

#include <QPainter>
#include <QPainterPath>

#include <numbers>

namespace suffuse {

namespace {

constexpr std::size_t firstStrokes = 3; ///< after which it is said what can be done with them

double spreadOf(const Segment &segment)
{
    return spreadAt(double(segment.diffusion), double(segment.maxAge));
}

/// How far the taper of a brush reaches, in spreads.
double taperOf(const QString &name, bool atStart)
{
    const Brush *brush = BrushLibrary::instance().find(name);
    return brush ? double(atStart ? brush->taper.in : brush->taper.out) : 0;
}

/// The segment where the taper at one of a stroke's ends begins, and its distance from that end. Where there is no
/// taper, it is the segment at the end itself.
std::pair<const Segment *, double> bodyAtEnd(const Stroke &stroke, int node)
{
    const std::size_t count = stroke.segments.size();
    const auto fromEnd = [&](std::size_t k) { return &stroke.segments[node == 0 ? k : count - 1 - k]; };
    const double taper = taperOf(stroke.brush, node == 0);
    const Segment *widest = fromEnd(0);
    double way = 0, wayToWidest = 0;
    for (std::size_t k = 0; k < count && way < taper * spreadOf(*widest); ++k) {
        way += arcLength(stroke.cubicOf(*fromEnd(k)));
        if (spreadOf(*fromEnd(k)) > spreadOf(*widest)) {
            widest = fromEnd(k);
            wayToWidest = way;
        }
    }
    return {widest, wayToWidest};
}

/// A brush that continues a stroke at one of its ends, with the stroke's look and the values there. If the end is
/// tapered, the new paint grows to the size that the stroke has before the taper, over a way as long as the taper.
Brush brushAtEnd(const Stroke &whole, int endOfChain, Brush brush)
{
    const NodeSides sides = sidesOf(whole, endOfChain);
    const Stroke stroke = chainOnly(whole, chainAt(whole, std::max(sides.before, sides.after)));
    const int node = sides.before < 0 ? 0 : int(stroke.segments.size());
    const Segment &tip = node == 0 ? stroke.segments.front() : stroke.segments.back();
    const auto [body, way] = bodyAtEnd(stroke, node);
    const Segment &end = *body;
    brush.name = stroke.brush;
    brush.style = stroke.styleOf(end);
    brush.mix = stroke.mix;
    brush.diffusion = end.diffusion;
    brush.granulation = end.granulation;
    brush.maxAge = end.maxAge;
    brush.colour = end.colour;
    const Point direction = node == 0 ? stroke.cubicOf(end).derivative(0) : stroke.cubicOf(end).derivative(1);
    brush.tip = {end.anisotropyRatio, end.anisotropyAngle, false};
    brush.peak = float(peakDensity(double(end.density), spreadAcross(brush.tip, brush.spread(), direction)));
    brush.taper = {};
    if (way > 0) {
        brush.taper.in = float(way / brush.spread());
        brush.taper.tip = float(std::clamp(spreadOf(tip) / brush.spread(), 0.0, 1.0));
    }
    return brush;
}

} // namespace

BrushTool::BrushTool(CanvasWidget &canvas, QObject *parent)
    : CanvasTool(canvas, parent), m_sizing(m_editor), m_picker(canvas)
{
    connect(&m_editor, &Editor::brushChanged, this, [this] { m_canvas.updateOverlay(); });
    connect(&m_sizing, &BrushSizing::noteChanged, this, [this] { m_canvas.updateOverlay(); });
}

BrushTool::~BrushTool() = default;

QString BrushTool::hint() const
{
    if (!said().isEmpty())
        return said();
    if (m_nearEnd)
        return tr("Shift+drag to go on with the selected stroke from its end.");
    return tr(
        "Drag to paint, tap for a dot. Right button: palette. Shift+drag: size, opacity. Ctrl+click: the picture's "
        "colour, with Shift the stroke's own.");
}

QWidget *BrushTool::options()
{
    if (!m_options)
        m_options = new BrushToolOptions(m_editor);
    return m_options;
}

void BrushTool::press(const PointerEvent &event)
{
    if (event.modifiers & (Qt::ControlModifier | Qt::AltModifier)) {
        m_picker.begin(event);
        say(m_picker.refusal());
        return;
    }
    Brush brush = m_editor.brush();
    m_extended = event.modifiers & Qt::ShiftModifier
                     ? selectedEndAt(m_canvas, *m_editor.document().painting(), event.pixel)
                     : std::nullopt;
    if ((event.modifiers & Qt::ShiftModifier) && !m_extended) {
        m_sizing.begin(event.pixel);
        showOutlineAt(event);
        return;
    }
    if (!m_extended && !m_editor.layer().takesPaint())
        return showOutlineAt(event);
    if (m_extended)
        brush = brushAtEnd(*m_editor.document().painting()->find(m_extended->stroke), m_extended->node, brush);
    say({});
    m_builder = std::make_unique<StrokeBuilder>(brush, m_editor.document().takeStrokeId());
    m_copies.clear();
    if (!m_extended) // Its copies would hang on nothing.
        m_copies.begin(m_editor.document(), m_editor.aids().symmetry());
    m_lastTime = event.time;
    m_editor.clock().hold(true, event.late);
    PointerEvent first = event;
    if (m_extended) // The new stroke begins exactly where the old one ends.
        first.point = nodePosition(*m_editor.document().painting()->find(m_extended->stroke), m_extended->node);
    const double stringLength = double(brush.stabiliser.length) * m_canvas.devicePixelRatioF() / m_canvas.view().scale;
    m_stabiliser.begin(brush.stabiliser, sampleOf(first), stringLength);
    beginAssisted();
    build(m_assisted.take(sampleOf(first)));
    showOutlineAt(event);
}

void BrushTool::beginAssisted()
{
    constexpr double atEnd = 1; // what goes on with a stroke must not jump
    const CanvasAids &aids = m_canvas.aids();
    const double pixel = m_canvas.devicePixelRatioF() / m_canvas.view().scale;
    m_assisted.begin(aids.showAssistants && aids.snapToAssistants ? m_editor.aids().assistants()
                                                                  : std::vector<Assistant>(),
                     AssistedPen::usualTravel * pixel, (m_extended ? atEnd : AssistedPen::usualReach) * pixel);
}

PenSample BrushTool::sampleOf(const PointerEvent &event) const
{
    constexpr double flat = 60; // degrees from upright
    constexpr double degree = std::numbers::pi / 180;
    const double tilt = std::atan(std::hypot(std::tan(std::clamp(event.tiltX, -89.0, 89.0) * degree),
                                             std::tan(std::clamp(event.tiltY, -89.0, 89.0) * degree)));
    return {event.point, std::max(m_lastTime, event.time), float(event.pressure),
            float(std::min(1.0, tilt / (flat * degree)))};
}

void BrushTool::add(const PointerEvent &event)
{
    m_lastTime = std::max(m_lastTime, event.time);
    if (const auto sample = m_stabiliser.take(sampleOf(event)))
        build(m_assisted.take(*sample));
}

void BrushTool::build(const std::vector<PenSample> &samples)
{
    if (samples.size() > 1 && m_assisted.track()) // They have waited until it was decided, and the line is to be seen.
        m_canvas.updateOverlay();
    for (const PenSample &sample : samples)
        m_builder->add(sample);
    if (!samples.empty())
        showDraft();
}

void BrushTool::showDraft()
{
    const StrokePtr stroke = m_builder->stroke();
    m_editor.document().setDraft(stroke, m_copies.of(stroke));
}

void BrushTool::move(const PointerEvent &event)
{
    m_picker.move(event);
    if (m_picker.isActive())
        say(m_picker.refusal());
    if (m_sizing.isActive())
        return m_sizing.moveTo(event.pixel, m_canvas.devicePixelRatioF());
    if (m_builder)
        add(event);
    showOutlineAt(event);
}

void BrushTool::release(const PointerEvent &event)
{
    m_picker.end();
    m_sizing.moveTo(event.pixel, m_canvas.devicePixelRatioF());
    m_sizing.end();
    if (!m_builder)
        return;
    // A pen reports pressure 0 when it lifts, which is no paint.
    if (event.device == PointerDevice::Mouse || event.pressure > 0)
        if (const auto last = m_stabiliser.finish(sampleOf(event)))
            build(m_assisted.take(*last));
    build(m_assisted.finish());
    m_builder->finish();
    const StrokePtr stroke = m_builder->stroke();
    m_builder.reset();
    if (m_assisted.track())
        m_canvas.updateOverlay();
    Document &document = m_editor.document();
    document.setDraft(nullptr);
    if (stroke && problemOf(*stroke).isEmpty()) {
        pushStroke(stroke);
        tellAbout(*stroke);
    }
    m_editor.clock().hold(false);
    showOutlineAt(event);
}

void BrushTool::pushStroke(const StrokePtr &stroke)
{
    const Document &document = m_editor.document();
    const std::optional<NodeRef> end = std::exchange(m_extended, std::nullopt);
    if (end)
        if (Edit edit = extendStroke(document, *end, *stroke); !edit.isEmpty())
            return m_editor.push(std::move(edit), tr("Extend stroke"));
    m_editor.push(m_editor.layer().take(addStrokes(document, m_copies.with(stroke), false)), tr("Brush stroke"));
}

void BrushTool::tellAbout(const Stroke &stroke)
{
    const Canvas &canvas = m_editor.document().painting()->canvas;
    const Rect sheet = Rect::of(0, 0, canvas.width, canvas.height);
    if (!m_canvas.aids().showBeyond && !seenBox(stroke).intersects(sheet))
        say(tr("This stroke lies beyond the canvas: View ▸ Show Paint beyond the Canvas shows it."));
    else if (m_editor.document().painting()->strokes.size() >= firstStrokes && !settings::hasSelected())
        say(tr("All that you paint stays editable: press V and click paint to move, scale or recolour it."));
}

void BrushTool::cancel()
{
    m_picker.giveUp();
    m_sizing.giveUp();
    if (!m_builder)
        return;
    m_builder.reset();
    m_canvas.updateOverlay();
    m_editor.document().setDraft(nullptr);
    m_editor.clock().hold(false);
}

void BrushTool::hover(const PointerEvent &event)
{
    showOutlineAt(event);
    if (const std::optional<NodeRef> end = selectedEndAt(m_canvas, *m_editor.document().painting(), event.pixel);
        end != m_nearEnd) {
        m_nearEnd = end;
        m_canvas.updateOverlay();
        emit hintChanged();
    }
}

void BrushTool::leave()
{
    m_canvas.updateOverlay(outlineBox());
    m_hovering = false;
}

QRectF BrushTool::outlineBox() const
{
    const Brush &brush = m_editor.brush();
    const double r = std::max(brush.spread(), halfWidthOf(brush)) * m_canvas.view().scale + 4;
    return QRectF(m_pixel.x - r, m_pixel.y - r, 2 * r, 2 * r);
}

void BrushTool::showOutlineAt(const PointerEvent &event)
{
    if (m_hovering)
        m_canvas.updateOverlay(outlineBox());
    m_pixel = event.pixel;
    m_device = event.device;
    m_hovering = true;
    m_canvas.updateOverlay(outlineBox());
}

/// What a mouse says while it paints; none where that is not known before, or where the brush itself is looked at.
std::optional<PenState> BrushTool::usualPen(const View &view, double dpr) const
{
    constexpr double usualSpeed = 300; // logical pixels a second
    const double spread = m_editor.brush().spread();
    if (m_device != PointerDevice::Mouse || m_sizing.isActive() || !(view.scale * spread > 0))
        return std::nullopt;
    return PenState{.speed = usualSpeed * dpr / (view.scale * spread)};
}

double BrushTool::circle(const View &view, double dpr) const
{
    const std::optional<PenState> pen = usualPen(view, dpr);
    return pen ? halfWidthOf(m_editor.brush(), *pen) : halfWidthOf(m_editor.brush());
}

void BrushTool::paint(QPainter &painter, const View &view, double dpr) const
{
    m_picker.paint(painter, dpr);
    if (m_builder && m_assisted.track())
        paintTrack(painter, *m_assisted.track(), view, m_canvas.overlayColours(), dpr);
    if (m_hovering && !m_picker.isActive())
        paintOutline(painter, view, dpr);
    paintNote(painter, dpr); // The note is painted last, so that no circle crosses it.
}

void BrushTool::paintOutline(QPainter &painter, const View &view, double dpr) const
{
    paintString(painter, view, dpr);
    const StrokePtr near = m_nearEnd ? m_editor.document().painting()->find(m_nearEnd->stroke) : nullptr;
    if (near && m_nearEnd->node < nodeCount(*near)) {
        const Point at = view.toPixels(nodePosition(*near, m_nearEnd->node));
        painter.setPen(QPen(Qt::white, 1.2 * dpr));
        painter.setBrush(m_canvas.overlayColours().accent);
        painter.drawEllipse(QPointF(at.x, at.y), 4 * dpr, 4 * dpr);
    }
    const auto ring = [&](double radius, Qt::PenStyle style, int alpha) {
        const double r = radius * view.scale;
        if (r < 3 * dpr || r > 2.0 * (view.width + view.height))
            return; // The circle is too small to tell it from the cross, or lies all around the window.
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor(255, 255, 255, alpha), 2.2 * dpr));
        painter.drawEllipse(QPointF(m_pixel.x, m_pixel.y), r, r);
        painter.setPen(QPen(QColor(20, 20, 24, alpha), dpr, style));
        painter.drawEllipse(QPointF(m_pixel.x, m_pixel.y), r, r);
    };
    const Brush &brush = m_editor.brush();
    const std::optional<PenState> pen = usualPen(view, dpr);
    ring(pen ? spreadOf(brush, *pen) : brush.spread(), Qt::DotLine, 110);
    ring(circle(view, dpr), Qt::SolidLine, 200);
}

void BrushTool::paintNote(QPainter &painter, double dpr) const
{
    if (note().isEmpty() || !m_hovering)
        return;
    const Brush &brush = m_editor.brush();
    const double circle = std::max(brush.spread(), halfWidthOf(brush)) * m_canvas.view().scale;
    paintBadge(painter, note(), m_pixel, circle, m_canvas.view(), dpr);
}

void BrushTool::paintString(QPainter &painter, const View &view, double dpr) const
{
    const std::optional<Point> anchor = m_builder ? m_stabiliser.anchor() : std::nullopt;
    if (!anchor)
        return;
    const Point at = view.toPixels(*anchor);
    QPainterPath string(QPointF(at.x, at.y));
    string.lineTo(m_pixel.x, m_pixel.y);
    strokeTwoTone(painter, string, QColor(20, 20, 24), dpr);
    paintNode(painter, at, m_canvas.overlayColours(), dpr);
}

} // namespace suffuse
