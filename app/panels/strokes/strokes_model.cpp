#include "app/panels/strokes/strokes_model.h"

#include "app/panels/strokes/rows/dragged_rows.h"
#include "app/panels/strokes/rows/row_changes.h"
#include "app/panels/strokes/rows/row_data.h"
#include "app/session/commands/selection_commands.h"
#include "app/session/editor.h"
#include "app/session/files/clipboard.h"

#include <QScopedValueRollback>

#include <algorithm>
#include <utility>

namespace suffuse {

QString titleOf(const Stroke &stroke)
{
    return stroke.name.isEmpty() ? StrokesModel::tr("Stroke %1").arg(stroke.id) : stroke.name;
}

namespace {

/// This bit in a row's internal pointer says that the row is a segment of the node's stroke.
constexpr quintptr segmentTag = 1;
const char rowsMime[] = "application/x-suffuse-stroke-rows";

} // namespace

StrokesModel::StrokesModel(Editor &editor, QObject *parent) : QAbstractItemModel(parent), m_editor(editor)
{
    rebuild();
    connect(&editor.laterChanges(), &LaterChanges::changed, this, &StrokesModel::follow);
    connect(&editor.layer(), &CurrentLayer::changed, this, &StrokesModel::announceGroups);
}

const StrokesModel::Node &StrokesModel::nodeAt(const QModelIndex &index) const
{
    return index.isValid() ? *reinterpret_cast<const Node *>(index.internalId() & ~segmentTag) : m_tree.root();
}

int StrokesModel::segmentAt(const QModelIndex &index) const
{
    return index.isValid() && index.internalId() & segmentTag ? index.row() : -1;
}

QModelIndex StrokesModel::indexOf(const SegmentRef &ref) const
{
    return index(ref.segment, NameColumn, indexOf(ref.stroke));
}

StrokePtr StrokesModel::strokeValueAt(const QModelIndex &index) const
{
    return nodeAt(index).value;
}

QModelIndex StrokesModel::indexOf(const Node *node, int column) const
{
    return !node || node == &m_tree.root() ? QModelIndex() : createIndex(node->row, column, const_cast<Node *>(node));
}

QModelIndex StrokesModel::indexLike(const QModelIndex &filtered) const
{
    if (!filtered.isValid())
        return {};
    const bool isSegment = filtered.internalId() & segmentTag;
    const int row = isSegment ? filtered.row() : reinterpret_cast<const Node *>(filtered.internalId())->row;
    return createIndex(row, filtered.column(), filtered.internalId());
}

QModelIndex StrokesModel::indexOf(StrokeId id) const
{
    return indexOf(m_tree.nodeOf(id));
}

StrokeId StrokesModel::strokeAt(const QModelIndex &index) const
{
    return nodeAt(index).stroke;
}

const Group *StrokesModel::groupAt(const QModelIndex &index) const
{
    const Node &node = nodeAt(index);
    return node.group && segmentAt(index) < 0 ? m_tree.groupOf(node.group) : nullptr;
}

std::set<StrokeId> StrokesModel::strokesBelow(const QModelIndex &index) const
{
    return StrokesTree::strokesBelow(nodeAt(index));
}

bool StrokesModel::isWhollySelected(const Node &node) const
{
    if (node.stroke)
        return m_editor.selection().strokes.contains(node.stroke);
    return !node.children.empty() && std::all_of(node.children.begin(), node.children.end(),
                                                 [this](const auto &child) { return isWhollySelected(*child); });
}

QModelIndex StrokesModel::index(int row, int column, const QModelIndex &parent) const
{
    const Node &node = nodeAt(parent);
    if (row < 0 || row >= rowCount(parent) || column < 0 || column >= ColumnCount)
        return {};
    if (node.stroke)
        return createIndex(row, column, reinterpret_cast<quintptr>(&node) | segmentTag);
    return createIndex(row, column, node.children[std::size_t(row)].get());
}

QModelIndex StrokesModel::parent(const QModelIndex &child) const
{
    if (!child.isValid())
        return {};
    const Node &node = nodeAt(child);
    return indexOf(segmentAt(child) < 0 ? node.parent : &node);
}

int StrokesModel::rowCount(const QModelIndex &parent) const
{
    if (parent.column() > 0 || segmentAt(parent) >= 0)
        return 0;
    const Node &node = nodeAt(parent);
    return node.stroke ? node.segments : int(node.children.size());
}

int StrokesModel::columnCount(const QModelIndex &) const
{
    return ColumnCount;
}

QVariant StrokesModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || (role != Qt::ToolTipRole && role != Qt::AccessibleTextRole))
        return {};
    return section == NameColumn ? tr("Name") : section == EyeColumn ? tr("Visible") : tr("Locked");
}

Qt::ItemFlags StrokesModel::flags(const QModelIndex &index) const
{
    if (!index.isValid())
        return Qt::ItemIsDropEnabled;
    if (segmentAt(index) >= 0)
        return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
    Qt::ItemFlags result = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled;
    if (index.column() == NameColumn)
        result |= Qt::ItemIsEditable;
    if (nodeAt(index).group)
        result |= Qt::ItemIsDropEnabled;
    return result;
}

QVariant StrokesModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const Node &node = nodeAt(index);
    if (node.group) {
        const Group *group = m_tree.groupOf(node.group);
        if (role == WhollySelectedRole)
            return isWhollySelected(node);
        const bool isLayer = node.group == m_editor.layer().group();
        if (role == CurrentLayerRole)
            return isLayer;
        if (group && isLayer && index.column() == NameColumn && role == Qt::AccessibleTextRole)
            return tr("%1, painted on").arg(titleOf(*group));
        return group ? groupRowData(*group, marksOf(node.group), index.column(), role) : QVariant();
    }
    const StrokePtr &stroke = node.value;
    if (!stroke)
        return {};
    const int segment = segmentAt(index);
    return segment < 0 ? strokeRowData(*stroke, index.column(), role)
                       : segmentRowData(*stroke, segment, index.column(), role);
}

bool StrokesModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!index.isValid() || segmentAt(index) >= 0 || index.column() != NameColumn || role != Qt::EditRole)
        return false;
    const QScopedValueRollback renaming(m_renaming, true);
    const QString name = value.toString().trimmed();
    const Node &node = nodeAt(index);
    if (node.group)
        changeGroup(
            m_editor, node.group, [&](Group &g) { g.name = name; }, tr("Rename group"));
    else
        changeStroke(
            m_editor, node.stroke, [&](Stroke &s) { s.name = name; }, tr("Rename stroke"));
    return true;
}

void StrokesModel::toggle(const QModelIndex &index, ValueEntry *entry)
{
    if (!index.isValid() || segmentAt(index) >= 0)
        return;
    const Node &node = nodeAt(index);
    const bool eye = index.column() == EyeColumn;
    const auto flip = [eye](auto &item) {
        if (eye)
            item.visible = !item.visible;
        else
            item.locked = !item.locked;
    };
    if (node.group) {
        const Group *group = m_tree.groupOf(node.group);
        const bool own = group && (eye ? group->visible : group->locked);
        const bool on = data(index, SwitchRole).toBool();
        const QString text =
            eye ? (on ? tr("Hide group") : tr("Show group")) : (on ? tr("Unlock group") : tr("Lock group"));
        const auto clear = [eye](auto &item) { (eye ? item.visible : item.locked) = eye; };
        if (own == on)
            changeGroup(m_editor, node.group, flip, text, entry);
        else
            changeWithin(m_editor, node.group, clear, clear, text, entry);
    } else if (const StrokePtr stroke = node.value) {
        const bool on = eye ? stroke->visible : stroke->locked;
        changeStroke(
            m_editor, node.stroke, flip,
            eye ? (on ? tr("Hide stroke") : tr("Show stroke")) : (on ? tr("Unlock stroke") : tr("Lock stroke")), entry);
    }
    if (eye)
        commands::deselectHidden(m_editor);
}

void StrokesModel::rebuild()
{
    beginResetModel();
    m_tree.build(m_editor.document().painting());
    m_marks = suffuse::marksOf(m_tree);
    endResetModel();
}

void StrokesModel::follow(const Change &change)
{
    const QScopedValueRollback following(m_following, true);
    const PaintingPtr painting = m_editor.document().painting();
    if (painting == m_tree.painting() && !change.reset)
        return;
    if (change.reset)
        return rebuild();
    emit aboutToFollow();
    const StrokesTree::Changed changed = m_tree.follow(painting, change, *this);
    announce(changed);
    emit followed();
    if (changed.names)
        emit renamed();
}

void StrokesModel::announce(const StrokesTree::Changed &changed)
{
    // Below each parent the rows from the first to the last that changed are announced at once: views look for each
    // row, and announcing one that did not change costs less.
    std::unordered_map<const Node *, std::pair<const Node *, const Node *>> ends;
    for (const Node *node : changed.strokes) {
        auto &[first, last] = ends.try_emplace(node->parent, node, node).first->second;
        first = node->row < first->row ? node : first;
        last = node->row > last->row ? node : last;
    }
    for (const auto &[parent, rows] : ends)
        emit dataChanged(indexOf(rows.first), indexOf(rows.second, LockColumn));
    for (const Node *node : changed.withSegments) {
        const QModelIndex stroke = indexOf(node);
        if (node->segments > 0)
            emit dataChanged(index(0, NameColumn, stroke), index(node->segments - 1, NameColumn, stroke));
    }
    if (!changed.groups && !changed.switches)
        return;
    const MarksOfGroups before = std::exchange(m_marks, suffuse::marksOf(m_tree));
    if (changed.groups || before != m_marks)
        announceGroups();
}

/// Announces the rows of all groups, for each parent at once.
void StrokesModel::announceGroups()
{
    std::vector<const Node *> open{&m_tree.root()};
    while (!open.empty()) {
        const Node *parent = open.back();
        open.pop_back();
        const Node *first = nullptr, *last = nullptr;
        for (const auto &child : parent->children) {
            if (!child->group)
                continue;
            open.push_back(child.get());
            first = first ? first : child.get();
            last = child.get();
        }
        if (first)
            emit dataChanged(indexOf(first), indexOf(last, LockColumn));
    }
}

GroupMarks StrokesModel::marksOf(GroupId group) const
{
    const auto it = m_marks.find(group);
    return it == m_marks.end() ? GroupMarks() : it->second;
}

void StrokesModel::rowsCome(const Node &parent, int first, int last)
{
    beginInsertRows(indexOf(&parent), first, last);
}

void StrokesModel::rowsGo(const Node &parent, int first, int last)
{
    beginRemoveRows(indexOf(&parent), first, last);
}

void StrokesModel::rowsMove(const Node &parent, int first, int last, int to)
{
    const QModelIndex rows = indexOf(&parent);
    beginMoveRows(rows, first, last, rows, to);
}

void StrokesModel::rowsSort(const Node &parent)
{
    emit layoutAboutToBeChanged({QPersistentModelIndex(indexOf(&parent))});
}

void StrokesModel::rowsSorted(const Node &parent)
{
    const QModelIndexList before = persistentIndexList();
    QModelIndexList after;
    for (const QModelIndex &old : before)
        after << (segmentAt(old) < 0 ? indexOf(&nodeAt(old), old.column()) : old); // Segments stay in their stroke.
    changePersistentIndexList(before, after);
    emit layoutChanged({QPersistentModelIndex(indexOf(&parent))});
}

QStringList StrokesModel::mimeTypes() const
{
    return {rowsMime};
}

DraggedRows StrokesModel::draggedOf(const QModelIndexList &indexes) const
{
    DraggedRows rows;
    for (const QModelIndex &index : indexes) {
        if (index.column() != NameColumn || segmentAt(index) >= 0)
            continue;
        rows.strokes.merge(strokesBelow(index));
        if (const GroupId group = nodeAt(index).group)
            rows.groups.insert(group);
    }
    return rows;
}

QMimeData *StrokesModel::mimeData(const QModelIndexList &indexes) const
{
    const DraggedRows rows = draggedOf(indexes);
    // Other windows take the strokes themselves.
    QMimeData *data = clipboard::mimeOf(clipboard::asPainting(*m_tree.painting(), {rows.strokes, {}}),
                                        m_editor.clock().time(), std::as_const(m_editor).extras().resolution);
    data->setData(rowsMime, rows.toBytes(this));
    return data;
}

bool StrokesModel::canDropMimeData(const QMimeData *data, Qt::DropAction action, int, int, const QModelIndex &) const
{
    return data && action == Qt::MoveAction && data->hasFormat(rowsMime);
}

bool StrokesModel::dropMimeData(const QMimeData *data, Qt::DropAction action, int row, int, const QModelIndex &parent)
{
    if (!canDropMimeData(data, action, 0, 0, parent) || segmentAt(parent) >= 0)
        return false;
    const std::optional<DraggedRows> dragged = DraggedRows::fromBytes(data->data(rowsMime), this);
    if (dragged)
        put(dragged->movable(m_tree), parent, row);
    // The document has moved the rows already, so the view has nothing to remove.
    return false;
}

bool StrokesModel::move(const QModelIndexList &rows, const QModelIndex &parent, int row, ValueEntry *entry)
{
    return put(draggedOf(rows).movable(m_tree), parent, row, entry);
}

bool StrokesModel::put(const DraggedRows &rows, const QModelIndex &parent, int row, ValueEntry *entry)
{
    if (rows.strokes.empty())
        return false;
    const DropPlace place = dropPlace(nodeAt(parent), row, rows.strokes);
    std::optional<Edit> edit = dropEdit(m_tree, *m_editor.document().painting(), rows, place);
    if (!edit)
        return false;
    m_editor.push(std::move(*edit), tr("Reorder strokes"), entry);
    if (place.group != 0)
        emit droppedInto(place.group);
    return true;
}

} // namespace suffuse
