#pragma once

#include "app/panels/strokes/group_cells.h"
#include "app/panels/strokes/rows/row_look.h"

#include <QTreeView>

namespace suffuse {

class Editor;
class StrokesFilter;
class StrokesModel;

/// Paints the rows of the Strokes dock, and drags them. When many rows change at once, only those in sight cost time.
class StrokesView : public QTreeView {
    Q_OBJECT

public:
    StrokesView(Editor &editor, const StrokesModel &model, StrokesFilter &filter, QWidget *parent = nullptr);

    void dataChanged(const QModelIndex &topLeft, const QModelIndex &bottomRight,
                     const QList<int> &roles = QList<int>()) override;

    /// Where mode and opacity of a group stand in its row; nowhere in other rows.
    GroupCells cellsOf(const QModelIndex &index) const;
    /// Whether a range of rows is being selected, and not one row after the other.
    bool isRanging() const { return m_ranging; }

    /// Selects the rows of groups that look selected, since each of their strokes is, so that groups are dragged as
    /// groups. Around the row that has the frame they stay as they are: a stroke can be dragged out of a group that
    /// holds no other.
    void selectWholeGroups();

    /// Those of the selected rows that can be moved, without those that go with their group.
    QModelIndexList draggedRows() const;

signals:
    /// Emitted when a key, which may be held down, moves the selected rows up or down by one.
    void stepped(bool up, bool held);
    /// Emitted when a person has gone to a row by a plain click or key; invalid where they clicked beside all rows.
    void chosen(const QModelIndex &index);
    /// Emitted where rows would have been dragged during a search, which hides rows between which they could be put.
    void dragRefused();

protected:
    QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex &index,
                                                         const QEvent *event = nullptr) const override;
    /// If no row is selected, the first key selects the row that has the frame.
    void keyPressEvent(QKeyEvent *event) override;
    /// A press takes the row of a group for selected if it looks so.
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void rowsAboutToBeRemoved(const QModelIndex &parent, int start, int end) override;
    void startDrag(Qt::DropActions actions) override;
    /// Of many ranges all is painted: looking for where each of them stands would take longer.
    QRegion visualRegionForSelection(const QItemSelection &selection) const override;
    void drawRow(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    void drawBranches(QPainter *painter, const QRect &rect, const QModelIndex &index) const override;

private:
    static bool isGroup(const QModelIndex &index);
    QItemSelection wholeOf(const QModelIndex &group) const;
    QModelIndex rowToRename() const;
    bool holdsSelected(const QModelIndex &group) const;
    bool goesWithGroup(QModelIndex group) const;

    const StrokesModel &m_model;
    const StrokesFilter &m_filter;
    mutable bool m_ranging = false; ///< what the last event selected
    bool m_isClick = false;         ///< the mouse is down and nothing is dragged
    QPersistentModelIndex m_clicked;
    WeakPalette m_weak;
};

} // namespace suffuse
