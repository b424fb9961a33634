#include "app/panels/strokes/strokes_view.h"

#include "app/panels/strokes/rows/drag_picture.h"
#include "app/panels/strokes/rows/row_delegate.h"
#include "app/panels/strokes/rows/row_look.h"
#include "app/panels/strokes/strokes_filter.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/session/editor.h"
#include "app/widgets/habits/held_button.h"

#include <QApplication>
#include <QDrag>
#include <QHeaderView>
#include <QInputEvent>
#include <QMimeData>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace suffuse {

StrokesView::StrokesView(Editor &editor, const StrokesModel &model, StrokesFilter &filter, QWidget *parent)
    : QTreeView(parent), m_model(model), m_filter(filter)
{
    auto *delegate = new RowDelegate(editor, model, filter, this);
    connect(delegate, &RowDelegate::pictureReady, this, [this, &filter](const QModelIndex &row) {
        if (const QModelIndex index = filter.mapFromSource(row); index.isValid())
            update(index);
    });
    connect(&editor, &Editor::dragEnded, viewport(), qOverload<>(&QWidget::update));
    setModel(&filter);
    setItemDelegate(delegate);
    setIconSize(ThumbnailRenderer::size);
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
    return group ? RowDelegate::cellsOf(*group, name, visualRect(name), font()) : GroupCells();
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
    const bool isStep = event->key() == Qt::Key_Up || event->key() == Qt::Key_Down;
    if (isStep && (event->modifiers() & ~Qt::KeypadModifier) == Qt::AltModifier) {
        if (m_filter.text().isEmpty())
            emit stepped(event->key() == Qt::Key_Up, event->isAutoRepeat());
        else
            emit dragRefused();
        return event->accept();
    }
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
    if (event->modifiers() || onArrow)
        return;
    if (event->button() == Qt::RightButton && pressed.isValid()) // The menu of a row is about its layer, too.
        emit chosen(pressed);
    m_isClick = event->button() == Qt::LeftButton;
    m_clicked = pressed;
}

/// A press chooses a layer only where it becomes no drag: one that is given up leaves all as it was.
void StrokesView::mouseReleaseEvent(QMouseEvent *event)
{
    QTreeView::mouseReleaseEvent(event);
    if (std::exchange(m_isClick, false) && event->button() == Qt::LeftButton)
        emit chosen(m_clicked);
}

void StrokesView::startDrag(Qt::DropActions actions)
{
    m_isClick = false;
    if (!m_filter.text().isEmpty()) {
        emit dragRefused();
        return;
    }
    selectWholeGroups();
    const QModelIndexList rows = draggedRows();
    if (rows.isEmpty())
        return;
    auto *drag = new QDrag(this);
    drag->setMimeData(model()->mimeData(rows));
    drag->setPixmap(dragPicture(*this, rows));
    drag->setHotSpot(dragHotSpot());
    const KeysEndDrag ends;
    drag->exec(actions, defaultDropAction());
}

QModelIndexList StrokesView::draggedRows() const
{
    QModelIndexList rows;
    for (const QItemSelectionRange &range : selectionModel()->selection()) {
        if (range.left() != StrokesModel::NameColumn || goesWithGroup(range.parent()))
            continue;
        for (int row = range.top(); row <= range.bottom(); ++row)
            if (const QModelIndex index = model()->index(row, StrokesModel::NameColumn, range.parent());
                index.flags() & Qt::ItemIsDragEnabled)
                rows << index;
    }
    return rows;
}

/// Whether a group, or one around it, is selected.
bool StrokesView::goesWithGroup(QModelIndex group) const
{
    while (group.isValid() && !selectionModel()->isSelected(group))
        group = group.parent();
    return group.isValid();
}

/// The arrow is as light or dark as the name beside it.
void StrokesView::drawBranches(QPainter *painter, const QRect &rect, const QModelIndex &index) const
{
    if (!model()->hasChildren(index))
        return;
    const bool isStrong = index.data(StrokesModel::CurrentLayerRole).toBool();
    const double half = 4; // logical pixels
    const QRectF cell(rect.right() + 1 - indentation(), rect.top(), indentation(), rect.height());
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(cell.center());
    if (isExpanded(index))
        painter->rotate(90);
    painter->setPen(QPen(palette().color(isStrong ? QPalette::HighlightedText : QPalette::Text), 1.6, Qt::SolidLine,
                         Qt::RoundCap, Qt::RoundJoin));
    painter->drawPolyline(QPolygonF{{-half / 2, -half}, {half / 2, 0}, {-half / 2, half}});
    painter->restore();
}

QRegion StrokesView::visualRegionForSelection(const QItemSelection &selection) const
{
    constexpr int fewRanges = 16;
    return selection.size() > fewRanges ? QRegion(viewport()->rect()) : QTreeView::visualRegionForSelection(selection);
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
