#include "app/dialogs/fit/fit_view.h"

#include "app/widgets/look/theme.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace suffuse {

namespace {

constexpr double mostEnlarged = 16; ///< so that a picture of a few pixels is no wall of one colour

} // namespace

FitView::FitView(QWidget *parent) : QWidget(parent)
{
    setAccessibleName(tr("Picture made of strokes"));
    setToolTip(tr("What the strokes look like. While a mouse button is held on it, the original is seen."));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void FitView::show(const QImage &picture, const QImage &original)
{
    m_images[0] = picture;
    m_images[1] = original;
    update();
}

void FitView::showOriginal(bool shown)
{
    m_original = shown;
    update();
}

void FitView::hold(bool held)
{
    m_held = held;
    update();
}

void FitView::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        hold(true);
}

void FitView::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        hold(false);
}

void FitView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const QImage &image = shown();
    if (image.isNull()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Here the picture grows, stroke by stroke."));
        painter.setPen(hairline());
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
        return;
    }
    const double scale = std::min({double(width()) / image.width(), double(height()) / image.height(), mostEnlarged});
    const QSizeF size = scale * QSizeF(image.size());
    const QRectF place(QPointF(0.5 * (width() - size.width()), 0.5 * (height() - size.height())), size);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(place, image);
    painter.setPen(hairline());
    painter.drawRect(place.adjusted(0, 0, -1, -1));
}

} // namespace suffuse
