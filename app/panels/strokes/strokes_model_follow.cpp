// How the rows follow the document.
#include "app/panels/strokes/strokes_model.h"
#include "app/session/editor.h"

#include <QScopedValueRollback>

#include <algorithm>
#include <unordered_set>

namespace suffuse {

namespace {

/// Groups alike but for their switches and names: the tree has the same shape.
bool sameTree(const std::vector<Group> &a, const std::vector<Group> &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Group &x, const Group &y) { return x.id == y.id && x.parent == y.parent; });
}

} // namespace

StrokesModel::Layout StrokesModel::layoutOf(const Painting &painting)
{
    std::unordered_map<GroupId, GroupId> parentOf;
    for (const Group &group : painting.groups)
        parentOf.emplace(group.id, group.parent);
    Layout layout;
    std::unordered_set<GroupId> placed;
    // A group stands where its topmost member stands.
    const auto place = [&](GroupId group) {
        while (group && parentOf.contains(group) && placed.insert(group).second) {
            layout[parentOf[group]].push_back({0, group});
            group = parentOf[group];
        }
    };
    for (auto it = painting.strokes.rbegin(); it != painting.strokes.rend(); ++it) {
        const GroupId group = parentOf.contains((*it)->group) ? (*it)->group : 0;
        place(group);
        layout[group].push_back({(*it)->id, 0});
    }
    for (const Group &group : painting.groups)
        place(group.id);
    return layout;
}

void StrokesModel::renumber(Node &node)
{
    for (std::size_t i = 0; i < node.children.size(); ++i)
        node.children[i]->row = int(i);
}

void StrokesModel::buildBelow(Node &node, const Layout &layout)
{
    const auto it = layout.find(node.group);
    if (it == layout.end())
        return;
    for (const Entry &entry : it->second) {
        auto child = std::make_unique<Node>();
        child->stroke = entry.stroke;
        child->group = entry.group;
        child->parent = &node;
        child->row = int(node.children.size());
        if (entry.stroke) {
            m_nodes[entry.stroke] = child.get();
            child->segments = int(m_values.at(entry.stroke)->segments.size());
        } else {
            buildBelow(*child, layout);
        }
        node.children.push_back(std::move(child));
    }
}

void StrokesModel::rebuild()
{
    beginResetModel();
    m_painting = m_editor.document().painting();
    m_groups = m_painting->groups;
    m_values.clear();
    m_values.reserve(m_painting->strokes.size());
    for (const StrokePtr &stroke : m_painting->strokes)
        m_values.emplace(stroke->id, stroke);
    m_nodes.clear();
    m_nodes.reserve(m_values.size());
    m_root = std::make_unique<Node>();
    buildBelow(*m_root, layoutOf(*m_painting));
    endResetModel();
}

void StrokesModel::documentChanged(const Change &change)
{
    const QScopedValueRollback following(m_following, true);
    const PaintingPtr painting = m_editor.document().painting();
    if (change.reset || !sameTree(painting->groups, m_groups)) {
        rebuild();
        return;
    }
    if (painting == m_painting)
        return;
    std::unordered_map<StrokeId, StrokePtr> changed;
    const std::set<StrokeId> ids(change.strokes.begin(), change.strokes.end());
    if (!ids.empty())
        for (const StrokePtr &stroke : painting->strokes)
            if (ids.contains(stroke->id))
                changed.emplace(stroke->id, stroke);
    const bool regrouped = std::any_of(changed.begin(), changed.end(), [&](const auto &entry) {
        const auto before = m_values.find(entry.first);
        return before != m_values.end() && entry.second->group != before->second->group;
    });
    if (regrouped) {
        rebuild();
        return;
    }
    for (const auto &[id, stroke] : changed)
        m_values.emplace(id, stroke); // what is new; rows that stay show their old values until they have followed
    if (change.order)
        follow(*painting);
    m_painting = painting;
    for (const auto &[id, stroke] : changed)
        if (const auto it = m_nodes.find(id); it != m_nodes.end())
            followSegments(*it->second, *stroke);
    std::vector<const Node *> news, withSegments;
    for (const StrokeId id : ids) {
        const auto now = changed.find(id);
        if (now == changed.end()) {
            m_values.erase(id);
            continue;
        }
        StrokePtr &value = m_values[id];
        if (const auto it = m_nodes.find(id); it != m_nodes.end()) {
            news.push_back(it->second);
            if (value->segments != now->second->segments)
                withSegments.push_back(it->second);
        }
        value = now->second;
    }
    const bool groupsChanged = m_groups != painting->groups;
    m_groups = painting->groups;
    announce(news, withSegments);
    if (groupsChanged && rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, LockColumn));
}

void StrokesModel::announce(const std::vector<const Node *> &strokes, const std::vector<const Node *> &withSegments)
{
    // From the first to the last below a parent: views look for each row, and a row that did not change costs less.
    std::unordered_map<const Node *, std::pair<const Node *, const Node *>> ends;
    for (const Node *node : strokes) {
        auto &[first, last] = ends.try_emplace(node->parent, node, node).first->second;
        first = node->row < first->row ? node : first;
        last = node->row > last->row ? node : last;
    }
    for (const auto &[parent, rows] : ends)
        emit dataChanged(indexOf(rows.first), indexOf(rows.second, LockColumn));
    for (const Node *node : withSegments) {
        const QModelIndex stroke = indexOf(node);
        if (node->segments > 0)
            emit dataChanged(index(0, NameColumn, stroke), index(node->segments - 1, NameColumn, stroke));
    }
}

void StrokesModel::followSegments(Node &node, const Stroke &stroke)
{
    const int wanted = int(stroke.segments.size());
    const QModelIndex parent = indexOf(&node);
    if (wanted > node.segments) {
        beginInsertRows(parent, node.segments, wanted - 1);
        node.segments = wanted;
        endInsertRows();
    } else if (wanted < node.segments) {
        beginRemoveRows(parent, wanted, node.segments - 1);
        node.segments = wanted;
        endRemoveRows();
    }
}

void StrokesModel::follow(const Painting &painting)
{
    const Layout layout = layoutOf(painting);
    std::vector<Node *> open{m_root.get()};
    while (!open.empty()) {
        Node *node = open.back();
        open.pop_back();
        const auto it = layout.find(node->group);
        followBelow(*node, it == layout.end() ? std::vector<Entry>{} : it->second);
        for (const auto &child : node->children)
            if (child->group)
                open.push_back(child.get());
    }
}

void StrokesModel::followBelow(Node &node, const std::vector<Entry> &wanted)
{
    removeMissing(node, wanted);
    insertNew(node, wanted);
    sortLike(node, wanted);
}

void StrokesModel::removeMissing(Node &node, const std::vector<Entry> &wanted)
{
    std::unordered_set<StrokeId> stay;
    for (const Entry &entry : wanted)
        stay.insert(entry.stroke);
    const auto gone = [&](int row) {
        const Node &child = *node.children[std::size_t(row)];
        return child.stroke && !stay.contains(child.stroke);
    };
    for (int last = int(node.children.size()) - 1; last >= 0; --last) {
        if (!gone(last))
            continue;
        int first = last;
        while (first > 0 && gone(first - 1))
            --first;
        beginRemoveRows(indexOf(&node), first, last);
        for (int row = first; row <= last; ++row)
            m_nodes.erase(node.children[std::size_t(row)]->stroke);
        node.children.erase(node.children.begin() + first, node.children.begin() + last + 1);
        renumber(node);
        endRemoveRows();
        last = first;
    }
}

void StrokesModel::insertNew(Node &node, const std::vector<Entry> &wanted)
{
    const auto isNew = [&](const Entry &entry) { return entry.stroke && !m_nodes.contains(entry.stroke); };
    // Behind the row that they follow in the new order; sorting moves what is left.
    int at = 0;
    for (std::size_t i = 0; i < wanted.size();) {
        if (!isNew(wanted[i])) {
            const Entry &entry = wanted[i++];
            const auto it = entry.stroke ? m_nodes.find(entry.stroke) : m_nodes.end();
            at = it != m_nodes.end() ? it->second->row + 1 : std::min(at + 1, int(node.children.size()));
            continue;
        }
        std::size_t end = i;
        while (end < wanted.size() && isNew(wanted[end]))
            ++end;
        beginInsertRows(indexOf(&node), at, at + int(end - i) - 1);
        std::vector<std::unique_ptr<Node>> added;
        for (; i < end; ++i) {
            auto child = std::make_unique<Node>();
            child->stroke = wanted[i].stroke;
            child->parent = &node;
            child->segments = int(m_values.at(child->stroke)->segments.size());
            m_nodes[child->stroke] = child.get();
            added.push_back(std::move(child));
        }
        node.children.insert(node.children.begin() + at, std::make_move_iterator(added.begin()),
                             std::make_move_iterator(added.end()));
        renumber(node);
        endInsertRows();
        at += int(added.size());
    }
}

void StrokesModel::sortLike(Node &node, const std::vector<Entry> &wanted)
{
    const auto matches = [&] {
        return std::equal(wanted.begin(), wanted.end(), node.children.begin(), node.children.end(),
                          [](const Entry &e, const auto &c) { return e.stroke == c->stroke && e.group == c->group; });
    };
    if (matches())
        return;
    std::unordered_map<StrokeId, int> strokeRows;
    std::unordered_map<GroupId, int> groupRows;
    for (std::size_t i = 0; i < wanted.size(); ++i)
        (wanted[i].stroke ? strokeRows[wanted[i].stroke] : groupRows[wanted[i].group]) = int(i);
    const auto rowOf = [&](const Node &n) { return n.stroke ? strokeRows[n.stroke] : groupRows[n.group]; };

    emit layoutAboutToBeChanged({QPersistentModelIndex(indexOf(&node))});
    const QModelIndexList before = persistentIndexList();
    std::sort(node.children.begin(), node.children.end(),
              [&](const auto &a, const auto &b) { return rowOf(*a) < rowOf(*b); });
    renumber(node);
    QModelIndexList after;
    for (const QModelIndex &old : before)
        after << (segmentAt(old) < 0 ? indexOf(nodeAt(old), old.column()) : old); // segments stay in their stroke
    changePersistentIndexList(before, after);
    emit layoutChanged({QPersistentModelIndex(indexOf(&node))});
}

} // namespace suffuse
