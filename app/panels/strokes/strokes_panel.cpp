#include "app/panels/strokes/strokes_panel.h"

#include "app/panels/strokes/group_hand.h"
#include "app/panels/strokes/strokes_filter.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_view.h"
#include "app/session/commands/selection_commands.h"
#include "app/session/editor.h"
#include "app/widgets/habits/held_button.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/section.h"
#include "app/widgets/menu_titles.h"
#include "model/painting/editable.h"
#include "undo/group_edits.h"

#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace suffuse {

StrokesPanel::StrokesPanel(Editor &editor, const QList<QAction *> &more, QWidget *parent)
    : QWidget(parent), m_editor(editor), m_more(more)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 0);
    column->setSpacing(8);
    m_search = new QLineEdit(this);
    m_search->setObjectName("strokesSearch");
    m_search->setPlaceholderText(tr("Search"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(icon("search"), QLineEdit::LeadingPosition);
    m_search->setAccessibleName(tr("Search strokes"));
    m_search->setToolTip(tr("Shows only strokes and groups whose name holds this text. Return selects them."));
    column->addWidget(m_search);
    m_notFound = quietLabel({}, this);
    m_notFound->hide();
    column->addWidget(m_notFound);
    m_layer = quietLabel({}, this);
    m_layer->setObjectName("layer");
    m_layer->setTextFormat(Qt::PlainText);
    column->addWidget(m_layer);

    m_model = new StrokesModel(editor, this);
    m_filter = new StrokesFilter(this);
    m_filter->setSourceModel(m_model);
    m_view = new StrokesView(editor, *m_model, *m_filter, this);
    m_view->setAccessibleName(tr("Strokes"));
    m_view->setToolTip(tr("The topmost stroke comes first. Drag to reorder, double-click to rename; a right click "
                          "offers more."));
    column->addWidget(m_view, 1);

    connect(m_search, &QLineEdit::textChanged, this, [this](const QString &text) { search(text.trimmed()); });
    connect(m_view, &StrokesView::dragRefused, this, [this] {
        emit said(
            tr("While the list is searched, rows are not dragged: between those that show there may be others. Clear "
               "the search first."));
    });
    connect(m_view, &StrokesView::chosen, this, &StrokesPanel::chooseLayer);
    connect(&editor.layer(), &CurrentLayer::changed, this, &StrokesPanel::showLayer);
    showLayer();
    connect(m_search, &QLineEdit::returnPressed, this, &StrokesPanel::selectFound);
    // Strokes may come, go and be renamed during a search.
    for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(m_filter, signal, this, &StrokesPanel::showWhetherFound);
    connect(m_filter, &QAbstractItemModel::modelReset, this, &StrokesPanel::showWhetherFound);
    // Where a stroke goes into a group or out of it, rows are made anew. What was open stays so.
    connect(m_filter, &QAbstractItemModel::modelAboutToBeReset, this, [this] {
        m_openBefore = openGroups();
        m_scrolledTo = m_view->verticalScrollBar()->value();
    });
    connect(m_filter, &QAbstractItemModel::modelReset, this, [this] {
        forEachGroup({}, [this](const QModelIndex &group) {
            if (m_openBefore.contains(group.data(StrokesModel::GroupIdRole).toULongLong()))
                m_view->expand(group);
        });
        m_view->verticalScrollBar()->setValue(m_scrolledTo);
    });
    connect(m_model, &StrokesModel::droppedInto, this, &StrokesPanel::openGroup);
    m_search->installEventFilter(this);
    m_hand = new GroupHand(editor, *m_view);
    connect(m_hand, &GroupHand::said, this, &StrokesPanel::said);
    m_view->installEventFilter(this);
    m_view->viewport()->installEventFilter(this);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_view, &QTreeView::customContextMenuRequested, this, &StrokesPanel::showMenu);
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &StrokesPanel::giveSelectionToDocument);
    connect(&editor.laterChanges(), &LaterChanges::changed, this, &StrokesPanel::documentChanged);
    takeSelectionFromDocument();
}

bool StrokesPanel::isSearching() const
{
    return !m_filter->text().isEmpty();
}

void StrokesPanel::search(const QString &text)
{
    const bool before = isSearching();
    m_syncing = true; // Rows that the search hides stay selected in the painting.
    if (!before)
        m_openGroups = openGroups();
    m_filter->setText(text);
    // Groups are opened where something in them was found; after the search they are closed again.
    if (isSearching() || before)
        forEachGroup({}, [this](const QModelIndex &group) {
            const QModelIndex source = m_filter->mapToSource(group);
            const bool open = isSearching()
                                  ? m_filter->holdsMatchWithin(source)
                                  : m_openGroups.contains(source.data(StrokesModel::GroupIdRole).toULongLong());
            m_view->setExpanded(group, open);
        });
    m_syncing = false;
    showWhetherFound();
    takeSelectionFromDocument();
    if (before != isSearching())
        emit searchingChanged();
}

void StrokesPanel::showWhetherFound()
{
    const bool found = !isSearching() || m_filter->rowCount() > 0;
    if (!found)
        m_notFound->setText(tr("No stroke is called “%1”.").arg(m_filter->text()));
    m_notFound->setVisible(!found);
}

void StrokesPanel::showLayer()
{
    const CurrentLayer &layer = m_editor.layer();
    m_layer->setText(layer.group() == 0 ? tr("Painting on top of all")
                     : layer.isComing() ? tr("New layer: %1").arg(layer.title())
                                        : tr("Painting on: %1").arg(layer.title()));
    m_layer->setToolTip(layer.isComing()
                            ? tr("The layer comes into the list with the first stroke that is painted.")
                            : tr("What is painted goes into this group. A click beside all rows: on top of "
                                 "all again."));
}

void StrokesPanel::chooseLayer(const QModelIndex &index)
{
    const QModelIndex row = m_filter->mapToSource(index);
    const StrokePtr stroke = m_model->strokeValueAt(row);
    m_editor.layer().choose(stroke ? stroke->group : row.data(StrokesModel::GroupIdRole).toULongLong());
}

void StrokesPanel::forEachGroup(const QModelIndex &parent, const std::function<void(const QModelIndex &)> &visit) const
{
    for (int row = 0; row < m_filter->rowCount(parent); ++row) {
        const QModelIndex index = m_filter->index(row, StrokesModel::NameColumn, parent);
        if (index.data(StrokesModel::GroupIdRole).toULongLong() == 0)
            continue;
        visit(index);
        forEachGroup(index, visit);
    }
}

void StrokesPanel::openGroup(GroupId id)
{
    forEachGroup({}, [&](QModelIndex group) {
        if (group.data(StrokesModel::GroupIdRole).toULongLong() != id)
            return;
        for (; group.isValid(); group = group.parent())
            m_view->expand(group);
    });
}

std::set<GroupId> StrokesPanel::openGroups() const
{
    std::set<GroupId> open;
    forEachGroup({}, [&](const QModelIndex &group) {
        if (m_view->isExpanded(group))
            open.insert(group.data(StrokesModel::GroupIdRole).toULongLong());
    });
    return open;
}

std::set<StrokeId> StrokesPanel::foundBelow(const QModelIndex &index) const
{
    if (const StrokeId stroke = m_model->strokeAt(m_filter->mapToSource(index)))
        return {stroke};
    std::set<StrokeId> found;
    for (int row = 0; row < m_filter->rowCount(index); ++row)
        found.merge(foundBelow(m_filter->index(row, StrokesModel::NameColumn, index)));
    return found;
}

void StrokesPanel::selectFound()
{
    if (!isSearching())
        return;
    const Painting &painting = *m_editor.document().painting();
    Selection selection{foundBelow({}), {}};
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (!isEditable(*stroke))
            selection.strokes.erase(stroke->id);
    m_editor.document().setSelection(std::move(selection));
}

void StrokesPanel::goToFirstFound()
{
    QModelIndex row = m_filter->index(0, StrokesModel::NameColumn);
    while (isSearching() && row.isValid() && !m_filter->matches(m_filter->mapToSource(row)) &&
           m_view->indexBelow(row).isValid())
        row = m_view->indexBelow(row); // A row above it may be a group's.
    if (!row.isValid())
        return;
    m_view->setFocus(Qt::TabFocusReason);
    m_view->setCurrentIndex(row);
}

QTreeView *StrokesPanel::view() const
{
    return m_view;
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
    if (watched == m_search && event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent *>(event)->key() == Qt::Key_Down) {
        goToFirstFound();
        return true;
    }
    if (watched == m_view && m_hand->isDragging() && event->type() == QEvent::KeyPress &&
        givesUpDrag(*static_cast<QKeyEvent *>(event))) {
        m_hand->giveUp();
        return true;
    }
    const bool used = watched == m_view->viewport() && (handTakes(*event) || sweep(*event));
    return used || QWidget::eventFilter(watched, event);
}

bool StrokesPanel::handTakes(const QEvent &event)
{
    if (event.type() != QEvent::MouseButtonPress && event.type() != QEvent::MouseButtonDblClick &&
        event.type() != QEvent::MouseMove && event.type() != QEvent::MouseButtonRelease)
        return false;
    const auto &mouse = static_cast<const QMouseEvent &>(event);
    const QModelIndex row = m_view->indexAt(mouse.position().toPoint()).siblingAtColumn(StrokesModel::NameColumn);
    const Group *group = row.isValid() ? m_model->groupAt(m_filter->mapToSource(row)) : nullptr;
    return m_hand->takes(mouse, row, group, m_view->cellsOf(row));
}

bool StrokesPanel::sweep(const QEvent &event)
{
    const bool press = event.type() == QEvent::MouseButtonPress || event.type() == QEvent::MouseButtonDblClick;
    if (!press && event.type() != QEvent::MouseMove && event.type() != QEvent::MouseButtonRelease)
        return false;
    const auto &mouse = static_cast<const QMouseEvent &>(event);
    const QModelIndex at = m_view->indexAt(mouse.position().toPoint());
    if (press && mouse.button() == Qt::LeftButton && at.isValid() && at.column() != StrokesModel::NameColumn)
        m_sweep = Sweep{at.column(), at.data(StrokesModel::SwitchRole).toBool()};
    else if (press || !m_sweep)
        return false;
    const QModelIndex row = at.siblingAtColumn(m_sweep ? m_sweep->column : 0);
    const bool held = mouse.buttons() & Qt::LeftButton;
    if (held && row.isValid() && row.data(StrokesModel::SwitchRole).toBool() == m_sweep->from)
        m_model->toggle(m_filter->mapToSource(row), &m_sweepStep);
    if (!held) {
        m_sweep.reset();
        m_sweepStep.endSteps();
    }
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
    m_view->viewport()->update(); // The rows of groups change, too.
    if (m_syncing)
        return;
    m_stale = false;
    m_syncing = true;
    // Runs of neighbouring rows are selected at once, since ten thousand single ranges would take long.
    std::map<QModelIndex, std::vector<int>> rows;
    for (const StrokeId id : m_editor.selection().strokes)
        if (const QModelIndex index = viewIndexOf(id); index.isValid())
            rows[index.parent()].push_back(index.row());
    for (const SegmentRef &ref : m_editor.selection().segments)
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
    const bool isOwn = m_given == m_editor.selection();
    if (!isOwn)
        m_given.reset();
    // Who goes through the rows keeps their place. But what an undo selects, for example, is where they go on.
    const QWidget *focus = QApplication::focusWidget();
    const bool isElsewhere = !focus || (focus != m_view && !m_view->isAncestorOf(focus));
    const bool comesHere = focus == m_view && !isOwn && !model->isSelected(m_view->currentIndex());
    if (first.isValid() && (isElsewhere || comesHere)) {
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
    QModelIndexList passed; // These groups lie in the range, and each row in them stands for itself.
    const std::set<QModelIndex> holding = m_view->isRanging() ? groupsAroundSelected() : std::set<QModelIndex>();
    const auto take = [&](const QModelIndex &index) {
        const QModelIndex source = m_filter->mapToSource(index);
        if (const int segment = m_model->segmentAt(source); segment >= 0) {
            selection.strokes.insert(m_model->strokeAt(source));
            selection.segments.insert({m_model->strokeAt(source), segment});
        } else if (m_model->strokeAt(source) == 0 && holding.contains(index)) {
            passed << index;
        } else {
            selection.strokes.merge(isSearching() ? foundBelow(index) : m_model->strokesBelow(source));
        }
    };
    // In Qt 6.4 selectedRows leaves out rows with the number of a row that was just toggled under another parent.
    for (const QItemSelectionRange &range : m_view->selectionModel()->selection())
        for (int row = range.top(); row <= range.bottom() && range.left() == StrokesModel::NameColumn; ++row)
            take(m_filter->index(row, StrokesModel::NameColumn, range.parent()));
    Document &document = m_editor.document();
    // Rows of segments can be selected only below open strokes, so segments of the others stay selected.
    for (const SegmentRef &ref : document.selection().segments)
        if (selection.strokes.contains(ref.stroke) && !m_view->isExpanded(viewIndexOf(ref.stroke)))
            selection.segments.insert(ref);
    m_syncing = true; // The members of a group get selected, and its row stays so.
    for (const QModelIndex &group : passed)
        m_view->selectionModel()->select(group, QItemSelectionModel::Deselect | QItemSelectionModel::Rows);
    document.setSelection(std::move(selection));
    m_given = document.selection();
    m_syncing = false;
}

/// The groups that contain a selected row.
std::set<QModelIndex> StrokesPanel::groupsAroundSelected() const
{
    std::set<QModelIndex> around;
    for (const QItemSelectionRange &range : m_view->selectionModel()->selection())
        for (QModelIndex above = range.parent(); above.isValid(); above = above.parent())
            if (!around.insert(above).second)
                break;
    return around;
}

void StrokesPanel::showMenu(const QPoint &at)
{
    const QModelIndex index = m_view->indexAt(at);
    if (!index.isValid())
        return;
    QMenu menu;
    makeMenu(menu, index);
    menu.exec(m_view->viewport()->mapToGlobal(at));
}

void StrokesPanel::makeMenu(QMenu &menu, const QModelIndex &index)
{
    fillMenu(menu, index);
    const QPersistentModelIndex row = index.siblingAtColumn(StrokesModel::NameColumn);
    if (const Group *group = m_model->groupAt(m_filter->mapToSource(row))) {
        menu.addSeparator();
        m_hand->fillModes(*menu.addMenu(tr("&Mode")), group->id);
        menu.addAction(tr("O&pacity…"), this, [this, row] {
            if (const Group *now = row.isValid() ? m_model->groupAt(m_filter->mapToSource(row)) : nullptr)
                m_hand->typeOpacity(row, *now, m_view->cellsOf(row));
        });
    }
    makeMnemonicsDistinct(menu);
}

void StrokesPanel::fillMenu(QMenu &menu, const QModelIndex &index)
{
    const QModelIndex name = index.siblingAtColumn(StrokesModel::NameColumn);
    if (name.flags() & Qt::ItemIsEditable)
        menu.addAction(tr("&Rename"), m_view, [this, name] { m_view->edit(name); });
    addSwitches(menu, m_filter->mapToSource(name));
    const Document &document = m_editor.document();
    const std::set<StrokeId> &selected = document.selection().strokes;
    const Locks isLocked(document.painting()->groups);
    const bool any = std::any_of(selected.begin(), selected.end(), [&](StrokeId id) {
        const StrokePtr stroke = document.painting()->find(id);
        return stroke && !isLocked(*stroke);
    });
    menu.addAction(icon("delete"), tr("&Delete"), this, [this] { commands::deleteSelected(m_editor); })
        ->setEnabled(any);
    menu.addSeparator();
    menu.addActions(m_more);
    menu.addSeparator();
    QMenu *same = menu.addMenu(tr("Select &Same"));
    same->setEnabled(!selected.empty());
    for (const auto &[text, what] : {std::pair(tr("&Colour"), Same::Colour), std::pair(tr("&Style"), Same::Style),
                                     std::pair(tr("&Brush"), Same::Brush), std::pair(tr("&Name"), Same::Name)})
        same->addAction(text, this, [this, what = what] { commands::selectSameAs(m_editor, what); });
}

/// A group that blends mixes by itself in any case, and a locked one stays as it is.
void StrokesPanel::addIsolated(QMenu &menu, GroupId id)
{
    const Document &document = m_editor.document();
    const Group *group = document.painting()->findGroup(id);
    if (!group)
        return;
    const bool on = group->isolated, isFree = !group->blends();
    QAction *action = menu.addAction(tr("Mi&x by Itself"), this, [this, id, on] {
        m_editor.push(setGroupIsolated(m_editor.document(), {id}, !on),
                      on ? tr("Mix group with what lies below") : tr("Mix group by itself"));
    });
    action->setCheckable(true);
    action->setChecked(group->isIsolated());
    action->setEnabled(isFree && !setGroupIsolated(document, {id}, !on).isEmpty());
}

void StrokesPanel::addSwitches(QMenu &menu, const QModelIndex &index)
{
    if (!m_model->strokeAt(index)) { // The row is a group's.
        for (const int column : {StrokesModel::EyeColumn, StrokesModel::LockColumn}) {
            const QModelIndex cell = index.siblingAtColumn(column);
            const bool on = cell.data(StrokesModel::SwitchRole).toBool();
            const QString text = column == StrokesModel::EyeColumn ? (on ? tr("&Hide") : tr("Sh&ow"))
                                                                   : (on ? tr("Un&lock") : tr("&Lock"));
            menu.addAction(text, this, [this, cell = QPersistentModelIndex(cell)] { m_model->toggle(cell); });
        }
        addIsolated(menu, index.data(StrokesModel::GroupIdRole).toULongLong());
        return;
    }
    // All that is selected changes as the row does that was clicked.
    const StrokePtr stroke = m_model->strokeValueAt(index);
    std::set<StrokeId> strokes = m_editor.selection().strokes;
    strokes.insert(stroke->id);
    const bool visible = stroke->visible, locked = stroke->locked;
    menu.addAction(visible ? tr("&Hide") : tr("Sh&ow"), this, [this, strokes, visible] {
        m_editor.push(suffuse::setVisible(m_editor.document(), strokes, !visible),
                      visible ? tr("Hide strokes") : tr("Show strokes"));
        commands::deselectHidden(m_editor);
    });
    menu.addAction(locked ? tr("Un&lock") : tr("&Lock"), this, [this, strokes, locked] {
        m_editor.push(setLocked(m_editor.document(), strokes, !locked),
                      locked ? tr("Unlock strokes") : tr("Lock strokes"));
    });
}

} // namespace suffuse
