#pragma once

#include "app/panels/strokes/strokes_tree.h"
#include "model/painting/selection.h"

#include <QItemSelection>
#include <QObject>

#include <optional>
#include <unordered_map>

namespace suffuse {

class Editor;
class StrokesFilter;
class StrokesModel;
class StrokesView;

/// Selected rows are selected strokes and segments, and the other way round.
class RowSelection : public QObject {
public:
    RowSelection(Editor &editor, const StrokesModel &model, const StrokesFilter &filter, StrokesView &view);

    /// Selects the rows of what is selected in the painting; later, where the view is not seen now.
    void follow();
    /// The strokes that have a row of their own in the view below a row; all of them where the index is invalid.
    std::set<StrokeId> foundBelow(const QModelIndex &index) const;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// The numbers of the selected rows below each row that has some.
    using Rows = std::unordered_map<const StrokesTree::Node *, std::vector<int>>;

    Rows rowsOf(const Selection &selected) const;
    QItemSelection selectionOf(const Rows &rows) const;
    QModelIndex rowToShow(const Rows &rows) const;
    void followRows();
    void take();
    void give();
    std::set<QModelIndex> groupsAroundSelected() const;

    Editor &m_editor;
    const StrokesModel &m_model;
    const StrokesFilter &m_filter;
    StrokesView &m_view;
    std::optional<Selection> m_given; ///< what the rows have selected, until something else selects
    bool m_syncing = false;
    bool m_stale = true;
    bool m_isNew = true; ///< whether something else is selected than what the view was moved to last
};

} // namespace suffuse
