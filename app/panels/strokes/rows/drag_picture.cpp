#include "app/panels/strokes/rows/drag_picture.h"

#include "app/panels/strokes/rows/row_delegate.h"
#include "app/widgets/look/theme.h"

#include <QCoreApplication>
#include <QPainter>
#include <QTreeView>

namespace suffuse {

namespace {

constexpr int dragMargin = 4, gap = 6, mostText = 140; ///< logical pixels

} // namespace

QPixmap dragPicture(const QTreeView &view, const QModelIndexList &rows)
{
    if (rows.isEmpty())
        return {};
    QStyleOptionViewItem row;
    row.initFrom(&view);
    row.widget = &view;
    row.decorationSize = view.iconSize();
    row.rect = QRect(0, 0, 2 * mostText, view.iconSize().height()); // room for any name that is seen
    if (const auto *delegate = qobject_cast<const RowDelegate *>(view.itemDelegate()))
        delegate->initStyleOption(&row, rows.constFirst());
    const QFontMetrics metrics(view.font());
    const QString name = rows.constFirst().data().toString();
    const QString text =
        rows.size() == 1 ? metrics.elidedText(name, Qt::ElideRight, mostText)
                         : QCoreApplication::translate("suffuse::StrokesView", "%Ln row(s)", nullptr, int(rows.size()));
    const QSize icon = view.iconSize();
    const QSize size(2 * dragMargin + icon.width() + gap + metrics.horizontalAdvance(text),
                     2 * dragMargin + std::max(icon.height(), metrics.height()));
    const double ratio = view.devicePixelRatioF();
    QPixmap picture(size * ratio);
    picture.setDevicePixelRatio(ratio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(edgeOfColours());
    painter.setBrush(view.palette().color(QPalette::Base));
    painter.drawRoundedRect(QRectF(QPointF(), size).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    row.icon.paint(&painter, QRect(QPoint(dragMargin, (size.height() - icon.height()) / 2), icon));
    painter.setFont(view.font());
    painter.setPen(view.palette().color(QPalette::Text));
    painter.drawText(QRect(dragMargin + icon.width() + gap, 0, size.width(), size.height()), Qt::AlignVCenter, text);
    return picture;
}

QPoint dragHotSpot()
{
    return {-16, -12};
}

} // namespace suffuse
