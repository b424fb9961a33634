#include "app/widgets/curves/curve_editor.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {
constexpr double keyStep = 0.01;
} // namespace

double PlaceCurve::at(double place) const
{
    if (knots.size() == 1)
        return knots.front();
    const double x = std::clamp(place, 0.0, 1.0) * double(knots.size() - 1);
    const std::size_t i = std::min(std::size_t(x), knots.size() - 2);
    return std::lerp(knots[i], knots[i + 1], x - double(i));
}

void CurveEditor::setCurve(const PlaceCurve &curve)
{
    m_curve = curve;
    m_knot = std::min(m_knot, m_curve.knots.size() - 1);
    update();
}

void CurveEditor::setPresent(std::vector<QPointF> dots)
{
    m_present = std::move(dots);
    update();
}

void CurveEditor::setAxis(const QString &low, const QString &high)
{
    setTexts(high, low, tr("along the stroke →"));
}

void CurveEditor::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    m_dragging = true;
    m_before = m_curve;
    m_last = fromWidget(event->position());
    m_knot = m_curve.knots.size() == 2 && m_last.x() > 0.5 ? 1 : 0;
    dragTo(m_last);
}

void CurveEditor::mouseMoveEvent(QMouseEvent *event)
{
    if (m_dragging)
        dragTo(fromWidget(event->position()));
}

void CurveEditor::dragTo(QPointF at)
{
    if (m_curve.knots.size() > 2)
        drawTo(at);
    else
        m_curve.knots[m_knot] = at.y();
    m_last = at;
    update();
    emit edited();
}

void CurveEditor::drawTo(QPointF to)
{
    // This sets all knots that the pointer passed since the last report.
    const double last = double(m_curve.knots.size() - 1);
    const QPointF from = m_last;
    const double low = std::min(from.x(), to.x()), high = std::max(from.x(), to.x());
    for (int i = int(std::lround(low * last)); i <= int(std::lround(high * last)); ++i) {
        const double share = to.x() == from.x() ? 1 : std::clamp((i / last - from.x()) / (to.x() - from.x()), 0.0, 1.0);
        m_curve.knots[std::size_t(i)] = std::lerp(from.y(), to.y(), share);
    }
}

void CurveEditor::keyPressEvent(QKeyEvent *event)
{
    const bool up = event->key() == Qt::Key_Up, down = event->key() == Qt::Key_Down;
    if (m_curve.knots.size() == 2 && (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right)) {
        m_knot = event->key() == Qt::Key_Right ? 1 : 0;
        update();
    } else if ((up || down) && m_curve.knots.size() <= 2) {
        const double step = keyStep * (event->modifiers() & Qt::ShiftModifier ? 10 : 1);
        double &value = m_curve.knots[m_knot];
        value = std::clamp(value + (up ? step : -step), 0.0, 1.0);
        update();
        emit edited();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void CurveEditor::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    paintField(painter);
    QColor dot = palette().color(QPalette::PlaceholderText);
    dot.setAlpha(150);
    painter.setPen(Qt::NoPen);
    painter.setBrush(dot);
    for (const QPointF &p : m_present)
        painter.drawEllipse(toWidget(p), 1.8, 1.8);

    const std::size_t n = m_curve.knots.size();
    QPainterPath path(toWidget({0, m_curve.at(0)}));
    for (std::size_t i = 1; i < std::max<std::size_t>(n, 2); ++i) {
        const double x = double(i) / double(std::max<std::size_t>(n, 2) - 1);
        path.lineTo(toWidget({x, m_curve.at(x)}));
    }
    paintCurve(painter, path);
    for (std::size_t i = 0; i < n && n <= 2; ++i)
        paintKnot(painter, {n == 1 ? 0.5 : double(i), m_curve.knots[i]}, i == m_knot);
}

} // namespace suffuse
