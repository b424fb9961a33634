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
constexpr double pointReach = 9;            ///< logical pixels around a point
constexpr double leastPointGap = 1.0 / 512; ///< between two points

/// Between values that are evenly spread over [0, 1].
double evenlyAt(const std::vector<double> &values, double place)
{
    if (values.size() == 1)
        return values.front();
    const double x = std::clamp(place, 0.0, 1.0) * double(values.size() - 1);
    const std::size_t i = std::min(std::size_t(x), values.size() - 2);
    return std::lerp(values[i], values[i + 1], x - double(i));
}
} // namespace

double PlaceCurve::at(double place) const
{
    if (places.empty())
        return evenlyAt(knots, place);
    const auto after = std::ranges::upper_bound(places, place);
    if (after == places.begin())
        return knots.front();
    if (after == places.end())
        return knots.back();
    const auto i = std::size_t(after - places.begin());
    return std::lerp(knots[i - 1], knots[i], (place - places[i - 1]) / (places[i] - places[i - 1]));
}

double PlaceCurve::drawnAt(double place) const
{
    return drawn.empty() ? 1 : evenlyAt(drawn, place);
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
    if (m_curve.isPoints()) {
        takePoint(event->position());
        return;
    }
    m_knot = m_curve.knots.size() == 2 && m_last.x() > 0.5 ? 1 : 0;
    dragTo(m_last);
}

int CurveEditor::pointAt(QPointF pointer) const
{
    int nearest = -1;
    double least = pointReach;
    for (std::size_t i = 0; i < m_curve.places.size(); ++i)
        if (const double off = QLineF(toWidget({m_curve.places[i], m_curve.knots[i]}), pointer).length(); off < least) {
            least = off;
            nearest = int(i);
        }
    return nearest;
}

void CurveEditor::takePoint(QPointF pointer)
{
    const int point = pointAt(pointer);
    if (point >= 0) {
        m_knot = std::size_t(point);
        update();
        return;
    }
    // A new point begins on the curve, so that a press alone changes nothing, and follows the pointer from there.
    const auto after = std::ranges::upper_bound(m_curve.places, m_last.x());
    const auto i =
        std::clamp<std::ptrdiff_t>(after - m_curve.places.begin(), 1, std::ptrdiff_t(m_curve.places.size()) - 1);
    const double from = m_curve.places[std::size_t(i) - 1], to = m_curve.places[std::size_t(i)];
    if (to - from < 2 * leastPointGap)
        return;
    const double place = std::clamp(m_last.x(), from + leastPointGap, to - leastPointGap);
    m_curve.knots.insert(m_curve.knots.begin() + i, m_curve.at(place));
    m_curve.places.insert(m_curve.places.begin() + i, place);
    m_knot = std::size_t(i);
    update();
}

void CurveEditor::removePoint(std::size_t point)
{
    if (point == 0 || point + 1 >= m_curve.places.size())
        return; // a curve goes from end to end
    m_curve.knots.erase(m_curve.knots.begin() + std::ptrdiff_t(point));
    m_curve.places.erase(m_curve.places.begin() + std::ptrdiff_t(point));
    m_knot = std::min(m_knot, m_curve.knots.size() - 1);
    update();
    emit edited();
    emit released();
}

void CurveEditor::mouseDoubleClickEvent(QMouseEvent *event)
{
    const int point = m_curve.isPoints() ? pointAt(event->position()) : -1;
    if (point > 0 && event->button() == Qt::LeftButton)
        removePoint(std::size_t(point));
    else
        mousePressEvent(event);
}

void CurveEditor::mouseMoveEvent(QMouseEvent *event)
{
    if (m_dragging)
        dragTo(fromWidget(event->position()));
}

void CurveEditor::dragTo(QPointF at)
{
    if (m_curve.isPoints()) {
        std::vector<double> &places = m_curve.places;
        if (m_knot > 0 && m_knot + 1 < places.size())
            places[m_knot] = std::clamp(at.x(), places[m_knot - 1] + leastPointGap, places[m_knot + 1] - leastPointGap);
        m_curve.knots[m_knot] = at.y();
    } else if (m_curve.knots.size() > 2)
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
        if (!m_curve.drawn.empty())
            m_curve.drawn[std::size_t(i)] = 1;
    }
}

void CurveEditor::keyPressEvent(QKeyEvent *event)
{
    const bool up = event->key() == Qt::Key_Up, down = event->key() == Qt::Key_Down;
    const bool removes = event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace;
    const bool aside = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right;
    if (m_curve.isPoints() && removes) {
        removePoint(m_knot);
    } else if (m_curve.isPoints() && aside && event->modifiers() & Qt::ControlModifier) {
        const bool right = event->key() == Qt::Key_Right;
        m_knot = right ? std::min(m_knot + 1, m_curve.knots.size() - 1) : m_knot - std::min<std::size_t>(m_knot, 1);
        update();
    } else if (m_curve.isPoints() && aside) {
        stepPlace(event->key() == Qt::Key_Right ? keyStep : -keyStep);
    } else if (!m_curve.isPoints() && m_curve.knots.size() == 2 &&
               (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right)) {
        m_knot = event->key() == Qt::Key_Right ? 1 : 0;
        update();
    } else if ((up || down) && (m_curve.isPoints() || m_curve.knots.size() <= 2)) {
        const double step = keyStep * (event->modifiers() & Qt::ShiftModifier ? 10 : 1);
        double &value = m_curve.knots[m_knot];
        value = std::clamp(value + (up ? step : -step), 0.0, 1.0);
        update();
        emit edited();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void CurveEditor::stepPlace(double by)
{
    std::vector<double> &places = m_curve.places;
    if (m_knot == 0 || m_knot + 1 >= places.size())
        return;
    places[m_knot] =
        std::clamp(places[m_knot] + by, places[m_knot - 1] + leastPointGap, places[m_knot + 1] - leastPointGap);
    update();
    emit edited();
}

bool CurveEditor::event(QEvent *event)
{
    // Del removes a point, not the strokes.
    if (event->type() == QEvent::ShortcutOverride && m_curve.isPoints()) {
        const int key = static_cast<QKeyEvent *>(event)->key();
        if (key == Qt::Key_Delete || key == Qt::Key_Backspace) {
            event->accept();
            return true;
        }
    }
    return CurveField::event(event);
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
        const double x = m_curve.isPoints() ? m_curve.places[i] : double(i) / double(std::max<std::size_t>(n, 2) - 1);
        path.lineTo(toWidget({x, m_curve.at(x)}));
    }
    paintCurve(painter, path);
    for (std::size_t i = 0; i < m_curve.places.size(); ++i)
        paintKnot(painter, {m_curve.places[i], m_curve.knots[i]}, i == m_knot);
    if (m_curve.isPoints())
        return;
    for (std::size_t i = 0; i < n && n <= 2; ++i)
        paintKnot(painter, {n == 1 ? 0.5 : double(i), m_curve.knots[i]}, i == m_knot);
}

} // namespace suffuse
