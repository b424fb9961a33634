#include "app/panels/strokes/rows/row_moves.h"

#include "app/panels/strokes/strokes_filter.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_view.h"

#include <QCoreApplication>

#include <algorithm>

namespace suffuse {

namespace {

/// The panel's words, without knowing the panel.
struct RowMoves {
    Q_DECLARE_TR_FUNCTIONS(suffuse::StrokesPanel)
};

/// Where rows go: above a row of a group, or of none.
struct Gap {
    QModelIndex parent;
    int row = -1; ///< there is no place
};

Gap gapAbove(const StrokesView &view, const StrokesModel &model, const StrokesFilter &filter, const QModelIndex &row)
{
    const QModelIndex above = model.index(row.row() - 1, StrokesModel::NameColumn, row.parent());
    if (!above.isValid())
        return row.parent().isValid() ? Gap{row.parent().parent(), row.parent().row()} : Gap();
    if (model.groupAt(above) && view.isExpanded(filter.mapFromSource(above)))
        return {above, model.rowCount(above)};
    return {row.parent(), above.row()};
}

Gap gapBelow(const StrokesView &view, const StrokesModel &model, const StrokesFilter &filter, const QModelIndex &row)
{
    const QModelIndex below = model.index(row.row() + 1, StrokesModel::NameColumn, row.parent());
    if (!below.isValid())
        return row.parent().isValid() ? Gap{row.parent().parent(), row.parent().row() + 1} : Gap();
    if (model.groupAt(below) && view.isExpanded(filter.mapFromSource(below)))
        return {below, 0};
    return {row.parent(), below.row() + 1};
}

} // namespace

std::vector<int> placeOf(QModelIndex row)
{
    std::vector<int> place;
    for (; row.isValid(); row = row.parent())
        place.push_back(row.row());
    std::ranges::reverse(place);
    return place;
}

QString moveRows(StrokesView &view, StrokesModel &model, const StrokesFilter &filter, bool up, ValueEntry &entry)
{
    view.selectWholeGroups();
    QModelIndexList rows;
    for (const QModelIndex &row : view.draggedRows())
        rows << filter.mapToSource(row);
    if (rows.isEmpty() && (view.currentIndex().flags() & Qt::ItemIsDragEnabled))
        rows << filter.mapToSource(view.currentIndex().siblingAtColumn(StrokesModel::NameColumn));
    if (rows.isEmpty())
        return RowMoves::tr("Select rows to move them.");
    const auto [top, bottom] = std::ranges::minmax_element(rows, {}, placeOf);
    const Gap gap = up ? gapAbove(view, model, filter, *top) : gapBelow(view, model, filter, *bottom);
    if (gap.row < 0)
        return up ? RowMoves::tr("Nothing changes: this is on top already.")
                  : RowMoves::tr("Nothing changes: this is at the bottom already.");
    return model.move(rows, gap.parent, gap.row, &entry) ? QString()
                                                 : RowMoves::tr("Nothing changes: locked strokes stay in place.");
}

} // namespace suffuse
