#include "app/dialogs/manual/hit_delegate.h"

#include <QApplication>
#include <QPainter>
#include <QTextLayout>

namespace suffuse {

namespace {

constexpr int rowSide = 10, rowMargin = 5; ///< logical pixels around what stands in a row
constexpr int excerptLines = 2;

QFont excerptFont(const QFont &font)
{
    QFont small = font;
    small.setPointSizeF(QFontInfo(font).pointSizeF() * 0.9);
    return small;
}

/// The first lines of an excerpt, the last one cut off where more follows.
QStringList linesOf(const QString &text, const QFont &font, int room)
{
    QTextLayout layout(text, font);
    QStringList lines;
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(room);
        if (lines.size() + 1 == excerptLines) {
            lines << QFontMetrics(font).elidedText(text.mid(line.textStart()), Qt::ElideRight, room);
            break;
        }
        lines << text.mid(line.textStart(), line.textLength()).trimmed();
    }
    layout.endLayout();
    return lines;
}

} // namespace

QSize HitDelegate::sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const QFontMetrics metrics(option.font);
    int height = metrics.height() + 2 * rowMargin;
    if (index.data(IsHeadingRole).toBool())
        height += index.row() > 0 ? metrics.height() / 2 : 0;
    if (!index.data(ExcerptRole).toString().isEmpty())
        height += excerptLines * QFontMetrics(excerptFont(option.font)).height() + 2;
    return {2 * rowSide, height}; // rows are as wide as the list
}

void HitDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    QStyleOptionViewItem row = option;
    initStyleOption(&row, index);
    row.text.clear();
    const QStyle &style = *(option.widget ? option.widget->style() : QApplication::style());
    style.drawControl(QStyle::CE_ItemViewItem, &row, painter, option.widget);
    const bool isHeading = index.data(IsHeadingRole).toBool(), chosen = option.state & QStyle::State_Selected;
    const QColor text = option.palette.color(chosen ? QPalette::HighlightedText : QPalette::Text);
    const QColor quiet = chosen ? text : option.palette.color(QPalette::PlaceholderText);
    const QString excerpt = index.data(ExcerptRole).toString();
    QRect room = option.rect.adjusted(rowSide, rowMargin, -rowSide, -rowMargin);
    QFont font = option.font;
    font.setBold(isHeading || !excerpt.isEmpty());
    if (isHeading)
        font = excerptFont(font);
    painter->save();
    painter->setFont(font);
    painter->setPen(isHeading ? quiet : text);
    const QFontMetrics metrics(font);
    const QRect line = isHeading ? QRect(room.left(), room.bottom() + 1 - metrics.height(), room.width(), metrics.height())
                                 : QRect(room.topLeft(), QSize(room.width(), metrics.height()));
    painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                      metrics.elidedText(index.data().toString(), Qt::ElideRight, line.width()));
    const QFont small = excerptFont(option.font);
    const int height = QFontMetrics(small).height();
    painter->setFont(small);
    painter->setPen(quiet);
    int top = line.bottom() + 3;
    for (const QString &part : linesOf(excerpt, small, room.width())) {
        painter->drawText(QRect(room.left(), top, room.width(), height), Qt::AlignLeft | Qt::AlignVCenter, part);
        top += height;
    }
    painter->restore();
}

} // namespace suffuse
