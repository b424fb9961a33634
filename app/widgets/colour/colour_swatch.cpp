#include "app/widgets/colour/colour_swatch.h"

#include "app/session/colour_convert.h"
#include "app/widgets/habits/held_button.h"
#include "app/widgets/look/theme.h"

#include <QApplication>
#include <QDrag>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

namespace suffuse {

void paintColour(QPainter &painter, const QPainterPath &shape, const Colour &colour)
{
    painter.fillPath(shape, toOpaqueScreen(colour));
    if (colour.opacity == 1)
        return;
    // The left half shows the opaque colour, the right half the colour over checks.
    const QRectF area = shape.boundingRect();
    const QRectF half(area.center().x(), area.top(), area.width() / 2, area.height());
    painter.save();
    painter.setClipPath(shape);
    painter.fillRect(half, Qt::white);
    painter.fillRect(QRectF(half.topLeft(), half.center()), QColor(0xBB, 0xBB, 0xBB));
    painter.fillRect(QRectF(half.center(), half.bottomRight()), QColor(0xBB, 0xBB, 0xBB));
    painter.fillRect(half, toScreen(colour));
    painter.restore();
}

ColourSwatch::ColourSwatch(QWidget *parent) : QAbstractButton(parent)
{
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void ColourSwatch::setColour(std::optional<Colour> colour)
{
    m_colour = colour;
    update();
}

void ColourSwatch::setOther(std::optional<Colour> other)
{
    m_other = other;
    update();
}

void ColourSwatch::setSide(int pixels)
{
    m_side = pixels;
    updateGeometry();
}

QSize ColourSwatch::sizeHint() const
{
    return {m_side, m_side};
}

void ColourSwatch::mousePressEvent(QMouseEvent *event)
{
    m_pressed = event->pos();
    QAbstractButton::mousePressEvent(event);
}

void ColourSwatch::mouseMoveEvent(QMouseEvent *event)
{
    const bool far = (event->pos() - m_pressed).manhattanLength() >= QApplication::startDragDistance();
    if (!(event->buttons() & Qt::LeftButton) || !m_colour || !far) {
        QAbstractButton::mouseMoveEvent(event);
        return;
    }
    setDown(false); // the press has become a drag and is no click any more
    auto *drag = new QDrag(this);
    drag->setMimeData(dragDataOf(*m_colour));
    drag->setPixmap(grab());
    drag->setHotSpot(m_pressed);
    const KeysEndDrag ends;
    drag->exec(Qt::CopyAction);
}

void ColourSwatch::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5);
    QPainterPath shape;
    shape.addRoundedRect(area, 3, 3);
    if (m_colour) {
        paintColour(painter, shape, *m_colour);
        if (m_other) {
            QPainterPath half;
            half.addPolygon(QPolygonF({area.topRight(), area.bottomRight(), area.bottomLeft()}));
            painter.fillPath(shape.intersected(half), toOpaqueScreen(*m_other));
        }
    } else {
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(rect(), Qt::AlignCenter, QStringLiteral("—"));
    }
    const bool marked = hasFocus() || isDown();
    painter.strokePath(shape, QPen(marked ? focusFrame() : edgeOfColours(), marked ? 2 : 1));
}

} // namespace suffuse
