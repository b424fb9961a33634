#pragma once

#include <QSortFilterProxyModel>

namespace suffuse {

/// Shows the strokes and groups whose names contain a text, with all that is in them and around them. Segments have no
/// names of their own.
class StrokesFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setSourceModel(QAbstractItemModel *source) override;
    /// Sets the text; an empty one shows all rows.
    void setText(const QString &text);
    const QString &text() const { return m_text; }
    /// Whether the search leaves out rows of a group. `group` is an index of this model.
    bool hidesSome(const QModelIndex &group) const
    {
        return rowCount(group) < sourceModel()->rowCount(mapToSource(group));
    }
    /// Whether something in a group matches by its own name. `group` is an index of the source.
    bool holdsMatchWithin(const QModelIndex &group) const;
    /// The source's answer is right, since a row is always shown with its children, and asking must not cost a look at
    /// each of these.
    bool hasChildren(const QModelIndex &parent = {}) const override
    {
        return sourceModel()->hasChildren(mapToSource(parent));
    }

    /// Whether a row matches by its own name. `index` is an index of the source.
    bool matches(const QModelIndex &index) const;

protected:
    bool filterAcceptsRow(int row, const QModelIndex &parent) const override;

private:
    bool holdsMatch(const QModelIndex &index) const;
    void follow(const QModelIndex &changed);

    QString m_text;
    bool m_isToLookAgain = false;
};

} // namespace suffuse
