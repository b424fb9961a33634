#include "app/panels/strokes/strokes_filter.h"

#include "app/panels/strokes/strokes_model.h"

namespace suffuse {

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
    if (matches(index))
        return true;
    if (!index.data(StrokesModel::GroupIdRole).toULongLong())
        return false;
    for (int row = 0; row < sourceModel()->rowCount(index); ++row)
        if (holdsMatch(sourceModel()->index(row, StrokesModel::NameColumn, index)))
            return true;
    return false;
}

bool StrokesFilter::filterAcceptsRow(int row, const QModelIndex &parent) const
{
    if (m_text.isEmpty())
        return true;
    const QModelIndex index = sourceModel()->index(row, StrokesModel::NameColumn, parent);
    if (index.data(StrokesModel::SegmentRole).toInt() >= 0)
        return true; // shown with its stroke
    for (QModelIndex above = parent; above.isValid(); above = above.parent())
        if (matches(above))
            return true;
    return holdsMatch(index);
}

} // namespace suffuse
