#pragma once

#include "app/panels/strokes/group_marks.h"
#include "app/session/current_layer.h"

#include <QAbstractItemModel>

namespace suffuse {

class Editor;
struct DraggedRows;
class ValueEntry;

/// The name that people see. A stroke without a name has what it is and its number.
QString titleOf(const Stroke &stroke);

/// Shows groups, strokes and their segments as a tree, the topmost first. It compares the document with the state
/// before: a change of values touches only rows that changed, what is new, gone or in another group is inserted and
/// removed in runs, and only another painting resets the model. Edits go through the editor, and each is an
/// undo step.
class StrokesModel : public QAbstractItemModel, private StrokesTree::Listener {
    Q_OBJECT

public:
    enum Column { NameColumn, EyeColumn, LockColumn, ColumnCount };
    enum Role {
        StrokeIdRole = Qt::UserRole, ///< StrokeId; 0 for groups
        GroupIdRole,                 ///< GroupId; 0 for strokes
        ColourRole,                  ///< QColor of a stroke
        UnnamedRole,                 ///< bool
        SwitchRole,                  ///< bool of an eye (visible) or lock (locked); for a group also what is in it
        PartRole,                    ///< bool of a group's eye or lock: some strokes in it are hidden, or locked
        SegmentRole,                 ///< int: the index of a segment in its stroke; -1 for other rows
        MakeUpRole, ///< QString: "3 pieces, 12 erasures" of a stroke, "Multiply · 60 %" of a group; empty where
                    ///< there is nothing unusual
        WhollySelectedRole, ///< bool: whether all strokes of a group are selected
        CurrentLayerRole    ///< bool: whether what is painted goes into the group
    };

    explicit StrokesModel(Editor &editor, QObject *parent = nullptr);

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

    /// The row of a stroke; invalid where there is no such stroke.
    QModelIndex indexOf(StrokeId id) const;
    /// The row of a segment; invalid where there is none.
    QModelIndex indexOf(const SegmentRef &ref) const;
    /// The index of a segment's row in its stroke; -1 for other rows.
    int segmentAt(const QModelIndex &index) const;
    /// The stroke of a row, also of a segment's row; null for groups.
    StrokePtr strokeValueAt(const QModelIndex &index) const;
    /// The id of that stroke; 0 for groups.
    StrokeId strokeAt(const QModelIndex &index) const;
    /// The group of a row; null for others.
    const Group *groupAt(const QModelIndex &index) const;
    /// The strokes that belong to a row: the stroke itself, or all in the group.
    std::set<StrokeId> strokesBelow(const QModelIndex &index) const;

    /// The tree that the rows show.
    const StrokesTree &tree() const { return m_tree; }
    /// The row of a node of that tree; invalid for its root.
    QModelIndex indexOf(const StrokesTree::Node *node, int column = 0) const;
    /// The index of a filter's index, which has the same internal id and stands in another row.
    QModelIndex indexLike(const QModelIndex &filtered) const;

    /// True while rows change because the document has changed. What views deselect then was not deselected by a
    /// person.
    bool isFollowing() const { return m_following; }

    /// True while a row is renamed by the one who typed its name.
    bool isRenaming() const { return m_renaming; }

    /// Shows or hides, or locks or unlocks, what the row stands for. The column of the index says which. What one entry
    /// switches in a row is one step.
    void toggle(const QModelIndex &index, ValueEntry *entry = nullptr);

    /// Puts rows above the row `row` of a group, or of none where `parent` is invalid. Locked strokes stay. Returns
    /// whether anything changes by that.
    bool move(const QModelIndexList &rows, const QModelIndex &parent, int row, ValueEntry *entry = nullptr);

signals:
    /// Emitted around all that changes when the rows follow the painting.
    void aboutToFollow();
    void followed();
    /// A row has another name.
    void renamed();
    /// Rows were dragged into a group.
    void droppedInto(GroupId group);

private:
    DraggedRows draggedOf(const QModelIndexList &rows) const;
    bool put(const DraggedRows &rows, const QModelIndex &parent, int row, ValueEntry *entry = nullptr);
    using Node = StrokesTree::Node;

    // These are called by the tree (StrokesTree::Listener).
    void rowsCome(const Node &parent, int first, int last) override;
    void rowsCame() override { endInsertRows(); }
    void rowsGo(const Node &parent, int first, int last) override;
    void rowsWent() override { endRemoveRows(); }
    void rowsMove(const Node &parent, int first, int last, int to) override;
    void rowsMoved() override { endMoveRows(); }
    void rowsSort(const Node &parent) override;
    void rowsSorted(const Node &parent) override;

    /// The node of a row; for a segment's row it is that of its stroke.
    const Node &nodeAt(const QModelIndex &index) const;
    bool isWhollySelected(const Node &node) const;
    void rebuild();
    void follow(const Change &change);
    void announce(const StrokesTree::Changed &changed);
    void announceGroups();
    GroupMarks marksOf(GroupId group) const;

    Editor &m_editor;
    StrokesTree m_tree;
    MarksOfGroups m_marks; ///< of the painting that the tree shows
    bool m_following = false;
    bool m_renaming = false;
};

} // namespace suffuse
