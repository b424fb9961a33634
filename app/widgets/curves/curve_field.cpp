#include "app/widgets/curves/curve_field.h"

#include "app/widgets/habits/held_button.h"
#include "app/widgets/look/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace suffuse {

namespace {
constexpr double fieldMargin = 10;
constexpr double knotRadius = 4.5;
constexpr double textGap = 4; ///< between field and texts
} // namespace

CurveField::CurveField(QWidget *parent) : QWidget(parent)
{
    endDragsWhenCovered(*this);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void CurveField::setTexts(const QString &above, const QString &left, const QString &right)
{
    m_above = above;
    m_left = left;
    m_right = right;
    update();
}

void CurveField::setUpsideDown(bool upsideDown)
{
    m_upsideDown = upsideDown;
    update();
}

QRectF CurveField::field() const
{
    const double line = fontMetrics().height() + textGap;
    const bool under = !m_left.isEmpty() || !m_right.isEmpty();
    return QRectF(rect()).adjusted(fieldMargin, fieldMargin + (m_above.isEmpty() ? 0 : line), -fieldMargin,
                                   -fieldMargin - (under ? line : 0));
}

QPointF CurveField::toWidget(QPointF at) const
{
    const QRectF f = field();
    const double up = m_upsideDown ? 1 - at.y() : at.y();
    return {f.left() + f.width() * at.x(), f.bottom() - f.height() * up};
}

QPointF CurveField::fromWidget(QPointF at) const
{
    const QRectF f = field();
    const double up = std::clamp((f.bottom() - at.y()) / f.height(), 0.0, 1.0);
    return {std::clamp((at.x() - f.left()) / f.width(), 0.0, 1.0), m_upsideDown ? 1 - up : up};
}

bool CurveField::event(QEvent *event)
{
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (!m_dragging || !isKey || !givesUpDrag(*static_cast<QKeyEvent *>(event)))
        return QWidget::event(event);
    event->accept(); // The dialog around the field stays open.
    if (event->type() == QEvent::KeyPress) {
        m_dragging = false;
        takeBack();
        update();
        emit givenUp();
    }
    return true;
}

void CurveField::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton && std::exchange(m_dragging, false))
        emit released();
}

QColor CurveField::accent() const
{
    return palette().color(isDarkTheme() ? QPalette::Link : QPalette::Highlight);
}

void CurveField::paintField(QPainter &painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette &colours = palette();
    painter.setPen(hasFocus() ? focusFrame() : hairline());
    painter.setBrush(colours.color(QPalette::Base));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    painter.setPen(QPen(hairline(), 1, Qt::DotLine));
    for (int i = 0; i <= 4; ++i) {
        painter.drawLine(toWidget({0, i / 4.0}), toWidget({1, i / 4.0}));
        painter.drawLine(toWidget({i / 4.0, 0}), toWidget({i / 4.0, 1}));
    }
    painter.setPen(colours.color(QPalette::PlaceholderText));
    const QRectF f = field();
    const double line = fontMetrics().height();
    const QRectF under(f.left(), f.bottom() + textGap, f.width(), line);
    painter.drawText(QRectF(f.left(), f.top() - line - textGap, f.width(), line), Qt::AlignLeft, m_above);
    painter.drawText(under, Qt::AlignLeft, m_left);
    painter.drawText(under, Qt::AlignRight, m_right);
}

void CurveField::paintCurve(QPainter &painter, const QPainterPath &path) const
{
    painter.strokePath(path, QPen(accent(), 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}

void CurveField::paintKnot(QPainter &painter, QPointF at, bool chosen) const
{
    painter.setPen(QPen(accent(), 2));
    painter.setBrush(chosen ? accent() : palette().color(QPalette::Base));
    painter.drawEllipse(toWidget(at), knotRadius, knotRadius);
}

} // namespace suffuse
