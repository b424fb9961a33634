#pragma once

#include <QTreeView>

namespace suffuse {

class Editor;
class StrokesFilter;
class StrokesModel;

/// How the rows of the Strokes dock look, and how they are dragged. Many rows that change at once cost no more than
/// what is to be seen of them.
class StrokesView : public QTreeView {
    Q_OBJECT

public:
    StrokesView(Editor &editor, const StrokesModel &model, StrokesFilter &filter, QWidget *parent = nullptr);

    void dataChanged(const QModelIndex &topLeft, const QModelIndex &bottomRight,
                     const QList<int> &roles = QList<int>()) override;

    /// What is being selected is a range of rows, not one row after the other.
    bool isRanging() const { return m_ranging; }

protected:
    QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex &index,
                                                         const QEvent *event = nullptr) const override;
    /// The first key selects the row that is framed where none is selected.
    void keyPressEvent(QKeyEvent *event) override;
    void drawRow(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;

private:
    mutable bool m_ranging = false; ///< by the last event that selected
};

} // namespace suffuse
