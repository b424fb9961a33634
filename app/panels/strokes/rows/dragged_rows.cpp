#include "app/panels/strokes/rows/dragged_rows.h"

#include <QDataStream>
#include <QIODevice>

#include <unordered_set>

namespace suffuse {

namespace {

quint64 numberOf(const void *source)
{
    return quint64(reinterpret_cast<quintptr>(source));
}

/// The order of all strokes when some are put in their new place.
std::vector<StrokeId> orderWith(const Painting &painting, const std::set<StrokeId> &some, StrokeId before)
{
    const std::unordered_set<StrokeId> strokes(some.begin(), some.end()); // All others are looked for in it.
    std::vector<StrokeId> order, moved;
    order.reserve(painting.strokes.size());
    std::optional<std::size_t> place;
    for (const StrokePtr &stroke : painting.strokes) {
        if (stroke->id == before)
            place = order.size();
        (strokes.contains(stroke->id) ? moved : order).push_back(stroke->id);
    }
    order.insert(order.begin() + std::ptrdiff_t(place.value_or(order.size())), moved.begin(), moved.end());
    return order;
}

} // namespace

QByteArray DraggedRows::toBytes(const void *source) const
{
    QByteArray bytes;
    QDataStream out(&bytes, QIODevice::WriteOnly);
    out << numberOf(source) << quint64(groups.size());
    for (const GroupId id : groups)
        out << quint64(id);
    for (const StrokeId id : strokes)
        out << quint64(id);
    return bytes;
}

std::optional<DraggedRows> DraggedRows::fromBytes(const QByteArray &bytes, const void *source)
{
    QDataStream in(bytes);
    quint64 from = 0, count = 0;
    in >> from >> count;
    if (from != numberOf(source))
        return {};
    DraggedRows rows;
    for (quint64 id = 0; !in.atEnd();) {
        in >> id;
        if (count > 0)
            --count, rows.groups.insert(id);
        else
            rows.strokes.insert(id);
    }
    return rows;
}

DraggedRows DraggedRows::movable(const StrokesTree &tree) const
{
    DraggedRows result{{}, groups};
    for (const StrokeId id : strokes)
        if (const StrokePtr stroke = tree.strokeOf(id);
            stroke && (!stroke->locked || tree.isWithin(stroke->group, groups)))
            result.strokes.insert(id);
    return result;
}

namespace {

/// The lowest stroke of a node, in the order of painting, that stays where it is; 0: none.
StrokeId lowestStaying(const StrokesTree::Node &node, const std::set<StrokeId> &moved)
{
    if (node.stroke)
        return moved.contains(node.stroke) ? 0 : node.stroke;
    for (auto it = node.children.rbegin(); it != node.children.rend(); ++it)
        if (const StrokeId id = lowestStaying(**it, moved))
            return id;
    return 0;
}

} // namespace

DropPlace dropPlace(const StrokesTree::Node &onto, int row, const std::set<StrokeId> &moved)
{
    const StrokesTree::Node *target = &onto;
    if (target->stroke) { // What is dropped onto a stroke goes just above it.
        row = target->row;
        target = target->parent;
    }
    if (row < 0)
        row = target->group ? 0 : int(target->children.size());
    // The rows go below the next row above them that stays where it is. On top of a group, they go below what stands
    // above the group.
    StrokeId before = 0;
    const StrokesTree::Node *at = target;
    for (int above = row - 1; at && !before;) {
        for (; above >= 0 && !before; --above)
            before = lowestStaying(*at->children[std::size_t(above)], moved);
        above = at->row - 1;
        at = at->parent;
    }
    return {target->group, before};
}

std::optional<Edit> dropEdit(const StrokesTree &tree, const Painting &painting, const DraggedRows &rows,
                             const DropPlace &place)
{
    if (tree.isWithin(place.group, rows.groups))
        return {};
    Edit edit;
    for (const StrokeId id : rows.strokes) {
        const StrokePtr stroke = tree.strokeOf(id);
        if (stroke->group == place.group || tree.isWithin(stroke->group, rows.groups))
            continue;
        Stroke copy = *stroke;
        copy.group = place.group;
        edit.strokes.emplace(id, std::make_shared<const Stroke>(std::move(copy)));
    }
    std::vector<Group> groups = painting.groups;
    for (Group &group : groups)
        if (rows.groups.contains(group.id) && !tree.isWithin(group.parent, rows.groups))
            group.parent = place.group;
    if (groups != painting.groups)
        edit.groups = std::move(groups);
    edit.order = orderWith(painting, rows.strokes, place.before);
    return edit;
}

} // namespace suffuse
