#include "app/widgets/brush/pen_pad.h"

#include "app/widgets/habits/held_button.h"
#include "app/widgets/look/theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QTabletEvent>

namespace suffuse {

namespace {
constexpr std::size_t mostTriedStrokes = 60;
constexpr Microseconds penSampleTime = 8'000; ///< time from one report to the next, about that of pens
} // namespace

PenPad::PenPad(const Brush &brush, QWidget *parent) : QWidget(parent), m_brush(brush)
{
    endDragsWhenCovered(*this);
    setCursor(Qt::CrossCursor);
    setMinimumSize(160, 120);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PenPad::setCurve(const ResponseCurve &curve)
{
    m_pressure.setCurve(curve);
}

void PenPad::clear()
{
    m_builder.reset();
    m_strokes.clear();
    draw();
}

void PenPad::press(QPointF at, double pressure)
{
    m_builder = std::make_unique<StrokeBuilder>(m_brush, m_nextId++);
    add(at, pressure);
}

void PenPad::add(QPointF at, double pressure)
{
    m_time += penSampleTime;
    m_builder->add({.position = {at.x(), at.y()}, .time = m_time, .pressure = float(pressure)});
    draw();
}

void PenPad::release()
{
    emit lifted();
    if (!m_builder)
        return;
    m_builder->finish();
    if (StrokePtr stroke = m_builder->stroke())
        m_strokes.push_back(std::move(stroke));
    m_builder.reset();
    if (m_strokes.size() > mostTriedStrokes)
        m_strokes.erase(m_strokes.begin());
    draw();
}

void PenPad::draw()
{
    std::vector<StrokePtr> strokes = m_strokes;
    if (const StrokePtr stroke = m_builder ? m_builder->stroke() : nullptr)
        strokes.push_back(stroke);
    if (m_sheet.draw(strokes, size(), devicePixelRatioF()))
        update();
}

void PenPad::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath sheet;
    sheet.addRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    painter.setClipPath(sheet);
    painter.drawImage(rect(), m_sheet.image());
    painter.setClipping(false);
    painter.strokePath(sheet, QPen(hairline(), 1));
    if (m_strokes.empty() && !m_builder) {
        painter.setPen(QColor(0x60, 0x60, 0x60));
        painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Try your pen here."));
    }
}

void PenPad::resizeEvent(QResizeEvent *)
{
    draw();
}

void PenPad::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton && !m_builder)
        press(event->position(), 1);
}

void PenPad::mouseMoveEvent(QMouseEvent *event)
{
    if (m_builder)
        add(event->position(), 1);
}

void PenPad::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        release();
}

void PenPad::tabletEvent(QTabletEvent *event)
{
    event->accept();
    const bool begins = event->type() == QEvent::TabletPress && !m_builder;
    if (!begins && !m_builder)
        return;
    if (event->type() == QEvent::TabletRelease)
        return release();
    const bool sensitive = event->device()->hasCapability(QInputDevice::Capability::Pressure);
    const double pressure = m_pressure.take(event->pressure(), begins, sensitive);
    emit pressureReported(event->pressure());
    if (begins)
        press(event->position(), pressure);
    else
        add(event->position(), pressure);
}

} // namespace suffuse
