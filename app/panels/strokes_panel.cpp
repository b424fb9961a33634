#include "app/panels/strokes_panel.h"

#include "app/editor.h"
#include "app/icons.h"
#include "app/panels/strokes_model.h"
#include "app/theme.h"

#include <QAction>
#include <QApplication>
#include <QHeaderView>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QTreeView>
#include <QVBoxLayout>

#include <utility>

namespace suffuse {

namespace {

/// A chip of the stroke's colour before its name; eyes and locks in the middle of their columns.
class RowDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        if (index.column() == StrokesModel::NameColumn && index.data(StrokesModel::ColourRole).isValid()) {
            option->features |= QStyleOptionViewItem::HasDecoration;
            option->icon = chip(index.data(StrokesModel::ColourRole).value<QColor>(), option->decorationSize);
        }
    }

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        if (index.column() == StrokesModel::NameColumn) {
            QStyledItemDelegate::paint(painter, option, index);
            return;
        }
        QStyleOptionViewItem empty = option;
        initStyleOption(&empty, index);
        const QIcon icon = std::exchange(empty.icon, QIcon());
        empty.features &= ~QStyleOptionViewItem::HasDecoration;
        const QStyle *style = option.widget ? option.widget->style() : QApplication::style();
        style->drawControl(QStyle::CE_ItemViewItem, &empty, painter, option.widget);
        icon.paint(painter, QStyle::alignedRect(Qt::LeftToRight, Qt::AlignCenter, empty.decorationSize, option.rect),
                   Qt::AlignCenter, option.state & QStyle::State_Selected ? QIcon::Selected : QIcon::Normal);
    }

    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        QSize size = QStyledItemDelegate::sizeHint(option, index);
        size.setHeight(std::max(size.height(), 24));
        return size;
    }

private:
    static QIcon chip(const QColor &colour, QSize size)
    {
        const double ratio = 2;
        QPixmap pixmap(size * ratio);
        pixmap.setDevicePixelRatio(ratio);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(hairline(), 1));
        painter.setBrush(colour);
        painter.drawRoundedRect(QRectF(2.5, 2.5, size.width() - 5, size.height() - 5), 3, 3);
        return pixmap;
    }
};

} // namespace

StrokesPanel::StrokesPanel(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 0);
    column->setSpacing(8);
    m_search = new QLineEdit(this);
    m_search->setPlaceholderText(tr("Search"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(icon("search"), QLineEdit::LeadingPosition);
    m_search->setAccessibleName(tr("Search strokes"));
    m_search->setToolTip(tr("Shows only strokes and groups whose name holds this text."));
    column->addWidget(m_search);

    m_model = new StrokesModel(editor, this);
    m_filter = new QSortFilterProxyModel(this);
    m_filter->setSourceModel(m_model);
    m_filter->setRecursiveFilteringEnabled(true);
    m_filter->setFilterCaseSensitivity(Qt::CaseInsensitive);
    m_filter->setFilterKeyColumn(StrokesModel::NameColumn);
    m_view = new QTreeView(this);
    setUpView();
    column->addWidget(m_view, 1);

    connect(m_search, &QLineEdit::textChanged, this, [this](const QString &text) {
        m_syncing = true; // rows that the search hides stay selected in the painting
        m_filter->setFilterFixedString(text.trimmed());
        m_syncing = false;
        m_view->setDragEnabled(text.trimmed().isEmpty());
        takeSelectionFromDocument();
    });
    m_view->viewport()->installEventFilter(this);
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &StrokesPanel::giveSelectionToDocument);
    connect(&editor.document(), &Document::changed, this, &StrokesPanel::documentChanged);
    takeSelectionFromDocument();
}

void StrokesPanel::setUpView()
{
    m_view->setModel(m_filter);
    m_view->setItemDelegate(new RowDelegate(m_view));
    m_view->setHeaderHidden(true);
    m_view->setUniformRowHeights(true);
    m_view->setRootIsDecorated(!m_editor.document().painting()->groups.empty());
    m_view->setIndentation(14);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_view->setDragEnabled(true);
    m_view->setAcceptDrops(true);
    m_view->setDropIndicatorShown(true);
    m_view->setDragDropMode(QAbstractItemView::InternalMove);
    m_view->setDefaultDropAction(Qt::MoveAction);
    m_view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_view->setAccessibleName(tr("Strokes"));
    m_view->setToolTip(tr("The topmost stroke comes first. Drag to reorder, double-click to rename."));
    QHeaderView *header = m_view->header();
    header->setStretchLastSection(false);
    header->setSectionResizeMode(StrokesModel::NameColumn, QHeaderView::Stretch);
    header->setMinimumSectionSize(26);
    for (const int column : {StrokesModel::EyeColumn, StrokesModel::LockColumn}) {
        header->setSectionResizeMode(column, QHeaderView::Fixed);
        header->resizeSection(column, 28);
    }
}

QSize StrokesPanel::sizeHint() const
{
    return {280, 240};
}

QModelIndex StrokesPanel::viewIndexOf(StrokeId id) const
{
    return m_filter->mapFromSource(m_model->indexOf(id));
}

void StrokesPanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (m_stale)
        takeSelectionFromDocument();
}

bool StrokesPanel::eventFilter(QObject *watched, QEvent *event)
{
    // Eyes and locks switch without a change of the selection.
    const bool press = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
    if (watched != m_view->viewport() || (!press && event->type() != QEvent::MouseButtonRelease))
        return QWidget::eventFilter(watched, event);
    const auto *mouse = static_cast<QMouseEvent *>(event);
    const QModelIndex index = m_view->indexAt(mouse->position().toPoint());
    if (mouse->button() != Qt::LeftButton || !index.isValid() || index.column() == StrokesModel::NameColumn)
        return QWidget::eventFilter(watched, event);
    if (press)
        m_model->toggle(m_filter->mapToSource(index));
    return true;
}

void StrokesPanel::documentChanged(const Change &change)
{
    if (change.reset || change.canvas)
        m_view->setRootIsDecorated(!m_editor.document().painting()->groups.empty());
    if (!change.selection && !change.order && !change.reset)
        return;
    if (isVisible())
        takeSelectionFromDocument();
    else
        m_stale = true;
}

void StrokesPanel::takeSelectionFromDocument()
{
    if (m_syncing)
        return;
    m_stale = false;
    m_syncing = true;
    // Runs of neighbouring rows: ten thousand single ranges would be slow.
    std::map<QModelIndex, std::vector<int>> rows;
    for (const StrokeId id : m_editor.document().selection().strokes)
        if (const QModelIndex index = viewIndexOf(id); index.isValid())
            rows[index.parent()].push_back(index.row());
    QItemSelection selection;
    QModelIndex first;
    for (auto &[parent, list] : rows) {
        std::sort(list.begin(), list.end());
        for (std::size_t i = 0; i < list.size();) {
            std::size_t end = i + 1;
            while (end < list.size() && list[end] == list[end - 1] + 1)
                ++end;
            const QModelIndex top = m_filter->index(list[i], 0, parent);
            selection.select(top, m_filter->index(list[end - 1], StrokesModel::LockColumn, parent));
            first = first.isValid() ? first : top;
            i = end;
        }
    }
    QItemSelectionModel *model = m_view->selectionModel();
    if (model->selection() != selection)
        model->select(selection, QItemSelectionModel::ClearAndSelect);
    if (first.isValid() && !m_view->hasFocus()) {
        model->setCurrentIndex(first, QItemSelectionModel::NoUpdate);
        m_view->scrollTo(first);
    }
    m_syncing = false;
}

void StrokesPanel::giveSelectionToDocument()
{
    if (m_syncing || m_model->isFollowing())
        return;
    Selection selection;
    for (const QModelIndex &index : m_view->selectionModel()->selectedRows(StrokesModel::NameColumn))
        selection.strokes.merge(m_model->strokesBelow(m_filter->mapToSource(index)));
    Document &document = m_editor.document();
    if (selection.strokes == document.selection().strokes)
        return;
    m_syncing = true; // a group's members get selected, the group's row stays
    document.setSelection(std::move(selection));
    m_syncing = false;
}

} // namespace suffuse
