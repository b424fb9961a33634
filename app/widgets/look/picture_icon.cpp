#include "app/widgets/look/picture_icon.h"

#include <QPainter>
#include <QPixmap>

namespace suffuse {

QIcon pictureIcon(const QImage &image, const QPalette &palette, qreal ratio)
{
    QPixmap pixmap(pictureSize * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    const QSize size = image.isNull() ? pictureSize : image.size().scaled(pictureSize, Qt::KeepAspectRatio);
    const QRect place(QPoint((pictureSize.width() - size.width()) / 2, (pictureSize.height() - size.height()) / 2),
                      size);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!image.isNull())
        painter.drawImage(place, image);
    painter.setPen(palette.color(QPalette::Mid));
    painter.drawRect(QRectF(place).adjusted(0.5, 0.5, -0.5, -0.5));
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

} // namespace suffuse
