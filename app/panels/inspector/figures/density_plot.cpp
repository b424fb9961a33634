#include "app/panels/inspector/figures/density_plot.h"

#include "app/widgets/curves/plot_frame.h"
#include "app/widgets/look/theme.h"
#include "model/paint/style_function.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace suffuse {

DensityPlot::DensityPlot(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void DensityPlot::show(const Style &style, double lowestPeak, double highestPeak, bool several)
{
    m_style = style;
    m_lowestPeak = lowestPeak;
    m_highestPeak = highestPeak;
    m_several = several;
    setAccessibleDescription(tr("Coverage at the peak density %1: %2 %")
                                 .arg(QLocale().toString(highestPeak, 'g', 3),
                                      QLocale().toString(100 * densityFunction(style, highestPeak), 'f', 0)));
    update();
}

QSize DensityPlot::sizeHint() const
{
    return {200, 112};
}

QSize DensityPlot::minimumSizeHint() const
{
    return {120, 112};
}

double DensityPlot::horizontalRange() const
{
    const double inside = plottedDensity(*m_style);
    // A far peak must not flatten the curve to nothing. It is then marked at the right end.
    return std::max(inside, std::min(1.15 * m_highestPeak, 4 * inside));
}

void DensityPlot::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const QPalette &colours = palette();
    const QRectF frame = paintPlotFrame(painter, *this);
    if (!m_style)
        return;

    const int line = painter.fontMetrics().height();
    const QRectF plot = frame.adjusted(24, 10, -12, -line - 8);
    const double range = horizontalRange();
    const auto at = [&](double density, double value) {
        return QPointF(plot.left() + plot.width() * density / range, plot.bottom() - plot.height() * value);
    };

    painter.setPen(QPen(hairline(), 1, Qt::DotLine));
    painter.drawLine(at(0, 1), at(range, 1));
    painter.setPen(QPen(hairline(), 1));
    painter.drawLine(at(0, 0), at(range, 0));

    // Two samples a pixel draw steps as steps.
    QPainterPath curve(at(0, 0));
    const int samples = std::max(2, int(2 * plot.width()));
    for (int i = 1; i <= samples; ++i) {
        const double density = range * i / samples;
        curve.lineTo(at(density, densityFunction(*m_style, density)));
    }
    QPainterPath area = curve;
    area.lineTo(at(range, 0));
    area.closeSubpath();
    QColor accent = colours.color(isDarkTheme() ? QPalette::Link : QPalette::Highlight);
    painter.strokePath(curve, QPen(accent, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    accent.setAlpha(36);
    painter.fillPath(area, accent);

    const double low = std::min(m_lowestPeak, range), high = std::min(m_highestPeak, range);
    QColor mark = warningText();
    if (high > low * 1.001) {
        mark.setAlpha(40);
        painter.fillRect(QRectF(at(low, 1), at(high, 0)), mark);
        mark.setAlpha(255);
    }
    painter.setPen(QPen(mark, 1.4));
    painter.drawLine(at(high, 0), at(high, 1));
    painter.setBrush(mark);
    painter.drawEllipse(at(high, densityFunction(*m_style, m_highestPeak)), 3, 3);

    painter.setPen(colours.color(QPalette::PlaceholderText));
    painter.drawText(QRectF(0, plot.top() - line / 2.0, 20, line), Qt::AlignRight | Qt::AlignVCenter, "1");
    painter.drawText(QRectF(0, plot.bottom() - line / 2.0, 20, line), Qt::AlignRight | Qt::AlignVCenter, "0");
    painter.drawText(QRectF(plot.left(), plot.bottom() + 2, plot.width(), line + 6), Qt::AlignRight,
                     m_several ? tr("density φ — first of several styles") : tr("density φ"));
    painter.drawText(QRectF(plot.left() - 20, plot.bottom() + 2, 20 + plot.width() / 2, line + 6), Qt::AlignLeft,
                     m_several ? QString() : tr("F(φ), peak %1").arg(QLocale().toString(m_highestPeak, 'g', 3)));
}

} // namespace suffuse
