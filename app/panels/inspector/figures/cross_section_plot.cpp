#include "app/panels/inspector/figures/cross_section_plot.h"

#include "app/widgets/curves/plot_frame.h"
#include "app/widgets/look/theme.h"
#include "app/widgets/numbers/length_units.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace suffuse {

CrossSectionPlot::CrossSectionPlot(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void CrossSectionPlot::show(std::vector<CrossSectionPoint> points)
{
    m_points = std::move(points);
    double most = 0;
    for (const CrossSectionPoint &p : m_points)
        most = std::max(most, p.opacity);
    setAccessibleDescription(tr("Covers up to %1").arg(shareDisplay().text(most)));
    update();
}

QSize CrossSectionPlot::sizeHint() const
{
    return {200, 96};
}

QSize CrossSectionPlot::minimumSizeHint() const
{
    return {120, 96};
}

void CrossSectionPlot::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const QRectF frame = paintPlotFrame(painter, *this);
    const int line = painter.fontMetrics().height();
    const QRectF plot = frame.adjusted(24, 10, -12, -line - 8);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const QRectF below(plot.left(), plot.bottom() + 3, plot.width(), line + 6);
    if (m_points.size() < 2) {
        painter.drawText(plot, Qt::AlignCenter, tr("Not painted yet"));
        return;
    }

    const double range = m_points.back().offset;
    painter.drawText(QRectF(0, plot.top() - line / 2.0, 20, line), Qt::AlignRight | Qt::AlignVCenter, "1");
    painter.drawText(QRectF(0, plot.bottom() - line / 2.0, 20, line), Qt::AlignRight | Qt::AlignVCenter, "0");
    painter.drawText(below, Qt::AlignLeft, tr("cross-section"));
    painter.drawText(below, Qt::AlignRight, QStringLiteral("±") + lengthDisplay(this).text(range));

    // The ground shows what the eye sees: each column has the colour that the stroke has there on the background.
    const auto at = [&](const CrossSectionPoint &p) {
        return QPointF(plot.center().x() + 0.5 * plot.width() * p.offset / range,
                       plot.bottom() - plot.height() * p.opacity);
    };
    QLinearGradient ground(plot.topLeft(), plot.topRight());
    for (const CrossSectionPoint &p : m_points)
        ground.setColorAt(std::clamp(0.5 + 0.5 * p.offset / range, 0.0, 1.0),
                          QColor::fromRgbF(float(p.rgb[0]), float(p.rgb[1]), float(p.rgb[2])));
    painter.fillRect(plot, ground);
    QPainterPath curve(at(m_points.front()));
    for (const CrossSectionPoint &p : m_points)
        curve.lineTo(at(p));
    painter.strokePath(curve, QPen(QColor(255, 255, 255, 190), 3.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.strokePath(curve, QPen(QColor(24, 28, 34), 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}

} // namespace suffuse
