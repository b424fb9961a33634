// How rows are dragged: within the list, and to other windows.
#include "app/panels/strokes/strokes_model.h"
#include "app/session/editor.h"
#include "app/session/files/clipboard.h"

#include <QDataStream>
#include <QIODevice>

#include <algorithm>

namespace suffuse {

namespace {
const char rowsMime[] = "application/x-suffuse-stroke-rows";
} // namespace

QStringList StrokesModel::mimeTypes() const
{
    return {rowsMime};
}

QMimeData *StrokesModel::mimeData(const QModelIndexList &indexes) const
{
    std::set<StrokeId> strokes;
    std::set<GroupId> groups;
    for (const QModelIndex &index : indexes) {
        if (index.column() != NameColumn || segmentAt(index) >= 0)
            continue;
        strokes.merge(strokesBelow(index));
        if (const GroupId group = nodeAt(index)->group)
            groups.insert(group);
    }
    QByteArray bytes;
    QDataStream out(&bytes, QIODevice::WriteOnly);
    out << quint64(reinterpret_cast<quintptr>(this)) << quint64(groups.size());
    for (const GroupId id : groups)
        out << quint64(id);
    for (const StrokeId id : strokes)
        out << quint64(id);
    // Other windows take the strokes themselves.
    QMimeData *data = clipboard::mimeOf(clipboard::asPainting(*m_painting, {strokes, {}}), m_editor.clock().time());
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
    quint64 count = 0;
    in >> count;
    std::set<StrokeId> moved;
    std::set<GroupId> groups;
    for (quint64 id = 0; !in.atEnd();) {
        in >> id;
        const auto it = m_values.find(id);
        if (count > 0)
            --count, groups.insert(id);
        else if (it != m_values.end() && (!it->second->locked || isWithin(it->second->group, groups)))
            moved.insert(id);
    }
    if (moved.empty() || segmentAt(parent) >= 0)
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
    if (isWithin(target->group, groups))
        return false; // a group into itself
    moveInto(moved, groups, before, target->group);
    // The rows have moved already, with the document: the view has nothing to remove.
    return false;
}

bool StrokesModel::isWithin(GroupId group, const std::set<GroupId> &groups) const
{
    for (const Group *at = groupOf(group); at; at = groupOf(at->parent))
        if (groups.contains(at->id))
            return true;
    return false;
}

void StrokesModel::moveInto(const std::set<StrokeId> &strokes, const std::set<GroupId> &groups, StrokeId before,
                            GroupId group)
{
    const Document &document = m_editor.document();
    const Painting &painting = *document.painting();
    Edit edit;
    for (const StrokeId id : strokes) {
        const Stroke &stroke = *m_values.at(id);
        if (stroke.group == group || isWithin(stroke.group, groups))
            continue;
        Stroke copy = stroke;
        copy.group = group;
        edit.strokes.emplace(id, std::make_shared<const Stroke>(std::move(copy)));
    }
    std::vector<Group> tree = painting.groups;
    for (Group &g : tree)
        if (groups.contains(g.id) && !isWithin(g.parent, groups))
            g.parent = group;
    if (tree != painting.groups)
        edit.groups = std::move(tree);
    edit.order.emplace();
    std::vector<StrokeId> moved;
    for (const StrokePtr &stroke : painting.strokes)
        if (strokes.contains(stroke->id))
            moved.push_back(stroke->id);
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
