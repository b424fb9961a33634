#include "app/panels/strokes/strokes_filter.h"

#include "app/panels/strokes/strokes_model.h"

namespace suffuse {

void StrokesFilter::setSourceModel(QAbstractItemModel *source)
{
    QSortFilterProxyModel::setSourceModel(source);
    connect(source, &QAbstractItemModel::dataChanged, this, [this](const QModelIndex &first) { follow(first); });
}

/// A row that is renamed decides about the groups around it, too, of which the base class does not think.
void StrokesFilter::follow(const QModelIndex &changed)
{
    const QModelIndex group = changed.parent();
    if (m_text.isEmpty() || m_isToLookAgain || !group.isValid() ||
        filterAcceptsRow(group.row(), group.parent()) == mapFromSource(group).isValid())
        return;
    m_isToLookAgain = true;
    QMetaObject::invokeMethod(
        this,
        [this] {
            m_isToLookAgain = false;
            invalidateRowsFilter();
        },
        Qt::QueuedConnection);
}

void StrokesFilter::setText(const QString &text)
{
    if (text == m_text)
        return;
    m_text = text;
    invalidateRowsFilter();
}

bool StrokesFilter::matches(const QModelIndex &index) const
{
    return index.data().toString().contains(m_text, Qt::CaseInsensitive);
}

bool StrokesFilter::holdsMatch(const QModelIndex &index) const
{
    return matches(index) || (index.data(StrokesModel::GroupIdRole).toULongLong() != 0 && holdsMatchWithin(index));
}

bool StrokesFilter::holdsMatchWithin(const QModelIndex &group) const
{
    for (int row = 0; row < sourceModel()->rowCount(group); ++row)
        if (holdsMatch(sourceModel()->index(row, StrokesModel::NameColumn, group)))
            return true;
    return false;
}

bool StrokesFilter::filterAcceptsRow(int row, const QModelIndex &parent) const
{
    if (m_text.isEmpty())
        return true;
    const QModelIndex index = sourceModel()->index(row, StrokesModel::NameColumn, parent);
    if (index.data(StrokesModel::SegmentRole).toInt() >= 0)
        return true; // A segment is shown with its stroke.
    for (QModelIndex above = parent; above.isValid(); above = above.parent())
        if (matches(above))
            return true;
    return holdsMatch(index);
}

} // namespace suffuse
