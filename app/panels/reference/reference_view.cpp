#include "app/panels/reference/reference_view.h"

#include "app/widgets/look/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr double largestScale = 64, smallestScale = 1.0 / 256;
constexpr double zoomPerNotch = 1.25;
constexpr double crossStep = 4, wideCrossStep = 24; ///< logical pixels
constexpr double crossArm = 7;

} // namespace

ReferenceView::ReferenceView(QWidget *parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(120, 80);
    setMouseTracking(true);
    setAccessibleName(tr("Reference picture"));
    setAccessibleDescription(tr("Arrow keys move a cross, and Return picks the colour there."));
}

void ReferenceView::setPicture(const QImage &picture)
{
    m_picture = picture.convertToFormat(QImage::Format_ARGB32_Premultiplied);
    m_cross.reset();
    fit();
}

void ReferenceView::fit()
{
    m_isFitted = true;
    const QSizeF size = m_picture.size();
    m_middle = QPointF(size.width() / 2, size.height() / 2);
    if (!m_picture.isNull())
        m_scale = std::clamp(std::min(width() / size.width(), height() / size.height()), smallestScale, largestScale);
    update();
}

QTransform ReferenceView::toWidget() const
{
    return QTransform::fromTranslate(-m_middle.x(), -m_middle.y()) * QTransform::fromScale(m_scale, m_scale) *
           QTransform::fromTranslate(width() / 2.0, height() / 2.0);
}

void ReferenceView::zoomBy(double factor, QPointF at)
{
    const QPointF pixel = toWidget().inverted().map(at);
    m_scale = std::clamp(m_scale * factor, smallestScale, largestScale);
    m_middle += pixel - toWidget().inverted().map(at);
    m_isFitted = false;
    update();
}

std::optional<QColor> ReferenceView::colourAt(QPointF at) const
{
    const QPointF place = toWidget().inverted().map(at);
    const QPoint pixel(int(std::floor(place.x())), int(std::floor(place.y())));
    if (!m_picture.valid(pixel))
        return std::nullopt;
    QColor colour = m_picture.pixelColor(pixel);
    if (colour.alpha() == 0)
        return std::nullopt;
    colour.setAlpha(255);
    return colour;
}

bool ReferenceView::picksWith(Qt::KeyboardModifiers modifiers) const
{
    return (modifiers & (Qt::ControlModifier | Qt::AltModifier)) || (m_picks && m_picks());
}

void ReferenceView::pickAt(QPointF at)
{
    if (const std::optional<QColor> colour = colourAt(at))
        emit picked(*colour);
}

void ReferenceView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    if (m_picture.isNull()) {
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Drop a picture here to look at it while you paint, and to take colours from it."));
    } else {
        painter.setRenderHint(QPainter::SmoothPixmapTransform, m_scale < 4);
        painter.setTransform(toWidget(), true);
        painter.drawImage(QPointF(0, 0), m_picture);
        painter.resetTransform();
    }
    if (!hasFocus())
        return;
    if (m_cross && !m_picture.isNull()) {
        const QPointF c = *m_cross;
        const QLineF lines[] = {{c - QPointF(crossArm, 0), c + QPointF(crossArm, 0)},
                                {c - QPointF(0, crossArm), c + QPointF(0, crossArm)}};
        for (const QPen &pen : {QPen(Qt::white, 3), QPen(Qt::black, 1)}) {
            painter.setPen(pen);
            painter.drawLines(lines, 2);
        }
    }
    painter.setPen(QPen(focusFrame(), 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

void ReferenceView::resizeEvent(QResizeEvent *)
{
    if (m_isFitted)
        fit();
}

void ReferenceView::mousePressEvent(QMouseEvent *event)
{
    if (m_picture.isNull() || m_held != Held::Nothing)
        return;
    const bool picks = event->button() == Qt::LeftButton && picksWith(event->modifiers());
    if (!picks && event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton)
        return event->ignore();
    m_held = picks ? Held::Colour : Held::Picture;
    m_last = event->position();
    if (picks)
        pickAt(m_last);
    setCursor(picks ? Qt::CrossCursor : Qt::ClosedHandCursor);
}

void ReferenceView::mouseMoveEvent(QMouseEvent *event)
{
    if (m_held == Held::Colour)
        pickAt(event->position());
    if (m_held == Held::Picture) {
        m_middle -= (event->position() - m_last) / m_scale;
        m_isFitted = false;
        update();
    }
    if (m_held == Held::Nothing)
        setCursor(m_picture.isNull()              ? Qt::ArrowCursor
                  : picksWith(event->modifiers()) ? Qt::CrossCursor
                                                  : Qt::OpenHandCursor);
    m_last = event->position();
}

void ReferenceView::mouseReleaseEvent(QMouseEvent *)
{
    m_held = Held::Nothing;
    unsetCursor();
}

void ReferenceView::wheelEvent(QWheelEvent *event)
{
    event->accept();
    if (!m_picture.isNull())
        zoomBy(std::pow(zoomPerNotch, event->angleDelta().y() / 120.0), event->position());
}

void ReferenceView::moveCross(QPointF by)
{
    const QPointF from = m_cross.value_or(QPointF(width() / 2.0, height() / 2.0));
    m_cross =
        QPointF(std::clamp(from.x() + by.x(), 0.0, width() - 1.0), std::clamp(from.y() + by.y(), 0.0, height() - 1.0));
    update();
}

void ReferenceView::keyPressEvent(QKeyEvent *event)
{
    const double step = event->modifiers() & Qt::ShiftModifier ? wideCrossStep : crossStep;
    const QPointF middle(width() / 2.0, height() / 2.0);
    switch (event->key()) {
    case Qt::Key_Left:
        return moveCross({-step, 0});
    case Qt::Key_Right:
        return moveCross({step, 0});
    case Qt::Key_Up:
        return moveCross({0, -step});
    case Qt::Key_Down:
        return moveCross({0, step});
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return pickAt(m_cross.value_or(middle));
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoomBy(zoomPerNotch, m_cross.value_or(middle));
    case Qt::Key_Minus:
        return zoomBy(1 / zoomPerNotch, m_cross.value_or(middle));
    case Qt::Key_0:
        return fit();
    default:
        QWidget::keyPressEvent(event);
    }
}

void ReferenceView::focusInEvent(QFocusEvent *event)
{
    update();
    QWidget::focusInEvent(event);
}

void ReferenceView::focusOutEvent(QFocusEvent *event)
{
    update();
    QWidget::focusOutEvent(event);
}

void ReferenceView::enterEvent(QEnterEvent *event)
{
    setCursor(m_picture.isNull() ? Qt::ArrowCursor : picksWith({}) ? Qt::CrossCursor : Qt::OpenHandCursor);
    QWidget::enterEvent(event);
}

} // namespace suffuse
