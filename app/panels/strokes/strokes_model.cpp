#include "app/panels/strokes/strokes_model.h"

#include "app/session/colour_convert.h"
#include "app/session/editor.h"
#include "app/widgets/icons.h"

#include <algorithm>
#include <unordered_set>

namespace suffuse {

StrokesModel::StrokesModel(Editor &editor, QObject *parent)
    : QAbstractItemModel(parent), m_editor(editor), m_root(std::make_unique<Node>())
{
    rebuild();
    connect(&editor.laterChanges(), &LaterChanges::changed, this, &StrokesModel::documentChanged);
}

StrokesModel::~StrokesModel() = default;

namespace {
/// In a row's internal pointer: it stands for a segment of the node's stroke.
constexpr quintptr segmentTag = 1;
} // namespace

StrokesModel::Node *StrokesModel::nodeAt(const QModelIndex &index) const
{
    return index.isValid() ? reinterpret_cast<Node *>(index.internalId() & ~segmentTag) : m_root.get();
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
    const auto it = m_values.find(strokeAt(index));
    return it == m_values.end() ? nullptr : it->second;
}

QModelIndex StrokesModel::indexOf(const Node *node, int column) const
{
    return !node || node == m_root.get() ? QModelIndex() : createIndex(node->row, column, const_cast<Node *>(node));
}

QModelIndex StrokesModel::indexOf(StrokeId id) const
{
    const auto it = m_nodes.find(id);
    return it == m_nodes.end() ? QModelIndex() : indexOf(it->second);
}

StrokeId StrokesModel::strokeAt(const QModelIndex &index) const
{
    return index.isValid() ? nodeAt(index)->stroke : 0;
}

std::set<StrokeId> StrokesModel::strokesBelow(const QModelIndex &index) const
{
    std::set<StrokeId> result;
    std::vector<const Node *> open{nodeAt(index)};
    while (!open.empty()) {
        const Node *node = open.back();
        open.pop_back();
        if (node->stroke)
            result.insert(node->stroke);
        for (const auto &child : node->children)
            open.push_back(child.get());
    }
    return result;
}

bool StrokesModel::isWhollySelected(const Node &node) const
{
    if (node.stroke)
        return m_editor.document().selection().strokes.contains(node.stroke);
    return !node.children.empty() && std::all_of(node.children.begin(), node.children.end(),
                                                 [this](const auto &child) { return isWhollySelected(*child); });
}

QModelIndex StrokesModel::index(int row, int column, const QModelIndex &parent) const
{
    const Node *node = nodeAt(parent);
    if (row < 0 || row >= rowCount(parent) || column < 0 || column >= ColumnCount)
        return {};
    if (node->stroke)
        return createIndex(row, column, reinterpret_cast<quintptr>(node) | segmentTag);
    return createIndex(row, column, node->children[std::size_t(row)].get());
}

QModelIndex StrokesModel::parent(const QModelIndex &child) const
{
    if (!child.isValid())
        return {};
    const Node *node = nodeAt(child);
    return indexOf(segmentAt(child) < 0 ? node->parent : node);
}

int StrokesModel::rowCount(const QModelIndex &parent) const
{
    if (parent.column() > 0 || segmentAt(parent) >= 0)
        return 0;
    const Node *node = nodeAt(parent);
    return node->stroke ? node->segments : int(node->children.size());
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
    if (nodeAt(index)->group)
        result |= Qt::ItemIsDropEnabled;
    return result;
}

const Group *StrokesModel::groupOf(GroupId id) const
{
    const auto it = std::find_if(m_groups.begin(), m_groups.end(), [id](const Group &g) { return g.id == id; });
    return it == m_groups.end() ? nullptr : &*it;
}

QVariant StrokesModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const Node *node = nodeAt(index);
    if (node->group) {
        const Group *group = groupOf(node->group);
        if (role == WhollySelectedRole)
            return isWhollySelected(*node);
        return group ? groupData(*group, index.column(), role) : QVariant();
    }
    const auto it = m_values.find(node->stroke);
    if (it == m_values.end())
        return {};
    const int segment = segmentAt(index);
    return segment < 0 ? strokeData(*it->second, index.column(), role)
                       : segmentData(*it->second, segment, index.column(), role);
}

QVariant StrokesModel::segmentData(const Stroke &stroke, int segment, int column, int role) const
{
    if (role == StrokeIdRole)
        return QVariant::fromValue<qulonglong>(stroke.id);
    if (role == GroupIdRole)
        return QVariant::fromValue<qulonglong>(0);
    if (role == SegmentRole)
        return segment;
    if (column != NameColumn || std::size_t(segment) >= stroke.segments.size())
        return {};
    if (role == Qt::DisplayRole)
        return tr("Segment %1").arg(segment + 1);
    if (role == ColourRole)
        return toOpaqueScreen(stroke.segments[std::size_t(segment)].colour);
    return {};
}

namespace {

QVariant switchData(bool visible, bool locked, int column, int role)
{
    if (role == StrokesModel::SwitchRole)
        return column == StrokesModel::EyeColumn ? visible : locked;
    if (column == StrokesModel::EyeColumn) {
        if (role == Qt::DecorationRole)
            return icon(visible ? "eye" : "eye-off");
        if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole)
            return visible ? StrokesModel::tr("Visible. Click: hide.") : StrokesModel::tr("Hidden. Click: show.");
    } else if (column == StrokesModel::LockColumn) {
        if (role == Qt::DecorationRole)
            return icon(locked ? "lock" : "unlock");
        if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole)
            return locked ? StrokesModel::tr("Locked. Click: unlock.") : StrokesModel::tr("Not locked. Click: lock.");
    }
    return {};
}

} // namespace

QString titleOf(const Stroke &stroke)
{
    return stroke.name.isEmpty() ? StrokesModel::tr("Stroke %1").arg(stroke.id) : stroke.name;
}

QString titleOf(const Group &group)
{
    return group.name.isEmpty() ? StrokesModel::tr("Group %1").arg(group.id) : group.name;
}

QVariant StrokesModel::strokeData(const Stroke &stroke, int column, int role) const
{
    if (role == SegmentRole)
        return -1;
    if (role == StrokeIdRole)
        return QVariant::fromValue<qulonglong>(stroke.id);
    if (role == GroupIdRole)
        return QVariant::fromValue<qulonglong>(0);
    if (column != NameColumn)
        return switchData(stroke.visible, stroke.locked, column, role);
    switch (role) {
    case Qt::DisplayRole:
        return titleOf(stroke);
    case Qt::EditRole:
        return stroke.name;
    case Qt::ToolTipRole:
        return tr("%n segment(s)", nullptr, int(stroke.segments.size()));
    case ColourRole:
        return stroke.segments.empty() ? QVariant()
                                       : toOpaqueScreen(stroke.segments[stroke.segments.size() / 2].colour);
    case UnnamedRole:
        return stroke.name.isEmpty();
    default:
        return {};
    }
}

QVariant StrokesModel::groupData(const Group &group, int column, int role) const
{
    if (role == SegmentRole)
        return -1;
    if (role == StrokeIdRole)
        return QVariant::fromValue<qulonglong>(0);
    if (role == GroupIdRole)
        return QVariant::fromValue<qulonglong>(group.id);
    if (column != NameColumn)
        return switchData(group.visible, group.locked, column, role);
    switch (role) {
    case Qt::DisplayRole:
        return titleOf(group);
    case Qt::EditRole:
        return group.name;
    case Qt::DecorationRole:
        return icon("group");
    case UnnamedRole:
        return group.name.isEmpty();
    default:
        return {};
    }
}

bool StrokesModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!index.isValid() || segmentAt(index) >= 0 || index.column() != NameColumn || role != Qt::EditRole)
        return false;
    const QString name = value.toString().trimmed();
    const Node *node = nodeAt(index);
    if (node->group)
        changeGroup(
            node->group, [&](Group &g) { g.name = name; }, tr("Rename group"));
    else
        changeStroke(
            node->stroke, [&](Stroke &s) { s.name = name; }, tr("Rename stroke"));
    return true;
}

void StrokesModel::toggle(const QModelIndex &index)
{
    if (!index.isValid() || segmentAt(index) >= 0)
        return;
    const Node *node = nodeAt(index);
    const bool eye = index.column() == EyeColumn;
    const auto flip = [eye](auto &item) {
        if (eye)
            item.visible = !item.visible;
        else
            item.locked = !item.locked;
    };
    if (node->group) {
        const Group *group = groupOf(node->group);
        const bool on = group && (eye ? group->visible : group->locked);
        changeGroup(node->group, flip,
                    eye ? (on ? tr("Hide group") : tr("Show group")) : (on ? tr("Unlock group") : tr("Lock group")));
    } else if (const auto it = m_values.find(node->stroke); it != m_values.end()) {
        const bool on = eye ? it->second->visible : it->second->locked;
        changeStroke(node->stroke, flip,
                     eye ? (on ? tr("Hide stroke") : tr("Show stroke"))
                         : (on ? tr("Unlock stroke") : tr("Lock stroke")));
    }
}

void StrokesModel::changeStroke(StrokeId id, const std::function<void(Stroke &)> &change, const QString &text)
{
    // Names, eyes and locks of locked strokes change too: `changeStrokes` would leave them alone.
    const StrokePtr old = m_editor.document().painting()->find(id);
    if (!old)
        return;
    Stroke stroke = *old;
    change(stroke);
    if (stroke == *old)
        return;
    Edit edit;
    edit.strokes.emplace(id, std::make_shared<const Stroke>(std::move(stroke)));
    m_editor.push(std::move(edit), text);
}

void StrokesModel::changeGroup(GroupId id, const std::function<void(Group &)> &change, const QString &text)
{
    std::vector<Group> groups = m_editor.document().painting()->groups;
    for (Group &group : groups)
        if (group.id == id)
            change(group);
    if (groups == m_editor.document().painting()->groups)
        return;
    Edit edit;
    edit.groups = std::move(groups);
    m_editor.push(std::move(edit), text);
}

} // namespace suffuse
