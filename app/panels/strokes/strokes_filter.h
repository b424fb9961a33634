#pragma once

#include "app/panels/strokes/strokes_tree.h"

#include <QAbstractProxyModel>

#include <unordered_set>

namespace suffuse {

class StrokesModel;

/// Shows the strokes and groups whose names contain a text, with all that is in them and around them. Segments have no
/// names of their own. Without a text it passes everything on; where rows come, go or move during a search, it resets.
class StrokesFilter : public QAbstractProxyModel {
    Q_OBJECT

public:
    explicit StrokesFilter(StrokesModel &model, QObject *parent = nullptr);

    /// Sets the text; an empty one shows all rows.
    void setText(const QString &text);
    const QString &text() const { return m_text; }
    /// Whether the search leaves out rows of a group. `group` is an index of this model.
    bool hidesSome(const QModelIndex &group) const;
    /// Whether something in a group matches by its own name. `group` is an index of the source.
    bool holdsMatchWithin(const QModelIndex &group) const;
    /// Whether a row matches by its own name. `index` is an index of the source.
    bool matches(const QModelIndex &index) const;

    QModelIndex mapToSource(const QModelIndex &index) const override;
    QModelIndex mapFromSource(const QModelIndex &index) const override;
    QModelIndex index(int row, int column, const QModelIndex &parent = {}) const override;
    QModelIndex parent(const QModelIndex &child) const override;
    QModelIndex sibling(int row, int column, const QModelIndex &index) const override;
    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    /// The source's answer is right, since a row is always shown with its children, and asking must not cost a look at
    /// each of these.
    bool hasChildren(const QModelIndex &parent = {}) const override;

signals:
    /// Emitted when the rows are still there; views forget at `modelAboutToBeReset` where they stand.
    void aboutToReset();

private:
    using Node = StrokesTree::Node;
    using Rows = std::unordered_map<const Node *, std::vector<int>>;

    /// What a text leaves of the tree.
    struct Found {
        Rows shown;                               ///< the rows below a node of which not all are shown
        std::unordered_set<const Node *> holding; ///< the groups in which something matches by its own name
    };

    void passOn();
    Found find() const;
    void lookAgain();
    void beginReset();
    void endReset();
    const std::vector<int> *shownBelow(const QModelIndex &sourceParent) const;
    const Node *nodeOf(const QModelIndex &source) const;

    StrokesModel &m_model;
    QString m_text;
    Found m_found;
    bool m_resetting = false;
};

} // namespace suffuse
