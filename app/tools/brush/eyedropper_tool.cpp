#include "app/tools/brush/eyedropper_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/colour_convert.h"
#include "app/session/editor.h"
#include "app/session/selecting/pick.h"
#include "model/painting/influence.h"
#include "render/probe.h"

#include <QPainter>

#include <utility>

namespace suffuse {

namespace {

constexpr double ringRadius = 26;   ///< logical pixels
constexpr double ringWidth = 10;    ///< logical pixels
constexpr double hairlineSlack = 3; ///< logical pixels around the pointer in which hairlines are found

} // namespace

std::optional<Colour> pictureColourAt(Editor &editor, Point point)
{
    // The probe computes all strokes that it gets, so it gets only those near the point.
    Painting near = *editor.document().snapshot();
    StrokeList strokes;
    for (const StrokePtr &stroke : std::as_const(near.strokes))
        if (influenceOf(*stroke, editor.clock().time()).contains(point))
            strokes.push_back(stroke);
    near.strokes = std::move(strokes);
    const Result<Probe> found = probe(near, editor.clock().time(), point.x, point.y);
    if (!found)
        return {};
    const std::array<double, 3> &ryb = found->strokes.empty() ? found->rybBefore : found->strokes.back().rybAfter;
    const auto channel = [&ryb](int i) { return float(std::clamp(ryb[std::size_t(i)], 0.0, 1.0)); };
    return Colour{channel(0), channel(1), channel(2), 1};
}

std::optional<Colour> strokeColourAt(Editor &editor, Point point, double tolerance)
{
    const Painting &painting = *editor.document().painting();
    const std::optional<SegmentRef> hit = pickTopmost(painting, editor.clock().time(), point, tolerance);
    if (!hit)
        return {};
    return painting.find(hit->stroke)->segments[std::size_t(hit->segment)].colour;
}

ColourPicker::ColourPicker(CanvasWidget &canvas) : m_canvas(canvas), m_editor(canvas.editor()) {}

void ColourPicker::begin(const PointerEvent &event)
{
    m_active = true;
    m_before = m_editor.brush().colour;
    move(event);
}

void ColourPicker::move(const PointerEvent &event)
{
    if (!m_active)
        return;
    m_pixel = event.pixel;
    if (event.modifiers & Qt::ShiftModifier) {
        const double tolerance = hairlineSlack * m_canvas.devicePixelRatioF() / m_canvas.view().scale;
        if (const auto colour = strokeColourAt(m_editor, event.point, tolerance))
            m_editor.setColour(*colour);
    } else if (auto colour = pictureColourAt(m_editor, event.point)) {
        colour->opacity = m_editor.brush().colour.opacity; // The picture has no opacity, so the brush keeps its own.
        m_editor.setColour(*colour);
    }
    m_canvas.updateOverlay();
}

void ColourPicker::end()
{
    if (std::exchange(m_active, false))
        m_canvas.updateOverlay();
}

void ColourPicker::giveUp()
{
    if (!m_active)
        return;
    m_editor.setColour(m_before);
    end();
}

void ColourPicker::paint(QPainter &painter, double dpr) const
{
    if (!m_active)
        return;
    const double r = ringRadius * dpr;
    const QRectF box(m_pixel.x - r, m_pixel.y - r, 2 * r, 2 * r);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(20, 20, 24, 160), (ringWidth + 3) * dpr));
    painter.drawEllipse(box);
    painter.setPen(QPen(Qt::white, (ringWidth + 1.5) * dpr));
    painter.drawEllipse(box);
    const auto half = [&](const Colour &colour, int from) {
        painter.setPen(QPen(toOpaqueScreen(colour), ringWidth * dpr, Qt::SolidLine, Qt::FlatCap));
        painter.drawArc(box, from * 16, 180 * 16);
    };
    half(m_editor.brush().colour, 0);
    half(m_before, 180);
}

EyedropperTool::EyedropperTool(CanvasWidget &canvas, QObject *parent) : CanvasTool(canvas, parent), m_picker(canvas) {}

QString EyedropperTool::hint() const
{
    return tr("Click to take the picture's colour as the current one. Shift: the stroke's own colour.");
}

void EyedropperTool::paint(QPainter &painter, const View &, double dpr) const
{
    m_picker.paint(painter, dpr);
}

} // namespace suffuse
