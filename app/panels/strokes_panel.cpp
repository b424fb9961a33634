#include "app/panels/strokes_panel.h"

#include "app/editor.h"
#include "app/icons.h"
#include "app/panels/stroke_thumbnails.h"
#include "app/panels/strokes_filter.h"
#include "app/panels/strokes_model.h"
#include "app/theme.h"
#include "app/tools/commands.h"

#include <QAction>
#include <QApplication>
#include <QCache>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPixmapCache>
#include <QStyledItemDelegate>
#include <QTreeView>
#include <QVBoxLayout>

#include <utility>

namespace suffuse {

namespace {

/// A small picture of the stroke before its name, a chip of its colour before a segment's; eyes and locks in the middle
/// of their columns.
class RowDelegate : public QStyledItemDelegate {
public:
    RowDelegate(const StrokesFilter &filter, const StrokesModel &model, StrokeThumbnails &thumbnails, Editor &editor,
                QObject *parent)
        : QStyledItemDelegate(parent), m_filter(filter), m_model(model), m_thumbnails(thumbnails), m_editor(editor)
    {}

    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
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
            // While a value is dragged, the canvas needs the cores.
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
            return;
        }
        QStyleOptionViewItem empty = option;
        initStyleOption(&empty, index);
        const QIcon icon = std::exchange(empty.icon, QIcon());
        empty.features &= ~QStyleOptionViewItem::HasDecoration;
        const QStyle *style = option.widget ? option.widget->style() : QApplication::style();
        style->drawControl(QStyle::CE_ItemViewItem, &empty, painter, option.widget);
        const bool selected = option.state & QStyle::State_Selected;
        const QRect area = QStyle::alignedRect(Qt::LeftToRight, Qt::AlignCenter, QSize(16, 16), option.rect);
        painter->drawPixmap(area, drawn(icon, index, selected, *painter, option));
    }

    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        QSize size = QStyledItemDelegate::sizeHint(option, index);
        size.setHeight(std::max(size.height(), StrokeThumbnails::size.height() + 4));
        return size;
    }

private:
    /// Icons are outlines that would be drawn anew in each of a screenful of rows.
    static QPixmap drawn(const QIcon &icon, const QModelIndex &index, bool selected, const QPainter &painter,
                         const QStyleOptionViewItem &option)
    {
        const double ratio = painter.device()->devicePixelRatioF();
        const QString key = QStringLiteral("strokes %1 %2 %3 %4 %5")
                                .arg(index.column())
                                .arg(index.data(StrokesModel::SwitchRole).toBool())
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

    /// A new icon for each painting would fill Qt's cache of pixmaps with the same ones.
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
        painter.fillPath(paper, previewPaper());
        painter.setClipPath(paper);
        painter.drawImage(QPointF(), image);
        QIcon icon(pixmap);
        icon.addPixmap(pixmap, QIcon::Selected); // selected paint keeps its colours
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
        painter.setPen(QPen(hairline(), 1));
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
    m_filter = new StrokesFilter(this);
    m_filter->setSourceModel(m_model);
    m_thumbnails = new StrokeThumbnails(this);
    connect(m_thumbnails, &StrokeThumbnails::ready, this, &StrokesPanel::redrawStroke);
    m_view = new QTreeView(this);
    setUpView();
    column->addWidget(m_view, 1);

    connect(m_search, &QLineEdit::textChanged, this, [this](const QString &text) {
        m_syncing = true; // rows that the search hides stay selected in the painting
        m_filter->setText(text.trimmed());
        m_syncing = false;
        m_view->setDragEnabled(text.trimmed().isEmpty());
        takeSelectionFromDocument();
    });
    m_view->viewport()->installEventFilter(this);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_view, &QTreeView::customContextMenuRequested, this, &StrokesPanel::showMenu);
    connect(&editor, &Editor::dragEnded, m_view->viewport(), qOverload<>(&QWidget::update));
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &StrokesPanel::giveSelectionToDocument);
    connect(&editor.laterChanges(), &LaterChanges::changed, this, &StrokesPanel::documentChanged);
    takeSelectionFromDocument();
}

void StrokesPanel::setUpView()
{
    m_view->setModel(m_filter);
    m_view->setItemDelegate(new RowDelegate(*m_filter, *m_model, *m_thumbnails, m_editor, m_view));
    m_view->setIconSize(StrokeThumbnails::size);
    m_view->setHeaderHidden(true);
    m_view->setUniformRowHeights(true);
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
    m_view->setToolTip(tr("The topmost stroke comes first. Drag to reorder, double-click to rename; a right click "
                          "offers more."));
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
    for (const SegmentRef &ref : m_editor.document().selection().segments)
        if (const QModelIndex stroke = viewIndexOf(ref.stroke); stroke.isValid() && m_view->isExpanded(stroke))
            rows[stroke].push_back(ref.segment);
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
    for (const QModelIndex &index : m_view->selectionModel()->selectedRows(StrokesModel::NameColumn)) {
        const QModelIndex source = m_filter->mapToSource(index);
        if (const int segment = m_model->segmentAt(source); segment >= 0) {
            selection.strokes.insert(m_model->strokeAt(source));
            selection.segments.insert({m_model->strokeAt(source), segment});
        } else {
            selection.strokes.merge(m_model->strokesBelow(source));
        }
    }
    Document &document = m_editor.document();
    // Of strokes that are not open here, no segment's row could be selected: those of the painting stay.
    for (const SegmentRef &ref : document.selection().segments)
        if (selection.strokes.contains(ref.stroke) && !m_view->isExpanded(viewIndexOf(ref.stroke)))
            selection.segments.insert(ref);
    if (selection == document.selection())
        return;
    m_syncing = true; // a group's members get selected, the group's row stays
    document.setSelection(std::move(selection));
    m_syncing = false;
}

void StrokesPanel::redrawStroke(StrokeId id)
{
    if (const QModelIndex index = viewIndexOf(id); index.isValid())
        m_view->update(index);
}

void StrokesPanel::showMenu(const QPoint &at)
{
    const QModelIndex index = m_view->indexAt(at);
    if (!index.isValid())
        return;
    QMenu menu;
    fillMenu(menu, index);
    menu.exec(m_view->viewport()->mapToGlobal(at));
}

void StrokesPanel::fillMenu(QMenu &menu, const QModelIndex &index)
{
    const QModelIndex name = index.siblingAtColumn(StrokesModel::NameColumn);
    if (name.flags() & Qt::ItemIsEditable)
        menu.addAction(tr("&Rename"), m_view, [this, name] { m_view->edit(name); });
    addSwitches(menu, m_filter->mapToSource(name));
    const Document &document = m_editor.document();
    const std::set<StrokeId> &selected = document.selection().strokes;
    const bool any = std::any_of(selected.begin(), selected.end(), [&](StrokeId id) {
        const StrokePtr stroke = document.painting()->find(id);
        return stroke && !document.painting()->isLocked(*stroke);
    });
    menu.addAction(icon("delete"), tr("&Delete"), this, [this] { commands::deleteSelected(m_editor); })
        ->setEnabled(any);
    menu.addSeparator();
    QMenu *same = menu.addMenu(tr("Select &Same"));
    same->setEnabled(!selected.empty());
    for (const auto &[text, what] : {std::pair(tr("&Colour"), Same::Colour), std::pair(tr("&Style"), Same::Style),
                                     std::pair(tr("&Brush"), Same::Brush)})
        same->addAction(text, this, [this, what = what] { commands::selectSameAs(m_editor, what); });
}

void StrokesPanel::addSwitches(QMenu &menu, const QModelIndex &index)
{
    if (!m_model->strokeAt(index)) { // a group
        for (const int column : {StrokesModel::EyeColumn, StrokesModel::LockColumn}) {
            const QModelIndex cell = index.siblingAtColumn(column);
            const bool on = cell.data(StrokesModel::SwitchRole).toBool();
            const QString text = column == StrokesModel::EyeColumn ? (on ? tr("&Hide") : tr("Sh&ow"))
                                                                   : (on ? tr("Un&lock") : tr("&Lock"));
            menu.addAction(text, this, [this, cell = QPersistentModelIndex(cell)] { m_model->toggle(cell); });
        }
        return;
    }
    // All that is selected goes the way of the row that was clicked.
    const StrokePtr stroke = m_model->strokeValueAt(index);
    std::set<StrokeId> strokes = m_editor.document().selection().strokes;
    strokes.insert(stroke->id);
    const bool visible = stroke->visible, locked = stroke->locked;
    menu.addAction(visible ? tr("&Hide") : tr("Sh&ow"), this, [this, strokes, visible] {
        m_editor.push(suffuse::setVisible(m_editor.document(), strokes, !visible),
                      visible ? tr("Hide strokes") : tr("Show strokes"));
    });
    menu.addAction(locked ? tr("Un&lock") : tr("&Lock"), this, [this, strokes, locked] {
        m_editor.push(setLocked(m_editor.document(), strokes, !locked),
                      locked ? tr("Unlock strokes") : tr("Lock strokes"));
    });
}

} // namespace suffuse
