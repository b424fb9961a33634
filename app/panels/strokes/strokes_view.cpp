#include "app/panels/strokes/strokes_view.h"

#include "app/panels/strokes/row_look.h"
#include "app/panels/strokes/stroke_thumbnails.h"
#include "app/panels/strokes/strokes_filter.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/session/editor.h"
#include "app/widgets/habits/entry_field.h"
#include "app/widgets/habits/held_button.h"
#include "app/widgets/habits/keyboard_focus.h"
#include "app/widgets/look/theme.h"

#include <QApplication>
#include <QCache>
#include <QHeaderView>
#include <QInputEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPixmapCache>
#include <QStyledItemDelegate>

#include <algorithm>
#include <utility>

namespace suffuse {

namespace {

/// What the picture and the name of a row need, logical pixels.
int nameWidth(const QFont &font, const QModelIndex &index)
{
    QFont shown = font;
    shown.setBold(index.data(StrokesModel::CurrentLayerRole).toBool());
    return StrokeThumbnails::size.width() + QFontMetrics(shown).horizontalAdvance(index.data().toString());
}

/// Paints a small picture of a stroke before its name, a chip of its colour before a segment's name, and eyes and locks
/// in the middle of their columns.
class StrokeRowDelegate : public QStyledItemDelegate {
public:
    StrokeRowDelegate(const StrokesFilter &filter, const StrokesModel &model, StrokeThumbnails &thumbnails,
                      Editor &editor, QObject *parent)
        : QStyledItemDelegate(parent), m_filter(filter), m_model(model), m_thumbnails(thumbnails), m_editor(editor)
    {}

    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        addPicture(option, index);
        if (index.column() == StrokesModel::NameColumn && index.data(StrokesModel::CurrentLayerRole).toBool())
            option->font.setBold(true);
        // A name that nobody gave is paler, not in italics, which Chinese does not have. This comes last, since
        // pictures are remembered by the palette.
        if (index.column() == StrokesModel::NameColumn && index.data(StrokesModel::UnnamedRole).toBool())
            option->palette.setBrush(QPalette::Text, option->palette.brush(QPalette::PlaceholderText));
    }

    void addPicture(QStyleOptionViewItem *option, const QModelIndex &index) const
    {
        if (index.column() != StrokesModel::NameColumn || !index.data(StrokesModel::ColourRole).isValid())
            return;
        option->features |= QStyleOptionViewItem::HasDecoration;
        const QColor colour = index.data(StrokesModel::ColourRole).value<QColor>();
        if (index.data(StrokesModel::SegmentRole).toInt() >= 0) {
            option->decorationSize = QSize(16, 16);
            option->icon = chipOf(colour, *option);
        } else {
            option->decorationSize = StrokeThumbnails::size;
            const double ratio = option->widget ? option->widget->devicePixelRatioF() : 1;
            const StrokePtr stroke = m_model.strokeValueAt(m_filter.mapToSource(index));
            // While a value is dragged, the canvas needs the processor.
            const QImage image = stroke ? m_thumbnails.of(stroke, ratio, m_editor.isDragging()) : QImage();
            option->icon = image.isNull() ? chipOf(colour, *option)
                                          : remembered({option->palette.cacheKey(), image.cacheKey()},
                                                       [&] { return picture(image, ratio); });
        }
    }

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        if (index.column() == StrokesModel::NameColumn) {
            QStyledItemDelegate::paint(painter, option, index);
            if (const Group *group = m_model.groupAt(m_filter.mapToSource(index)))
                paintGroupCells(*painter, option, *group,
                                groupCells(*group, option.rect, nameWidth(option.font, index), option.font));
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
        painter->drawPixmap(area, drawn(icon, index, selected, *painter, option));
        painter->setOpacity(before);
    }

    bool isHidden(const QModelIndex &index) const
    {
        const QModelIndex source = m_filter.mapToSource(index);
        const StrokePtr stroke = m_model.strokeValueAt(source);
        const Group *group = stroke ? nullptr : m_model.groupAt(source);
        return (stroke || group) && isHiddenByOthers(*m_editor.unsettled().painting(), stroke.get(), group);
    }

    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &, const QModelIndex &index) const override
    {
        auto *field = new EntryField(parent);
        field->setFrame(false);
        field->setPlaceholderText(index.data().toString());
        connect(field, &EntryField::typed, this, [this, field] {
            auto *delegate = const_cast<StrokeRowDelegate *>(this);
            emit delegate->commitData(field);
            emit delegate->closeEditor(field);
        });
        return field;
    }

    /// Return takes the text at once. Qt would take it a second time later, from a field that is closed by then. After
    /// Esc there is nothing to be taken when the keyboard leaves the field.
    bool eventFilter(QObject *object, QEvent *event) override
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
    void setModelData(QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const override
    {
        QStyledItemDelegate::setModelData(editor, model, index);
        if (auto *field = qobject_cast<EntryField *>(editor))
            field->setModified(false);
    }

    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        QSize size = QStyledItemDelegate::sizeHint(option, index);
        size.setHeight(std::max(size.height(), StrokeThumbnails::size.height() + 4));
        return size;
    }

private:
    /// Writes of how many pieces and erasures a stroke is, small and pale at the end of the row, as far as the name
    /// leaves room for that; the tool tip says all of it.
    static void paintMakeUp(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index)
    {
        const QString text = index.data(StrokesModel::MakeUpRole).toString();
        if (text.isEmpty())
            return;
        constexpr int gap = 8, leastRoom = 40;
        constexpr double smaller = 0.85;
        QFont font = option.font;
        font.setPointSizeF(smaller * font.pointSizeF());
        const QFontMetrics metrics(font);
        const int name = nameWidth(option.font, index);
        const int room = option.rect.width() - name - 2 * gap;
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
    static QPixmap drawn(const QIcon &icon, const QModelIndex &index, bool selected, const QPainter &painter,
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

    /// Keeps icons. A new icon for each painting would fill Qt's cache of pixmaps with equal ones.
    template <typename Make>
    QIcon remembered(std::pair<qint64, qint64> key, Make make) const
    {
        if (const QIcon *icon = m_icons.object(key))
            return *icon;
        auto *icon = new QIcon(make());
        const QIcon result = *icon;
        m_icons.insert(key, icon);
        return result;
    }

    QIcon chipOf(const QColor &colour, const QStyleOptionViewItem &option) const
    {
        return remembered({~option.palette.cacheKey(), qint64(colour.rgba())},
                          [&] { return chip(colour, QSize(16, 16)); });
    }

    static QIcon picture(const QImage &image, double ratio)
    {
        QPixmap pixmap(image.size());
        pixmap.setDevicePixelRatio(ratio);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        QPainterPath paper;
        paper.addRoundedRect(QRectF(QPointF(), pixmap.deviceIndependentSize()), 3, 3);
        painter.fillPath(paper, paperFor(image));
        painter.setClipPath(paper);
        painter.drawImage(QPointF(), image);
        painter.setClipping(false);
        painter.setPen(QPen(hairline(), 1));
        painter.drawRoundedRect(paper.boundingRect().adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
        QIcon icon(pixmap);
        icon.addPixmap(pixmap, QIcon::Selected); // Paint keeps its colours in a selected row.
        return icon;
    }

    static QIcon chip(const QColor &colour, QSize size)
    {
        const double ratio = 2;
        QPixmap pixmap(size * ratio);
        pixmap.setDevicePixelRatio(ratio);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(edgeOfColours(), 1));
        painter.setBrush(colour);
        painter.drawRoundedRect(QRectF(2.5, 2.5, size.width() - 5, size.height() - 5), 3, 3);
        QIcon icon(pixmap);
        icon.addPixmap(pixmap, QIcon::Selected);
        return icon;
    }

    const StrokesFilter &m_filter;
    const StrokesModel &m_model;
    StrokeThumbnails &m_thumbnails;
    Editor &m_editor;
    mutable QCache<std::pair<qint64, qint64>, QIcon> m_icons{256};
};

} // namespace

StrokesView::StrokesView(Editor &editor, const StrokesModel &model, StrokesFilter &filter, QWidget *parent)
    : QTreeView(parent), m_model(model), m_filter(filter)
{
    auto *thumbnails = new StrokeThumbnails(this);
    connect(thumbnails, &StrokeThumbnails::ready, this, [this, &model, &filter](StrokeId id) {
        if (const QModelIndex index = filter.mapFromSource(model.indexOf(id)); index.isValid())
            update(index);
    });
    connect(&editor, &Editor::dragEnded, viewport(), qOverload<>(&QWidget::update));
    KeyboardFocus::passLetters(*this);
    setModel(&filter);
    setItemDelegate(new StrokeRowDelegate(filter, model, *thumbnails, editor, this));
    setIconSize(StrokeThumbnails::size);
    setHeaderHidden(true);
    setUniformRowHeights(true);
    setIndentation(14);
    setFrameShape(QFrame::NoFrame);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    setDragEnabled(true);
    setAcceptDrops(true);
    setDropIndicatorShown(true);
    setDragDropMode(QAbstractItemView::InternalMove);
    setDefaultDropAction(Qt::MoveAction);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    QHeaderView *columns = header();
    columns->setStretchLastSection(false);
    columns->setSectionResizeMode(StrokesModel::NameColumn, QHeaderView::Stretch);
    columns->setMinimumSectionSize(26);
    for (const int column : {StrokesModel::EyeColumn, StrokesModel::LockColumn}) {
        columns->setSectionResizeMode(column, QHeaderView::Fixed);
        columns->resizeSection(column, 28);
    }
}

QItemSelectionModel::SelectionFlags StrokesView::selectionCommand(const QModelIndex &index, const QEvent *event) const
{
    const bool dragged = event && event->type() == QEvent::MouseMove;
    const bool shift = event && event->isInputEvent() &&
                       static_cast<const QInputEvent *>(event)->modifiers().testFlag(Qt::ShiftModifier);
    m_ranging = dragged || shift;
    return QTreeView::selectionCommand(index, event);
}

GroupCells StrokesView::cellsOf(const QModelIndex &index) const
{
    const QModelIndex name = index.siblingAtColumn(StrokesModel::NameColumn);
    const Group *group = index.isValid() ? m_model.groupAt(m_filter.mapToSource(name)) : nullptr;
    return group ? groupCells(*group, visualRect(name), nameWidth(font(), name), font()) : GroupCells();
}

/// The row that F2 renames: the current one, if it is seen and selected, or the first that is. Rows that were moved or
/// have just come leave none or a hidden one current. A group of which a search shows a part is never selected as a
/// whole, and is meant where it is current.
QModelIndex StrokesView::rowToRename() const
{
    const auto isMeant = [this](const QModelIndex &index) {
        return index.isValid() && !visualRect(index).isEmpty() &&
               (selectionModel()->isSelected(index) || index.data(StrokesModel::WhollySelectedRole).toBool());
    };
    QModelIndex row = currentIndex().siblingAtColumn(StrokesModel::NameColumn);
    if (!isMeant(row) && !(isGroup(row) && !visualRect(row).isEmpty() && m_filter.hidesSome(row) && holdsSelected(row)))
        for (row = model()->index(0, StrokesModel::NameColumn); row.isValid() && !isMeant(row);)
            row = indexBelow(row);
    return row;
}

/// Whether a row that is shown below a group's is selected.
bool StrokesView::holdsSelected(const QModelIndex &group) const
{
    for (int row = 0; row < model()->rowCount(group); ++row)
        if (const QModelIndex below = model()->index(row, StrokesModel::NameColumn, group);
            selectionModel()->isSelected(below) || (isGroup(below) && holdsSelected(below)))
            return true;
    return false;
}

/// Where a row goes that was alone in its group, and so the group with it, the frame goes to the neighbour.
void StrokesView::rowsAboutToBeRemoved(const QModelIndex &parent, int start, int end)
{
    const QModelIndex current = currentIndex();
    const bool isAlone = parent.isValid() && start == 0 && end == model()->rowCount(parent) - 1;
    QPersistentModelIndex neighbour;
    if (isAlone && current.isValid() && current.parent() == parent) {
        QModelIndex row = model()->index(end, StrokesModel::NameColumn, parent);
        neighbour = indexBelow(row);
        for (row = parent; !neighbour.isValid() && row.isValid(); row = indexAbove(row))
            if (row != parent)
                neighbour = row;
    }
    QTreeView::rowsAboutToBeRemoved(parent, start, end);
    if (neighbour.isValid())
        QMetaObject::invokeMethod(
            this,
            [this, neighbour] {
                if (!currentIndex().isValid() && neighbour.isValid())
                    selectionModel()->setCurrentIndex(neighbour, QItemSelectionModel::NoUpdate);
            },
            Qt::QueuedConnection);
}

void StrokesView::keyPressEvent(QKeyEvent *event)
{
    if (const QModelIndex row = event->key() == Qt::Key_F2 && !event->modifiers() ? rowToRename() : QModelIndex();
        row.isValid())
        selectionModel()->setCurrentIndex(row, QItemSelectionModel::NoUpdate);
    const QPersistentModelIndex before = currentIndex();
    const bool plain = !(event->modifiers() & ~Qt::KeypadModifier), none = !selectionModel()->hasSelection();
    const bool steps = event->key() == Qt::Key_Up || event->key() == Qt::Key_Down;
    const bool jumps = event->key() == Qt::Key_Home || event->key() == Qt::Key_End;
    if (!(plain && none && steps && currentIndex().isValid()))
        QTreeView::keyPressEvent(event);
    if (plain && (jumps || (none && steps)) && currentIndex().isValid() &&
        !selectionModel()->isSelected(currentIndex())) {
        setCurrentIndex(currentIndex());
        event->accept();
    }
    if (plain && currentIndex().isValid() && currentIndex() != before)
        emit chosen(currentIndex());
}

bool StrokesView::isGroup(const QModelIndex &index)
{
    return index.data(StrokesModel::GroupIdRole).toULongLong() != 0;
}

void StrokesView::selectWholeGroups()
{
    std::set<QModelIndex> around;
    for (QModelIndex above = currentIndex().parent(); above.isValid(); above = above.parent())
        around.insert(above);
    QItemSelection groups;
    const auto look = [&](const QModelIndex &parent, const auto &again) -> void {
        for (int row = 0; row < model()->rowCount(parent); ++row) {
            const QModelIndex index = model()->index(row, StrokesModel::NameColumn, parent);
            if (!isGroup(index))
                continue;
            if (!around.contains(index) && index.data(StrokesModel::WhollySelectedRole).toBool())
                groups.select(index, index.siblingAtColumn(StrokesModel::LockColumn));
            else
                again(index, again);
        }
    };
    look({}, look);
    selectionModel()->select(groups, QItemSelectionModel::Select);
}

/// All that stands below a group's row, with the row.
QItemSelection StrokesView::wholeOf(const QModelIndex &group) const
{
    QItemSelection whole(group, group.siblingAtColumn(StrokesModel::LockColumn));
    const int count = model()->rowCount(group);
    if (count > 0)
        whole.select(model()->index(0, StrokesModel::NameColumn, group),
                     model()->index(count - 1, StrokesModel::LockColumn, group));
    for (int row = 0; row < count; ++row)
        if (const QModelIndex below = model()->index(row, StrokesModel::NameColumn, group); isGroup(below))
            whole.merge(wholeOf(below), QItemSelectionModel::Select);
    return whole;
}

void StrokesView::mousePressEvent(QMouseEvent *event)
{
    const QModelIndex index = indexAt(event->position().toPoint()).siblingAtColumn(StrokesModel::NameColumn);
    if (isGroup(index) && index.data(StrokesModel::WhollySelectedRole).toBool()) {
        const bool onArrow = event->position().x() < visualRect(index).left();
        if (event->modifiers() == Qt::ControlModifier && event->button() == Qt::LeftButton && !onArrow) {
            selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
            selectionModel()->select(wholeOf(index), QItemSelectionModel::Deselect);
            event->accept();
            return;
        }
        if (!event->modifiers()) {
            selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
            selectWholeGroups();
        }
    }
    const bool onArrow = index.isValid() && event->position().x() < visualRect(index).left();
    const QPersistentModelIndex pressed = index;
    QTreeView::mousePressEvent(event);
    const bool isPlain = event->button() == Qt::LeftButton || (event->button() == Qt::RightButton && pressed.isValid());
    if (isPlain && !event->modifiers() && !onArrow) // The menu of a row is about its layer, too.
        emit chosen(pressed);
}

void StrokesView::startDrag(Qt::DropActions actions)
{
    if (!m_filter.text().isEmpty()) {
        emit dragRefused();
        return;
    }
    selectWholeGroups();
    const KeysEndDrag ends;
    QTreeView::startDrag(actions);
}

/// A group looks selected when all of its strokes are selected. The row of the layer that is painted on stands out,
/// whatever is selected.
void StrokesView::drawRow(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    QStyleOptionViewItem row = option;
    const bool isLayer = index.data(StrokesModel::CurrentLayerRole).toBool();
    if (isLayer || index.data(StrokesModel::WhollySelectedRole).toBool())
        row.state |= QStyle::State_Selected;
    if (!isLayer)
        row.palette = m_weak.of(row.palette);
    QTreeView::drawRow(painter, row, index);
}

void StrokesView::dataChanged(const QModelIndex &topLeft, const QModelIndex &bottomRight, const QList<int> &roles)
{
    const QModelIndex parent = topLeft.parent();
    if (parent.isValid() && !isExpanded(parent))
        return;
    const QModelIndex first = indexAt(viewport()->rect().topLeft()), last = indexAt(viewport()->rect().bottomLeft());
    const bool together = first.isValid() && last.isValid() && first.parent() == parent && last.parent() == parent;
    if (!together)
        viewport()->update();
    else if (topLeft.row() <= last.row() &&
             bottomRight.row() >= first.row()) // Otherwise the view would look for the rows among all others.
        QTreeView::dataChanged(topLeft.siblingAtRow(std::max(topLeft.row(), first.row())),
                               bottomRight.siblingAtRow(std::min(bottomRight.row(), last.row())), roles);
}

} // namespace suffuse
