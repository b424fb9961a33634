#include "app/panels/strokes/rows/row_delegate.h"

#include "app/panels/strokes/rows/row_look.h"
#include "app/panels/strokes/strokes_filter.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/session/editor.h"
#include "app/widgets/habits/entry_field.h"
#include "app/widgets/look/theme.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPixmapCache>

#include <algorithm>
#include <utility>

namespace suffuse {

namespace {

constexpr double smaller = 0.85; ///< than the font of names
constexpr int besidesName = 10;  ///< what a style leaves free around picture and name, logical pixels

/// What the picture and the name of a row need, logical pixels.
int nameWidth(const QFont &font, const QModelIndex &index)
{
    QFont shown = font;
    shown.setBold(index.data(StrokesModel::CurrentLayerRole).toBool());
    return ThumbnailRenderer::size.width() + QFontMetrics(shown).horizontalAdvance(index.data().toString());
}

/// Writes of how many pieces and erasures a stroke is, small and pale at the end of the row, as far as the name
/// leaves room for that; the tool tip says all of it.
void paintMakeUp(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index)
{
    const QString text = index.data(StrokesModel::MakeUpRole).toString();
    if (text.isEmpty())
        return;
    constexpr int gap = 8, leastRoom = 40;
    QFont font = option.font;
    font.setPointSizeF(smaller * font.pointSizeF());
    const QFontMetrics metrics(font);
    const int room = option.rect.width() - nameWidth(option.font, index) - 2 * gap;
    if (room < leastRoom)
        return;
    const bool selected = isStronglySelected(option);
    painter.save();
    painter.setFont(font);
    painter.setPen(option.palette.color(selected ? QPalette::HighlightedText : QPalette::PlaceholderText));
    painter.drawText(option.rect.adjusted(0, 0, -gap / 2, 0), Qt::AlignRight | Qt::AlignVCenter,
                     metrics.elidedText(text, Qt::ElideRight, room));
    painter.restore();
}

/// Draws an icon once. Icons are outlines, which would otherwise be drawn anew in each row.
QPixmap drawnOnce(const QIcon &icon, const QModelIndex &index, bool selected, const QPainter &painter,
                  const QStyleOptionViewItem &option)
{
    const double ratio = painter.device()->devicePixelRatioF();
    const QString key = QStringLiteral("strokes %1 %2 %3 %4 %5 %6")
                            .arg(index.column())
                            .arg(index.data(StrokesModel::SwitchRole).toBool())
                            .arg(index.data(StrokesModel::PartRole).toBool())
                            .arg(selected)
                            .arg(option.palette.cacheKey())
                            .arg(ratio);
    QPixmap pixmap;
    if (!icon.isNull() && !QPixmapCache::find(key, &pixmap)) {
        pixmap = icon.pixmap(QSize(16, 16), ratio, selected ? QIcon::Selected : QIcon::Normal);
        QPixmapCache::insert(key, pixmap);
    }
    return pixmap;
}

QPixmap emptyPixmap(QSize size, double ratio)
{
    QPixmap pixmap(size);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    return pixmap;
}

/// Paint keeps its colours in a selected row.
QIcon iconOf(const QPixmap &pixmap)
{
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

/// A picture on a sheet of paper, or on the upper of two sheets, as a group is shown.
QIcon pictureOf(const QImage &image, double ratio, bool isGroup)
{
    QPixmap pixmap = emptyPixmap(image.size(), ratio);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF whole(QPointF(), pixmap.deviceIndependentSize());
    const QColor ground = paperFor(image);
    const auto sheet = [&](const QRectF &area) {
        QPainterPath paper;
        paper.addRoundedRect(area, 3, 3);
        painter.fillPath(paper, ground);
        if (!isGroup || area.right() < whole.right()) {
            painter.setClipPath(paper);
            painter.drawImage(area, image);
            painter.setClipping(false);
        }
        painter.setPen(QPen(hairline(), 1));
        painter.drawRoundedRect(area.adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    };
    constexpr double behind = 3; ///< how far the lower sheet is seen
    if (isGroup)
        sheet(whole.adjusted(behind, behind, 0, 0));
    sheet(isGroup ? whole.adjusted(0, 0, -behind, -behind) : whole);
    return iconOf(pixmap);
}

QIcon chip(const QColor &colour, QSize size)
{
    const double ratio = 2;
    QPixmap pixmap = emptyPixmap(size * ratio, ratio);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(edgeOfColours(), 1));
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(2.5, 2.5, size.width() - 5, size.height() - 5), 3, 3);
    return iconOf(pixmap);
}

} // namespace

RowDelegate::RowDelegate(Editor &editor, const StrokesModel &model, const StrokesFilter &filter, QObject *parent)
    : QStyledItemDelegate(parent), m_editor(editor), m_model(model), m_filter(filter),
      m_strokes(new StrokeThumbnails(this)), m_groups(new GroupThumbnails(model.tree(), this))
{
    connect(m_strokes, &StrokeThumbnails::ready, this, [this](StrokeId id) { emit pictureReady(m_model.indexOf(id)); });
    connect(m_groups, &GroupThumbnails::ready, this,
            [this](GroupId id) { emit pictureReady(m_model.indexOf(m_model.tree().nodeOfGroup(id))); });
}

GroupCells RowDelegate::cellsOf(const Group &group, const QModelIndex &index, const QRect &rect, const QFont &font)
{
    return groupCells(group, rect, nameWidth(font, index), font);
}

void RowDelegate::initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    if (index.column() != StrokesModel::NameColumn)
        return;
    const QFont font = option->font;
    addPicture(option, index);
    if (index.data(StrokesModel::CurrentLayerRole).toBool())
        option->font.setBold(true);
    if (const Group *group = m_model.groupAt(m_filter.mapToSource(index))) {
        // A long name gives way to the cells behind it.
        const int room = leftOf(cellsOf(*group, index, option->rect, font), option->rect) - option->rect.left();
        option->text = QFontMetrics(option->font)
                           .elidedText(option->text, Qt::ElideRight,
                                       std::max(room - option->decorationSize.width() - besidesName, 0));
    }
    // A name that nobody gave is paler, not in italics, which Chinese does not have. This comes last, since pictures
    // are remembered by the palette.
    if (index.data(StrokesModel::UnnamedRole).toBool())
        option->palette.setBrush(QPalette::Text, option->palette.brush(QPalette::PlaceholderText));
}

void RowDelegate::addPicture(QStyleOptionViewItem *option, const QModelIndex &index) const
{
    if (const Group *group = m_model.groupAt(m_filter.mapToSource(index)))
        return addGroupPicture(option, group->id);
    if (!index.data(StrokesModel::ColourRole).isValid())
        return;
    option->features |= QStyleOptionViewItem::HasDecoration;
    const QColor colour = index.data(StrokesModel::ColourRole).value<QColor>();
    if (index.data(StrokesModel::SegmentRole).toInt() >= 0) {
        option->decorationSize = QSize(16, 16);
        option->icon = chipOf(colour, *option);
        return;
    }
    option->decorationSize = ThumbnailRenderer::size;
    const double ratio = option->widget ? option->widget->devicePixelRatioF() : 1;
    const StrokePtr stroke = m_model.strokeValueAt(m_filter.mapToSource(index));
    // While a value is dragged, the canvas needs the processor.
    const QImage image = stroke ? m_strokes->of(stroke, ratio, m_editor.isDragging()) : QImage();
    option->icon = image.isNull() ? chipOf(colour, *option)
                                  : remembered({option->palette.cacheKey(), image.cacheKey()},
                                               [&] { return pictureOf(image, ratio, false); });
}

/// Until there is a picture the row has the icon of groups.
void RowDelegate::addGroupPicture(QStyleOptionViewItem *option, GroupId group) const
{
    const StrokesTree::Node *node = m_model.tree().nodeOfGroup(group);
    const double ratio = option->widget ? option->widget->devicePixelRatioF() : 1;
    const QImage image = node ? m_groups->of(*node, ratio, m_editor.isDragging()) : QImage();
    option->decorationSize = ThumbnailRenderer::size;
    if (!image.isNull())
        option->icon =
            remembered({option->palette.cacheKey(), image.cacheKey()}, [&] { return pictureOf(image, ratio, true); });
}

void RowDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    if (index.column() == StrokesModel::NameColumn) {
        QStyledItemDelegate::paint(painter, option, index);
        if (const Group *group = m_model.groupAt(m_filter.mapToSource(index)))
            paintGroupCells(*painter, option, *group, cellsOf(*group, index, option.rect, option.font));
        else
            paintMakeUp(*painter, option, index);
        return;
    }
    QStyleOptionViewItem empty = option;
    initStyleOption(&empty, index);
    const QIcon icon = std::exchange(empty.icon, QIcon());
    empty.features &= ~QStyleOptionViewItem::HasDecoration;
    const QStyle *style = option.widget ? option.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &empty, painter, option.widget);
    const bool selected = isStronglySelected(option);
    const QRect area = QStyle::alignedRect(Qt::LeftToRight, Qt::AlignCenter, QSize(16, 16), option.rect);
    constexpr double dimmed = 0.35;
    const double before = painter->opacity();
    if (index.column() == StrokesModel::EyeColumn && isHidden(index))
        painter->setOpacity(dimmed * before);
    painter->drawPixmap(area, drawnOnce(icon, index, selected, *painter, option));
    painter->setOpacity(before);
}

bool RowDelegate::isHidden(const QModelIndex &index) const
{
    const QModelIndex source = m_filter.mapToSource(index);
    const StrokePtr stroke = m_model.strokeValueAt(source);
    const Group *group = stroke ? nullptr : m_model.groupAt(source);
    return (stroke || group) && isHiddenByOthers(*m_editor.unsettled().painting(), stroke.get(), group);
}

QWidget *RowDelegate::createEditor(QWidget *parent, const QStyleOptionViewItem &, const QModelIndex &index) const
{
    auto *field = new EntryField(parent);
    field->setFrame(false);
    field->setPlaceholderText(index.data().toString());
    connect(field, &EntryField::typed, this, [this, field] {
        auto *delegate = const_cast<RowDelegate *>(this);
        emit delegate->commitData(field);
        emit delegate->closeEditor(field);
    });
    return field;
}

/// Return takes the text at once. Qt would take it a second time later, from a field that is closed by then. After
/// Esc there is nothing to be taken when the keyboard leaves the field.
bool RowDelegate::eventFilter(QObject *object, QEvent *event)
{
    const int key = event->type() == QEvent::KeyPress ? static_cast<QKeyEvent *>(event)->key() : 0;
    auto *field = qobject_cast<EntryField *>(object);
    if (field && key == Qt::Key_Escape)
        field->setModified(false);
    if (!field || (key != Qt::Key_Return && key != Qt::Key_Enter))
        return QStyledItemDelegate::eventFilter(object, event);
    emit commitData(field);
    emit closeEditor(field);
    event->ignore(); // as a field does, so that the key can mean something to the panel
    return true;
}

/// What was taken is not typed any more: else the field would say so when the keyboard leaves it, which belongs to
/// no view by then.
void RowDelegate::setModelData(QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const
{
    QStyledItemDelegate::setModelData(editor, model, index);
    if (auto *field = qobject_cast<EntryField *>(editor))
        field->setModified(false);
}

QSize RowDelegate::sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    QSize size = QStyledItemDelegate::sizeHint(option, index);
    size.setHeight(std::max(size.height(), ThumbnailRenderer::size.height() + 4));
    return size;
}

template <typename Make>
QIcon RowDelegate::remembered(std::pair<qint64, qint64> key, Make make) const
{
    if (const QIcon *icon = m_icons.object(key))
        return *icon;
    auto *icon = new QIcon(make());
    const QIcon result = *icon;
    m_icons.insert(key, icon);
    return result;
}

QIcon RowDelegate::chipOf(const QColor &colour, const QStyleOptionViewItem &option) const
{
    return remembered({~option.palette.cacheKey(), qint64(colour.rgba())}, [&] { return chip(colour, QSize(16, 16)); });
}

} // namespace suffuse
