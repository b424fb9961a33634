#include "app/tools/sized_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "app/tools/tool_fields.h"
#include "app/widgets/numbers/number_field.h"

#include <QHBoxLayout>
#include <QPainter>

namespace suffuse {

namespace {

constexpr double edge = 4; ///< pixels beside the circle that the pen of the ring takes

} // namespace

SizedTool::SizedTool(const QString &name, double radius, CanvasWidget &canvas, QObject *parent)
    : CanvasTool(canvas, parent), m_name(QStringLiteral("tools/%1Radius").arg(name)), m_radius(radius)
{
    const double stored = settings::store().value(m_name, radius).toDouble();
    if (stored >= leastRadius && stored <= greatestRadius)
        m_radius = stored;
    connect(&m_editor.document(), &Document::changed, this, [this](const Change &change) {
        if (change.selection) // Another selection changes what the tool works on, and so its hint.
            emit hintChanged();
    });
}

void SizedTool::setRadius(double radius)
{
    radius = std::clamp(radius, leastRadius, greatestRadius);
    if (radius == m_radius)
        return;
    repaintCircle();
    m_radius = radius;
    repaintCircle();
    settings::store().setValue(m_name, radius);
    if (m_field)
        m_field->setValue(2 * m_radius);
}

void SizedTool::addSizeField(QHBoxLayout &row)
{
    m_field = addNumber(row, tr("Size"), tr("Diameter of the circle ([ and ] change it)"),
                        [this](double size) { setRadius(0.5 * size); });
    m_field->setRange(2 * leastRadius, 2 * greatestRadius);
    m_field->setDisplay(lengthDisplay());
    m_field->setValue(2 * m_radius);
}

void SizedTool::stepSize(int steps)
{
    setRadius(m_radius * std::pow(sizeStep, steps));
}

void SizedTool::hover(const PointerEvent &event)
{
    showCircleAt(event.pixel);
}

void SizedTool::leave()
{
    repaintCircle();
    m_shown = false;
}

void SizedTool::showCircleAt(Point pixel)
{
    repaintCircle();
    m_pixel = pixel;
    m_shown = true;
    repaintCircle();
}

void SizedTool::repaintCircle()
{
    if (!m_shown)
        return;
    const double r = m_radius * m_canvas.view().scale + edge * m_canvas.devicePixelRatioF();
    m_canvas.updateOverlay(QRectF(m_pixel.x - r, m_pixel.y - r, 2 * r, 2 * r));
}

void SizedTool::paintSoftRing(QPainter &painter, double share, const View &view, double dpr) const
{
    const double r = share * m_radius * view.scale;
    if (!m_shown || !(r > 4 * dpr && r < 2.0 * (view.width + view.height)))
        return;
    painter.setOpacity(0.45);
    paintRing(painter, m_pixel.x, m_pixel.y, r, dpr);
    painter.setOpacity(1);
}

void SizedTool::paint(QPainter &painter, const View &view, double dpr) const
{
    const double r = m_radius * view.scale;
    // A smaller ring would be a point, and a larger one lies all around the window.
    if (m_shown && r > 2 * dpr && r < 2.0 * (view.width + view.height))
        paintRing(painter, m_pixel.x, m_pixel.y, r, dpr);
}

} // namespace suffuse
