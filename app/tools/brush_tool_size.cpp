// The brush's size and opacity, changed on the canvas and shown there.
#include "app/canvas/canvas_widget.h"
#include "app/session/editor.h"
#include "app/tools/brush_tool.h"
#include "app/widgets/quantity.h"
#include "model/brush/brush_width.h"

#include <QPainter>
#include <QPainterPath>

namespace suffuse {

namespace {

constexpr double brushSizeStep = 1.189207115002721; ///< four double it
constexpr double opacityStep = 0.1;
constexpr double leastSpread = 1e-7;
constexpr double greatestSpread = 1e5;
constexpr double undecided = 4;      ///< logical pixels before a drag is one of size or of opacity
constexpr double doubling = 80;      ///< logical pixels across that double the size
constexpr double wholeOpacity = 200; ///< logical pixels upwards from none to all
constexpr int noteMs = 900;

QString noteOf(Quantity quantity, double value)
{
    const FieldSpec spec = specOf(quantity);
    return spec.name + QStringLiteral(" ") + spec.display.text(value);
}

} // namespace

void BrushTool::stepSize(int steps)
{
    scaleSize(std::pow(brushSizeStep, steps));
}

void BrushTool::stepOpacity(int steps)
{
    addOpacity(opacityStep * steps);
}

void BrushTool::scaleSize(double factor)
{
    Brush brush = m_editor.brush();
    brush.setSpread(std::clamp(brush.spread() * factor, leastSpread, greatestSpread));
    m_editor.setBrush(brush);
    showNote(noteOf(Quantity::Size, brush.spread()), m_resizing.has_value());
}

void BrushTool::addOpacity(double difference)
{
    Brush brush = m_editor.brush();
    brush.colour.opacity = float(std::clamp(double(brush.colour.opacity) + difference, 0.0, 1.0));
    m_editor.setBrush(brush);
    showNote(noteOf(Quantity::Opacity, double(brush.colour.opacity)), m_resizing.has_value());
}

void BrushTool::resizeTo(Point pixel)
{
    const double dpr = m_canvas.devicePixelRatioF();
    const Point way = (1 / dpr) * (pixel - m_resizing->pixel);
    if (m_resizing->what == Resizing::Undecided && length(way) >= undecided)
        m_resizing->what = std::abs(way.x) >= std::abs(way.y) ? Resizing::Size : Resizing::Opacity;
    if (m_resizing->what == Resizing::Undecided)
        return;
    // From the brush as it was, so that the way back leads to it.
    Brush brush = m_editor.brush();
    brush.diffusion = m_resizing->brush.diffusion;
    brush.colour.opacity = m_resizing->brush.colour.opacity;
    m_editor.setBrush(brush);
    if (m_resizing->what == Resizing::Size)
        scaleSize(std::exp2(way.x / doubling));
    else
        addOpacity(-way.y / wholeOpacity);
}

void BrushTool::showNote(const QString &note, bool stays)
{
    m_note = note;
    if (stays || note.isEmpty())
        m_noteTimer.stop();
    else
        m_noteTimer.start(noteMs, this);
    m_canvas.updateOverlay();
}

void BrushTool::timerEvent(QTimerEvent *event)
{
    if (event->timerId() == m_noteTimer.timerId())
        showNote({}, false);
}

void BrushTool::paintNote(QPainter &painter, double dpr) const
{
    if (m_note.isEmpty() || !m_hovering)
        return;
    const Brush &brush = m_editor.brush();
    const double circle = std::max(brush.spread(), halfWidthOf(brush)) * m_canvas.view().scale;
    paintBadge(painter, m_note, m_pixel, circle, m_canvas.view(), dpr);
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
