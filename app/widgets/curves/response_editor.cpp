#include "app/widgets/curves/response_editor.h"

#include "app/widgets/look/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {
constexpr double reach = 10;         ///< the pointer takes hold of a point within so many logical pixels
constexpr double outside = 30;       ///< a point dragged so far beyond the field is taken away
constexpr float pointsApart = 0.01f; ///< least distance between points
} // namespace

void ResponseEditor::setCurve(const ResponseCurve &curve)
{
    m_curve = curve;
    m_point = std::min(m_point, m_curve.points.size() - 1);
    update();
}

void ResponseEditor::setMark(std::optional<double> input)
{
    m_mark = input;
    update();
}

int ResponseEditor::pointAt(QPointF at) const
{
    int found = -1;
    double nearest = reach;
    for (std::size_t i = 0; i < m_curve.points.size(); ++i) {
        const QPointF d = toWidget({m_curve.points[i].x, m_curve.points[i].y}) - at;
        if (const double distance = std::hypot(d.x(), d.y()); distance <= nearest)
            nearest = distance, found = int(i);
    }
    return found;
}

void ResponseEditor::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    m_before = m_curve;
    const int there = pointAt(event->position());
    if (there >= 0) {
        m_point = std::size_t(there);
    } else {
        auto &points = m_curve.points;
        const QPointF at = fromWidget(event->position());
        const auto next = std::find_if(points.begin(), points.end(), [&](Offset p) { return double(p.x) > at.x(); });
        const bool room = points.size() < ResponseCurve::mostPoints &&
                          (next == points.end() || double(next->x) - at.x() > double(pointsApart)) &&
                          (next == points.begin() || at.x() - double(std::prev(next)->x) > double(pointsApart));
        if (!room)
            return;
        m_point = std::size_t(next - points.begin());
        points.insert(next, Offset{float(at.x()), float(at.y())});
        emit edited();
    }
    m_dragging = true;
    update();
}

void ResponseEditor::mouseMoveEvent(QMouseEvent *event)
{
    if (!m_dragging)
        return;
    if (!field().adjusted(-outside, -outside, outside, outside).contains(event->position()) && removePoint())
        m_dragging = false;
    else
        movePoint(fromWidget(event->position()));
    emit edited();
}

void ResponseEditor::movePoint(QPointF to)
{
    auto &points = m_curve.points;
    const float low = m_point > 0 ? points[m_point - 1].x + pointsApart : 0;
    const float high = m_point + 1 < points.size() ? points[m_point + 1].x - pointsApart : 1;
    points[m_point] = {std::clamp(float(to.x()), std::min(low, high), high), float(std::clamp(to.y(), 0.0, 1.0))};
    update();
}

bool ResponseEditor::removePoint()
{
    if (m_curve.points.size() <= 2)
        return false;
    m_curve.points.erase(m_curve.points.begin() + std::ptrdiff_t(m_point));
    m_point = std::min(m_point, m_curve.points.size() - 1);
    update();
    return true;
}

void ResponseEditor::keyPressEvent(QKeyEvent *event)
{
    const Offset at = m_curve.points[m_point];
    const double step = event->modifiers() & Qt::ShiftModifier ? 0.1 : 0.01;
    switch (event->key()) {
    case Qt::Key_PageUp:
    case Qt::Key_PageDown: {
        const bool next = event->key() == Qt::Key_PageUp;
        m_point = next ? std::min(m_point + 1, m_curve.points.size() - 1) : m_point - (m_point > 0);
        return update();
    }
    case Qt::Key_Left:
        movePoint({double(at.x) - step, at.y});
        break;
    case Qt::Key_Right:
        movePoint({double(at.x) + step, at.y});
        break;
    case Qt::Key_Up:
        movePoint({at.x, double(at.y) + step});
        break;
    case Qt::Key_Down:
        movePoint({at.x, double(at.y) - step});
        break;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        if (!removePoint())
            return;
        break;
    default:
        return QWidget::keyPressEvent(event);
    }
    emit edited();
}

void ResponseEditor::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    paintField(painter);
    const QRectF f = field();
    QPainterPath path(toWidget({0, m_curve.at(0)}));
    for (int x = 1; x <= int(f.width()); ++x)
        path.lineTo(toWidget({x / f.width(), m_curve.at(x / f.width())}));
    paintCurve(painter, path);
    for (std::size_t i = 0; i < m_curve.points.size(); ++i)
        paintKnot(painter, {m_curve.points[i].x, m_curve.points[i].y}, i == m_point);
    if (m_mark) {
        const QPointF at = toWidget({*m_mark, m_curve.at(*m_mark)});
        painter.setPen(QPen(warningText(), 1.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawLine(QPointF(at.x(), f.bottom()), at);
        painter.drawEllipse(at, 6, 6);
    }
}

} // namespace suffuse
