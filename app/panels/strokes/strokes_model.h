#pragma once

#include "app/panels/strokes/strokes_tree.h"

#include <QAbstractItemModel>

namespace suffuse {

class Editor;

/// The name that people see: of a stroke or group without one, what it is and its number.
QString titleOf(const Stroke &stroke);
QString titleOf(const Group &group);

/// Groups, strokes and their segments as a tree, the topmost first. Follows the document by difference: a change of
/// values touches the rows that changed, strokes that come or go are inserted or removed in runs, and only another
/// grouping or painting resets it. Edits go through the editor, one undo step each.
class StrokesModel : public QAbstractItemModel, private StrokesTree::Listener {
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
    using Node = StrokesTree::Node;

    // StrokesTree::Listener
    void rowsCome(const Node &parent, int first, int last) override;
    void rowsCame() override { endInsertRows(); }
    void rowsGo(const Node &parent, int first, int last) override;
    void rowsWent() override { endRemoveRows(); }
    void rowsMove(const Node &parent) override;
    void rowsMoved(const Node &parent) override;

    /// Of a segment's row: its stroke's node.
    const Node &nodeAt(const QModelIndex &index) const;
    QModelIndex indexOf(const Node *node, int column = 0) const;
    bool isWhollySelected(const Node &node) const;
    void rebuild();
    void follow(const Change &change);
    void announce(const StrokesTree::Changed &changed);

    Editor &m_editor;
    StrokesTree m_tree;
    bool m_following = false;
};

} // namespace suffuse
