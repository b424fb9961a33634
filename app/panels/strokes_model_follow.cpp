// How the rows follow the document, and how rows are moved.
#include "app/editor.h"
#include "app/panels/strokes_model.h"
#include "undo/edits.h"

#include <QDataStream>
#include <QIODevice>
#include <QMimeData>
#include <QScopedValueRollback>

#include <algorithm>
#include <unordered_set>

namespace suffuse {

namespace {

const char rowsMime[] = "application/x-suffuse-stroke-rows";

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
        if (entry.stroke)
            m_nodes[entry.stroke] = child.get();
        else
            buildBelow(*child, layout);
        node.children.push_back(std::move(child));
    }
}

void StrokesModel::rebuild()
{
    beginResetModel();
    m_painting = m_editor.document().painting();
    m_groups = m_painting->groups;
    m_values.clear();
    for (const StrokePtr &stroke : m_painting->strokes)
        m_values.emplace(stroke->id, stroke.get());
    m_nodes.clear();
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
    std::unordered_map<StrokeId, const Stroke *> values;
    for (const StrokePtr &stroke : painting->strokes)
        values.emplace(stroke->id, stroke.get());
    const bool regrouped = std::any_of(change.strokes.begin(), change.strokes.end(), [&](StrokeId id) {
        const auto now = values.find(id), before = m_values.find(id);
        return now != values.end() && before != m_values.end() && now->second->group != before->second->group;
    });
    if (regrouped) {
        rebuild();
        return;
    }
    const PaintingPtr keptAlive = m_painting; // rows on their way out still show their values
    if (change.order)
        follow(*painting);
    m_values = std::move(values);
    m_painting = painting;
    const bool groupsChanged = m_groups != painting->groups;
    m_groups = painting->groups;
    for (const StrokeId id : change.strokes)
        if (const auto it = m_nodes.find(id); it != m_nodes.end())
            emit dataChanged(indexOf(it->second, NameColumn), indexOf(it->second, LockColumn));
    if (groupsChanged && rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, LockColumn));
}

void StrokesModel::follow(const Painting &painting)
{
    for (const StrokePtr &stroke : painting.strokes)
        m_values.emplace(stroke->id, stroke.get());
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
        after << indexOf(nodeAt(old), old.column());
    changePersistentIndexList(before, after);
    emit layoutChanged({QPersistentModelIndex(indexOf(&node))});
}

QStringList StrokesModel::mimeTypes() const
{
    return {rowsMime};
}

QMimeData *StrokesModel::mimeData(const QModelIndexList &indexes) const
{
    std::set<StrokeId> ids;
    for (const QModelIndex &index : indexes)
        if (index.column() == NameColumn)
            ids.merge(strokesBelow(index));
    QByteArray bytes;
    QDataStream out(&bytes, QIODevice::WriteOnly);
    out << quint64(reinterpret_cast<quintptr>(this));
    for (const StrokeId id : ids)
        out << quint64(id);
    auto *data = new QMimeData;
    data->setData(rowsMime, bytes);
    return data;
}

bool StrokesModel::canDropMimeData(const QMimeData *data, Qt::DropAction action, int, int, const QModelIndex &) const
{
    return data && action == Qt::MoveAction && data->hasFormat(rowsMime);
}

StrokeId StrokesModel::lowestStrokeOf(const Node &node) const
{
    if (node.stroke)
        return node.stroke;
    for (auto it = node.children.rbegin(); it != node.children.rend(); ++it)
        if (const StrokeId id = lowestStrokeOf(**it))
            return id;
    return 0;
}

bool StrokesModel::dropMimeData(const QMimeData *data, Qt::DropAction action, int row, int, const QModelIndex &parent)
{
    if (!canDropMimeData(data, action, 0, 0, parent))
        return false;
    QDataStream in(data->data(rowsMime));
    quint64 source = 0;
    in >> source;
    if (source != quint64(reinterpret_cast<quintptr>(this)))
        return false; // rows of another window
    std::set<StrokeId> moved;
    for (quint64 id = 0; !in.atEnd();) {
        in >> id;
        if (m_nodes.contains(id))
            moved.insert(id);
    }
    if (moved.empty())
        return false;

    const Node *target = nodeAt(parent);
    if (target->stroke) { // onto a stroke: just above it
        row = target->row;
        target = target->parent;
    }
    if (row < 0)
        row = target->group ? 0 : int(target->children.size());
    // Below the next row above that stays where it is; on top of a group: below what stands above the group.
    StrokeId before = 0;
    const Node *at = target;
    for (int above = row - 1; at && !before;) {
        for (; above >= 0 && !before; --above) {
            const StrokeId lowest = lowestStrokeOf(*at->children[std::size_t(above)]);
            before = lowest && !moved.contains(lowest) ? lowest : 0;
        }
        above = at->row - 1;
        at = at->parent;
    }
    moveInto(moved, before, target->group);
    // The rows have moved already, with the document: the view has nothing to remove.
    return false;
}

void StrokesModel::moveInto(const std::set<StrokeId> &strokes, StrokeId before, GroupId group)
{
    const Document &document = m_editor.document();
    const Painting &painting = *document.painting();
    bool regroups = false;
    for (const StrokeId id : strokes)
        regroups = regroups || m_values.at(id)->group != group;
    if (!regroups) {
        m_editor.push(reorder(document, strokes, before), tr("Reorder strokes"));
        return;
    }
    Edit edit;
    edit.order.emplace();
    std::vector<StrokeId> moved;
    for (const StrokePtr &stroke : painting.strokes) {
        if (!strokes.contains(stroke->id))
            continue;
        moved.push_back(stroke->id);
        Stroke copy = *stroke;
        copy.group = group;
        edit.strokes.emplace(stroke->id, std::make_shared<const Stroke>(std::move(copy)));
    }
    for (const StrokePtr &stroke : painting.strokes) {
        if (stroke->id == before)
            edit.order->insert(edit.order->end(), moved.begin(), moved.end());
        if (!strokes.contains(stroke->id))
            edit.order->push_back(stroke->id);
    }
    if (!before)
        edit.order->insert(edit.order->end(), moved.begin(), moved.end());
    m_editor.push(std::move(edit), tr("Reorder strokes"));
}

} // namespace suffuse
