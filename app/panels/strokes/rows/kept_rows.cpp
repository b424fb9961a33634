#include "app/panels/strokes/rows/kept_rows.h"

#include "app/panels/strokes/strokes_filter.h"
#include "app/panels/strokes/strokes_model.h"

#include <QScrollBar>
#include <QTreeView>

namespace suffuse {

KeptRows::KeptRows(QTreeView &view, const StrokesModel &model, StrokesFilter &filter)
    : QObject(&view), m_view(view), m_model(model), m_filter(filter)
{
    connect(&filter, &StrokesFilter::aboutToReset, this, &KeptRows::noteAll);
    connect(&filter, &QAbstractItemModel::modelReset, this, &KeptRows::restoreAll);
    connect(&filter, &QAbstractItemModel::rowsAboutToBeRemoved, this, &KeptRows::noteGoing);
    connect(&filter, &QAbstractItemModel::rowsInserted, this, &KeptRows::restoreComing);
    connect(&model, &StrokesModel::aboutToFollow, this, [this] { m_moving = rowOf(m_view.currentIndex()); });
    connect(&model, &StrokesModel::followed, this, [this] { m_moving = {}; });
}

KeptRows::Row KeptRows::rowOf(const QModelIndex &index)
{
    return index.isValid() ? Row{index.data(StrokesModel::StrokeIdRole).toULongLong(),
                                 index.data(StrokesModel::GroupIdRole).toULongLong()}
                           : Row();
}

QModelIndex KeptRows::viewIndexOf(const Node *node) const
{
    return node ? m_filter.mapFromSource(m_model.indexOf(node)) : QModelIndex();
}

QModelIndex KeptRows::viewIndexOf(const Row &row) const
{
    return viewIndexOf(row.stroke ? m_model.tree().nodeOf(row.stroke) : m_model.tree().nodeOfGroup(row.group));
}

/// Visits the groups below a node, the outer ones first.
void KeptRows::visitGroups(const Node &node, const std::function<void(const Node &)> &visit) const
{
    for (const auto &child : node.children)
        if (child->group != 0) {
            visit(*child);
            visitGroups(*child, visit);
        }
}

void KeptRows::noteOpen(const Node &below)
{
    visitGroups(below, [this](const Node &group) {
        if (m_view.isExpanded(viewIndexOf(&group)))
            m_open.insert(group.group);
        else
            m_open.erase(group.group);
    });
}

void KeptRows::expand(const std::set<GroupId> &groups, const Node &below)
{
    if (!groups.empty())
        visitGroups(below, [&](const Node &group) {
            if (groups.contains(group.group))
                m_view.expand(viewIndexOf(&group));
        });
}

void KeptRows::noteAll()
{
    m_open.clear();
    noteOpen(m_model.tree().root());
    m_scrolledTo = m_view.verticalScrollBar()->value();
    m_current.clear();
    if (const QModelIndex current = m_view.currentIndex(); current.isValid())
        for (const QModelIndex &row : {current, m_view.indexBelow(current), m_view.indexAbove(current)})
            m_current.push_back(rowOf(row));
}

void KeptRows::restoreAll()
{
    expand(m_open, m_model.tree().root());
    for (const Row &row : std::exchange(m_current, {}))
        if (const QModelIndex index = row.isRow() ? viewIndexOf(row) : QModelIndex(); index.isValid()) {
            m_view.selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
            break;
        }
    m_view.verticalScrollBar()->setValue(m_scrolledTo);
}

void KeptRows::noteGoing(const QModelIndex &parent, int first, int last)
{
    for (int row = first; row <= last; ++row) {
        const GroupId id = m_filter.index(row, 0, parent).data(StrokesModel::GroupIdRole).toULongLong();
        const Node *group = id ? m_model.tree().nodeOfGroup(id) : nullptr;
        if (!group)
            continue;
        if (m_view.isExpanded(viewIndexOf(group)))
            m_open.insert(id);
        else
            m_open.erase(id);
        noteOpen(*group);
    }
}

void KeptRows::restoreComing(const QModelIndex &parent, int first, int last)
{
    for (int row = first; row <= last; ++row) {
        const QModelIndex index = m_filter.index(row, 0, parent);
        const GroupId id = index.data(StrokesModel::GroupIdRole).toULongLong();
        if (const Node *group = id ? m_model.tree().nodeOfGroup(id) : nullptr) {
            if (m_open.contains(id))
                m_view.expand(index);
            expand(m_open, *group);
        }
    }
    if (m_moving.isRow() && rowOf(m_view.currentIndex()) != m_moving)
        if (const QModelIndex moved = viewIndexOf(m_moving); moved.isValid())
            m_view.selectionModel()->setCurrentIndex(moved, QItemSelectionModel::NoUpdate);
}

void KeptRows::search(const QString &text)
{
    const bool searches = !text.isEmpty(), searched = !m_filter.text().isEmpty();
    if (searches && !searched) {
        m_open.clear();
        noteOpen(m_model.tree().root());
        m_beforeSearch = m_open;
    }
    m_filter.setText(text);
    if (searches || searched)
        visitGroups(m_model.tree().root(), [&](const Node &group) {
            const bool opens =
                searches ? m_filter.holdsMatchWithin(m_model.indexOf(&group)) : m_beforeSearch.contains(group.group);
            if (const QModelIndex index = viewIndexOf(&group); index.isValid() && m_view.isExpanded(index) != opens)
                m_view.setExpanded(index, opens);
        });
}

std::set<GroupId> KeptRows::openGroups() const
{
    if (!m_filter.text().isEmpty())
        return m_beforeSearch;
    std::set<GroupId> open;
    visitGroups(m_model.tree().root(), [&](const Node &group) {
        if (m_view.isExpanded(viewIndexOf(&group)))
            open.insert(group.group);
    });
    return open;
}

void KeptRows::openOnly(const std::set<GroupId> &groups)
{
    if (!m_filter.text().isEmpty())
        m_beforeSearch = groups;
    else
        visitGroups(m_model.tree().root(), [&](const Node &group) {
            if (const QModelIndex index = viewIndexOf(&group); m_view.isExpanded(index) != groups.contains(group.group))
                m_view.setExpanded(index, groups.contains(group.group));
        });
}

void KeptRows::open(GroupId group)
{
    for (QModelIndex index = viewIndexOf(Row{0, group}); index.isValid(); index = index.parent())
        m_view.expand(index);
}

} // namespace suffuse
