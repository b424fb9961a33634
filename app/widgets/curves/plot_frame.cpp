#include "app/widgets/curves/plot_frame.h"

#include "app/widgets/look/theme.h"

#include <QPainter>
#include <QWidget>

#include <algorithm>

namespace suffuse {

QRectF paintPlotFrame(QPainter &painter, const QWidget &widget)
{
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(widget.rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(hairline());
    painter.setBrush(widget.palette().color(QPalette::Base));
    painter.drawRoundedRect(frame, 4, 4);
    QFont small = widget.font();
    small.setPointSizeF(std::max(7.0, small.pointSizeF() * 0.85));
    painter.setFont(small);
    return frame;
}

} // namespace suffuse
