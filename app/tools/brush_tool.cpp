#include "app/tools/brush_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/editor.h"
#include "model/validate.h"
#include "undo/edits.h"

#include <QPainter>

namespace suffuse {

namespace {

/// Density φ′ at the visible edge of a style (eq 17-19).
double edgeDensity(const Style &style)
{
    const double xi1 = style.xi[0], xi2 = style.xi[1], xi3 = style.xi[2];
    switch (style.kind) {
    case StyleKind::Uniform:
        return xi1;
    case StyleKind::Feathering:
        return xi1 * std::pow(0.5, 1 / xi2);
    case StyleKind::Edge: {
        const double a = std::pow(xi2, 3), b = std::pow(xi1, 6);
        return std::cbrt(2 * b / (a + std::sqrt(std::max(0.0, a * a - 4 * b * (1 - 1 / xi3)))));
    }
    }
    return xi1;
}

} // namespace

double halfWidthOf(const Brush &brush)
{
    const double ratio = brush.peak / edgeDensity(brush.style);
    return ratio > 1 ? brush.spread() * std::sqrt(std::log(ratio)) : 0;
}

BrushTool::BrushTool(CanvasWidget &canvas, QObject *parent) : Tool(canvas, parent)
{
    connect(&m_editor, &Editor::brushChanged, this, [this] { m_canvas.updateOverlay(); });
}

BrushTool::~BrushTool() = default;

QString BrushTool::hint() const
{
    return tr("Drag to paint; a tap leaves a dot. Esc gives the stroke up.");
}

void BrushTool::press(const PointerEvent &event)
{
    m_builder = std::make_unique<StrokeBuilder>(m_editor.brush(), m_editor.document().takeStrokeId());
    m_lastTime = event.time;
    m_editor.holdClock(true);
    add(event);
    showOutlineAt(event.pixel);
}

void BrushTool::add(const PointerEvent &event)
{
    m_lastTime = std::max(m_lastTime, event.time);
    m_builder->add(PenSample{event.point, m_lastTime, float(event.pressure)});
    m_editor.document().setDraft(m_builder->stroke());
}

void BrushTool::move(const PointerEvent &event)
{
    if (m_builder)
        add(event);
    showOutlineAt(event.pixel);
}

void BrushTool::release(const PointerEvent &event)
{
    if (!m_builder)
        return;
    if (event.device == PointerDevice::Mouse || event.pressure > 0) // a pen lifts with pressure 0, which is no paint
        m_builder->add(PenSample{event.point, std::max(m_lastTime, event.time), float(event.pressure)});
    m_builder->finish();
    const StrokePtr stroke = m_builder->stroke();
    m_builder.reset();
    Document &document = m_editor.document();
    document.setDraft(nullptr);
    if (stroke && problemOf(*stroke).isEmpty())
        m_editor.push(addStrokes(document, {stroke}, false), tr("Brush stroke"));
    m_editor.holdClock(false);
    showOutlineAt(event.pixel);
}

void BrushTool::cancel()
{
    if (!m_builder)
        return;
    m_builder.reset();
    m_editor.document().setDraft(nullptr);
    m_editor.holdClock(false);
}

void BrushTool::hover(const PointerEvent &event)
{
    showOutlineAt(event.pixel);
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

void BrushTool::showOutlineAt(Point pixel)
{
    if (m_hovering)
        m_canvas.updateOverlay(outlineBox());
    m_pixel = pixel;
    m_hovering = true;
    m_canvas.updateOverlay(outlineBox());
}

void BrushTool::paint(QPainter &painter, const View &view, double dpr) const
{
    if (!m_hovering)
        return;
    const auto ring = [&](double radius, Qt::PenStyle style, int alpha) {
        const double r = radius * view.scale;
        if (r < 3 * dpr || r > 2.0 * (view.width + view.height))
            return; // too small to tell from the cross, or all around the window
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor(255, 255, 255, alpha), 2.2 * dpr));
        painter.drawEllipse(QPointF(m_pixel.x, m_pixel.y), r, r);
        painter.setPen(QPen(QColor(20, 20, 24, alpha), dpr, style));
        painter.drawEllipse(QPointF(m_pixel.x, m_pixel.y), r, r);
    };
    const Brush &brush = m_editor.brush();
    ring(brush.spread(), Qt::DotLine, 110);
    ring(halfWidthOf(brush), Qt::SolidLine, 200);
}

} // namespace suffuse
