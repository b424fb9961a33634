#include "app/panels/strokes/rows/row_selection.h"

#include "app/panels/strokes/rows/row_moves.h"
#include "app/panels/strokes/strokes_filter.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_view.h"
#include "app/session/editor.h"

#include <QApplication>
#include <QScopedValueRollback>

#include <algorithm>

namespace suffuse {

RowSelection::RowSelection(Editor &editor, const StrokesModel &model, const StrokesFilter &filter, StrokesView &view)
    : QObject(&view), m_editor(editor), m_model(model), m_filter(filter), m_view(view)
{
    connect(view.selectionModel(), &QItemSelectionModel::selectionChanged, this, &RowSelection::give);
    connect(&filter, &QAbstractItemModel::modelReset, this, &RowSelection::followRows);
    connect(&editor.laterChanges(), &LaterChanges::changed, this, [this](const Change &change) {
        if (change.selection || change.reset)
            follow();
        else if (change.order)
            followRows();
    });
    view.installEventFilter(this);
    take();
}

bool RowSelection::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Show && m_stale)
        take();
    return QObject::eventFilter(watched, event);
}

void RowSelection::follow()
{
    m_isNew = true;
    followRows();
}

void RowSelection::followRows()
{
    m_stale = true;
    if (m_view.isVisible())
        take();
}

RowSelection::Rows RowSelection::rowsOf(const Selection &selected) const
{
    const bool allShown = m_filter.text().isEmpty();
    Rows rows;
    for (const StrokeId id : selected.strokes)
        if (const StrokesTree::Node *node = m_model.tree().nodeOf(id)) {
            const int row = allShown ? node->row : m_filter.mapFromSource(m_model.indexOf(node)).row();
            if (row >= 0)
                rows[node->parent].push_back(row);
        }
    for (const SegmentRef &ref : selected.segments)
        if (const StrokesTree::Node *node = m_model.tree().nodeOf(ref.stroke))
            if (m_view.isExpanded(m_filter.mapFromSource(m_model.indexOf(node))))
                rows[node].push_back(ref.segment);
    for (auto &[node, list] : rows)
        std::ranges::sort(list);
    return rows;
}

/// Runs of neighbouring rows are selected at once, since ten thousand single ranges would take long.
QItemSelection RowSelection::selectionOf(const Rows &rows) const
{
    QItemSelection selection;
    for (const auto &[node, list] : rows) {
        const QModelIndex parent = m_filter.mapFromSource(m_model.indexOf(node));
        for (auto at = list.begin(); at != list.end();) {
            auto end = at + 1;
            while (end != list.end() && *end == *(end - 1) + 1)
                ++end;
            selection.append(QItemSelectionRange(m_filter.index(*at, StrokesModel::NameColumn, parent),
                                                 m_filter.index(*(end - 1), StrokesModel::LockColumn, parent)));
            at = end;
        }
    }
    return selection;
}

/// The topmost row that looks selected and for which no group has to be opened; otherwise the topmost in closed groups.
/// A group all of whose strokes are selected looks so itself.
QModelIndex RowSelection::rowToShow(const Rows &rows) const
{
    using Node = StrokesTree::Node;
    std::unordered_map<const Node *, bool> known;
    const auto isWhole = [&](const Node *group, const auto &again) -> bool {
        if (const auto it = known.find(group); it != known.end())
            return it->second;
        const auto own = rows.find(group);
        std::size_t whole = own == rows.end() ? 0 : own->second.size();
        for (const auto &child : group->children)
            whole += child->group != 0 && again(child.get(), again);
        return known[group] = !group->children.empty() && whole == group->children.size();
    };
    QModelIndex best;
    std::pair<bool, std::vector<int>> bestPlace; // whether something is to be opened, and the rows from the top
    for (const auto &[parent, list] : rows) {
        if (parent->stroke)
            continue; // The row of the stroke is selected, too.
        QModelIndex row =
            m_filter.index(list.front(), StrokesModel::NameColumn, m_filter.mapFromSource(m_model.indexOf(parent)));
        for (const Node *group = parent; group->group && isWhole(group, isWhole); group = group->parent)
            row = m_filter.mapFromSource(m_model.indexOf(group));
        std::pair<bool, std::vector<int>> place(false, placeOf(row));
        for (QModelIndex above = row.parent(); above.isValid(); above = above.parent())
            place.first |= !m_view.isExpanded(above);
        if (!best.isValid() || place < bestPlace)
            best = row, bestPlace = std::move(place);
    }
    return best;
}

void RowSelection::take()
{
    m_view.viewport()->update(); // The rows of groups change, too.
    if (m_syncing)
        return;
    m_stale = false;
    const bool isNew = std::exchange(m_isNew, false);
    const QScopedValueRollback syncing(m_syncing, true);
    const Rows rows = rowsOf(m_editor.selection());
    const QItemSelection selection = selectionOf(rows);
    QItemSelectionModel *model = m_view.selectionModel();
    if (model->selection() != selection)
        model->select(selection, QItemSelectionModel::ClearAndSelect);
    const bool isOwn = m_given == m_editor.selection();
    if (!isOwn)
        m_given.reset();
    // Who goes through the rows keeps their place. But what an undo selects, for example, is where they go on.
    const QWidget *focus = QApplication::focusWidget();
    const bool isElsewhere = !focus || (focus != &m_view && !m_view.isAncestorOf(focus));
    const bool comesHere = focus == &m_view && !isOwn && !model->isSelected(m_view.currentIndex());
    if (!isNew || (!isElsewhere && !comesHere))
        return;
    if (const QModelIndex row = rowToShow(rows); row.isValid()) {
        model->setCurrentIndex(row, QItemSelectionModel::NoUpdate);
        m_view.scrollTo(row);
    }
}

std::set<StrokeId> RowSelection::foundBelow(const QModelIndex &index) const
{
    if (const StrokeId stroke = m_model.strokeAt(m_filter.mapToSource(index)))
        return {stroke};
    std::set<StrokeId> found;
    for (int row = 0; row < m_filter.rowCount(index); ++row)
        found.merge(foundBelow(m_filter.index(row, StrokesModel::NameColumn, index)));
    return found;
}

void RowSelection::give()
{
    if (m_syncing || m_model.isFollowing())
        return;
    Selection selection;
    QModelIndexList passed; // These groups lie in the range, and each row in them stands for itself.
    const std::set<QModelIndex> holding = m_view.isRanging() ? groupsAroundSelected() : std::set<QModelIndex>();
    const auto take = [&](const QModelIndex &index) {
        const QModelIndex source = m_filter.mapToSource(index);
        const StrokeId stroke = m_model.strokeAt(source);
        if (const int segment = m_model.segmentAt(source); segment >= 0) {
            selection.strokes.insert(stroke);
            selection.segments.insert({stroke, segment});
        } else if (stroke != 0) {
            selection.strokes.insert(stroke);
        } else if (holding.contains(index)) {
            passed << index;
        } else {
            selection.strokes.merge(m_filter.text().isEmpty() ? m_model.strokesBelow(source) : foundBelow(index));
        }
    };
    // In Qt 6.4 selectedRows leaves out rows with the number of a row that was just toggled under another parent.
    for (const QItemSelectionRange &range : m_view.selectionModel()->selection()) {
        const QModelIndex parent = range.parent();
        for (int row = range.top(); row <= range.bottom() && range.left() == StrokesModel::NameColumn; ++row)
            take(m_filter.index(row, StrokesModel::NameColumn, parent));
    }
    Document &document = m_editor.document();
    // Rows of segments can be selected only below open strokes, so segments of the others stay selected.
    for (const SegmentRef &ref : document.selection().segments)
        if (selection.strokes.contains(ref.stroke) &&
            !m_view.isExpanded(m_filter.mapFromSource(m_model.indexOf(ref.stroke))))
            selection.segments.insert(ref);
    const QScopedValueRollback syncing(m_syncing, true); // The members of a group get selected, and its row stays so.
    for (const QModelIndex &group : passed)
        m_view.selectionModel()->select(group, QItemSelectionModel::Deselect | QItemSelectionModel::Rows);
    document.setSelection(std::move(selection));
    m_given = document.selection();
}

/// The groups that contain a selected row.
std::set<QModelIndex> RowSelection::groupsAroundSelected() const
{
    std::set<QModelIndex> around;
    for (const QItemSelectionRange &range : m_view.selectionModel()->selection())
        for (QModelIndex above = range.parent(); above.isValid(); above = above.parent())
            if (!around.insert(above).second)
                break;
    return around;
}

} // namespace suffuse
