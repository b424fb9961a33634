#include "app/widgets/curves/age_plot.h"

#include "app/widgets/curves/plot_frame.h"
#include "app/widgets/look/theme.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace suffuse {

AgePlot::AgePlot(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void AgePlot::show(std::vector<QPointF> points, double now, double cut)
{
    m_points = std::move(points);
    m_now = now;
    m_cut = cut;
    update();
}

void AgePlot::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const QRectF frame = paintPlotFrame(painter, *this);
    const int line = painter.fontMetrics().height();
    const QRectF plot = frame.adjusted(12, line + 4, -12, -line - 6);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    if (m_points.size() < 2) {
        painter.drawText(frame, Qt::AlignCenter, tr("No paint here"));
        return;
    }
    double top = m_cut;
    for (const QPointF &p : m_points)
        top = std::max(top, p.y());
    top *= 1.05;
    const double end = m_points.back().x();
    const QLocale locale;
    const QRectF above(plot.left(), 3, plot.width(), line), below(plot.left(), plot.bottom() + 2, plot.width(), line);
    painter.drawText(above, Qt::AlignLeft, tr("density φ, up to %1").arg(locale.toString(top / 1.05, 'g', 3)));
    painter.drawText(below, Qt::AlignLeft, tr("0 s"));
    painter.drawText(below, Qt::AlignRight, tr("age %1 s").arg(locale.toString(end, 'g', 3)));

    const auto at = [&](double x, double y) {
        return QPointF(plot.left() + plot.width() * std::clamp(x / end, 0.0, 1.0),
                       plot.bottom() - plot.height() * y / top);
    };
    painter.setPen(QPen(hairline(), 1));
    painter.drawLine(at(0, 0), at(end, 0));
    painter.setPen(QPen(warningText(), 1, Qt::DashLine));
    painter.drawLine(at(0, m_cut), at(end, m_cut));
    painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1));
    painter.drawLine(at(m_now, 0), at(m_now, top));
    QPainterPath curve(at(m_points.front().x(), m_points.front().y()));
    for (const QPointF &p : m_points)
        curve.lineTo(at(p.x(), p.y()));
    const QColor accent = palette().color(isDarkTheme() ? QPalette::Link : QPalette::Highlight);
    painter.strokePath(curve, QPen(accent, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}

} // namespace suffuse
