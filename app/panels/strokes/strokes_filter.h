#pragma once

#include <QSortFilterProxyModel>

namespace suffuse {

/// Strokes and groups whose names hold a text, with all that is in them and around them. Segments have no names of
/// their own.
class StrokesFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setText(const QString &text);
    const QString &text() const { return m_text; }
    /// Whether something in a group matches by its own name; `group` is an index of the source.
    bool holdsMatchWithin(const QModelIndex &group) const;
    /// As the source says: what is shown is shown with its children, and asking each row must cost nothing.
    bool hasChildren(const QModelIndex &parent = {}) const override
    {
        return sourceModel()->hasChildren(mapToSource(parent));
    }

    /// By its own name; an index of the source.
    bool matches(const QModelIndex &index) const;

protected:
    bool filterAcceptsRow(int row, const QModelIndex &parent) const override;

private:
    bool holdsMatch(const QModelIndex &index) const;

    QString m_text;
};

} // namespace suffuse
