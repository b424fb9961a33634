#pragma once

#include "app/panels/strokes/strokes_tree.h"

#include <QObject>

#include <functional>

class QTreeView;

namespace suffuse {

class StrokesFilter;
class StrokesModel;

/// Keeps groups open, the frame on its row, and the view in its place, where rows are made anew: in a search, with
/// another painting, or since they go into another group.
class KeptRows : public QObject {
public:
    KeptRows(QTreeView &view, const StrokesModel &model, StrokesFilter &filter);

    /// Searches for a text. Groups are opened where something in them was found; after the search they are open as they
    /// were before it.
    void search(const QString &text);
    /// Opens a group and those around it.
    void open(GroupId group);
    /// The groups that are open, in a search those that were before it.
    std::set<GroupId> openGroups() const;
    /// Opens these groups and closes the others, in a search after it.
    void openOnly(const std::set<GroupId> &groups);

private:
    using Node = StrokesTree::Node;

    /// A row by what it shows.
    struct Row {
        StrokeId stroke = 0;
        GroupId group = 0;
        bool isRow() const { return stroke != 0 || group != 0; }
        friend bool operator==(const Row &, const Row &) = default;
    };

    void noteAll();
    void restoreAll();
    void noteGoing(const QModelIndex &parent, int first, int last);
    void restoreComing(const QModelIndex &parent, int first, int last);
    void visitGroups(const Node &node, const std::function<void(const Node &)> &visit) const;
    QModelIndex viewIndexOf(const Node *node) const;
    QModelIndex viewIndexOf(const Row &row) const;
    static Row rowOf(const QModelIndex &index);
    void noteOpen(const Node &below);
    void expand(const std::set<GroupId> &groups, const Node &below);

    QTreeView &m_view;
    const StrokesModel &m_model;
    StrokesFilter &m_filter;
    std::set<GroupId> m_open;         ///< those of the groups that have gone that were open
    std::set<GroupId> m_beforeSearch; ///< the groups that were open before the search
    std::vector<Row> m_current;       ///< the row with the frame, else those near it
    Row m_moving;                     ///< the row with the frame, while the rows follow the painting
    int m_scrolledTo = 0;
};

} // namespace suffuse
