#pragma once

#include "model/document/document.h"

#include <QAbstractItemModel>

#include <functional>
#include <memory>
#include <unordered_map>

namespace suffuse {

class Editor;

/// The name that people see: of a stroke or group without one, what it is and its number.
QString titleOf(const Stroke &stroke);
QString titleOf(const Group &group);

/// Groups, strokes and their segments as a tree, the topmost first. Follows the document by difference: a change of
/// values touches the rows that changed, strokes that come or go are inserted or removed in runs, and only another
/// grouping or painting resets it. Edits go through the editor, one undo step each.
class StrokesModel : public QAbstractItemModel {
    Q_OBJECT

public:
    enum Column { NameColumn, EyeColumn, LockColumn, ColumnCount };
    enum Role {
        StrokeIdRole = Qt::UserRole, ///< StrokeId, 0 for groups
        GroupIdRole,                 ///< GroupId, 0 for strokes
        ColourRole,                  ///< QColor of a stroke
        UnnamedRole,                 ///< bool
        SwitchRole,                  ///< bool of an eye (visible) or lock (locked)
        SegmentRole,                 ///< int: index of a segment in its stroke, -1 for other rows
        WhollySelectedRole           ///< bool of a group: all strokes in it are selected
    };

    explicit StrokesModel(Editor &editor, QObject *parent = nullptr);
    ~StrokesModel() override;

    QModelIndex index(int row, int column, const QModelIndex &parent = {}) const override;
    QModelIndex parent(const QModelIndex &child) const override;
    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;

    Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    Qt::DropActions supportedDragActions() const override { return Qt::MoveAction | Qt::CopyAction; }
    QStringList mimeTypes() const override;
    QMimeData *mimeData(const QModelIndexList &indexes) const override;
    bool canDropMimeData(const QMimeData *data, Qt::DropAction action, int row, int column,
                         const QModelIndex &parent) const override;
    bool dropMimeData(const QMimeData *data, Qt::DropAction action, int row, int column,
                      const QModelIndex &parent) override;

    bool hasChildren(const QModelIndex &parent = {}) const override { return rowCount(parent) > 0; }

    /// Invalid where there is no such stroke.
    QModelIndex indexOf(StrokeId id) const;
    QModelIndex indexOf(const SegmentRef &ref) const;
    /// Index of a segment in its stroke, -1 for other rows.
    int segmentAt(const QModelIndex &index) const;
    /// Of a stroke's row or a segment's in it; null for groups.
    StrokePtr strokeValueAt(const QModelIndex &index) const;
    /// Of a segment: its stroke. 0 for groups.
    StrokeId strokeAt(const QModelIndex &index) const;
    /// Strokes of a row: itself, or all in the group.
    std::set<StrokeId> strokesBelow(const QModelIndex &index) const;

    /// True while rows change because the document did: what views then deselect was not deselected by a person.
    bool isFollowing() const { return m_following; }

    /// Shows or hides, locks or unlocks what the row stands for.
    void toggle(const QModelIndex &index);

private:
    struct Node {
        StrokeId stroke = 0;
        GroupId group = 0;
        Node *parent = nullptr;
        int row = 0;
        int segments = 0; ///< rows below a stroke
        std::vector<std::unique_ptr<Node>> children;
    };
    /// What stands under each parent, top to bottom: strokes as themselves, groups marked.
    struct Entry {
        StrokeId stroke = 0;
        GroupId group = 0;
        friend bool operator==(const Entry &, const Entry &) = default;
    };
    using Layout = std::unordered_map<GroupId, std::vector<Entry>>;

    /// Of a segment's row: its stroke's node.
    Node *nodeAt(const QModelIndex &index) const;
    QVariant segmentData(const Stroke &stroke, int segment, int column, int role) const;
    /// Rows whose values changed, and those of whose segments that did.
    void announce(const std::vector<const Node *> &strokes, const std::vector<const Node *> &withSegments);
    void followSegments(Node &node, const Stroke &stroke);
    QModelIndex indexOf(const Node *node, int column = 0) const;
    static Layout layoutOf(const Painting &painting);
    void rebuild();
    void buildBelow(Node &node, const Layout &layout);
    void documentChanged(const Change &change);
    void follow(const Painting &painting);
    void followBelow(Node &node, const std::vector<Entry> &wanted);
    void removeMissing(Node &node, const std::vector<Entry> &wanted);
    void insertNew(Node &node, const std::vector<Entry> &wanted);
    void sortLike(Node &node, const std::vector<Entry> &wanted);
    static void renumber(Node &node);
    const Group *groupOf(GroupId id) const;
    bool isWhollySelected(const Node &node) const;
    QVariant strokeData(const Stroke &stroke, int column, int role) const;
    QVariant groupData(const Group &group, int column, int role) const;
    void changeStroke(StrokeId id, const std::function<void(Stroke &)> &change, const QString &text);
    void changeGroup(GroupId id, const std::function<void(Group &)> &change, const QString &text);
    StrokeId lowestStrokeOf(const Node &node) const;
    /// Groups move with what is in them; single strokes join the group.
    void moveInto(const std::set<StrokeId> &strokes, const std::set<GroupId> &groups, StrokeId before, GroupId group);
    bool isWithin(GroupId group, const std::set<GroupId> &groups) const;

    Editor &m_editor;
    PaintingPtr m_painting; ///< what the rows show
    std::vector<Group> m_groups;
    std::unordered_map<StrokeId, StrokePtr> m_values;
    std::unordered_map<StrokeId, Node *> m_nodes;
    std::unique_ptr<Node> m_root;
    bool m_following = false;
};

} // namespace suffuse
