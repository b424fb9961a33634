#pragma once

#include "model/document/edit.h"

#include <QWidget>

class QLineEdit;
class QMenu;
class QTreeView;

namespace suffuse {

class Editor;
class StrokesFilter;
class StrokesModel;

/// The painting's strokes and groups, topmost first, with thumbnails, names, eyes and locks, and the strokes' segments.
/// Selecting here selects in the painting and the other way round; dragging reorders.
class StrokesPanel : public QWidget {
    Q_OBJECT

public:
    explicit StrokesPanel(Editor &editor, QWidget *parent = nullptr);

    QTreeView *view() const { return m_view; }
    StrokesModel *model() const { return m_model; }
    QLineEdit *search() const { return m_search; }
    /// The view's index of a stroke; invalid where the search hides it.
    QModelIndex viewIndexOf(StrokeId id) const;
    /// What can be done with what is selected; `index`: the row that was clicked.
    void fillMenu(QMenu &menu, const QModelIndex &index);

    QSize sizeHint() const override;

protected:
    void showEvent(QShowEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void documentChanged(const Change &change);
    void takeSelectionFromDocument();
    void giveSelectionToDocument();
    void showMenu(const QPoint &at);
    void addSwitches(QMenu &menu, const QModelIndex &index);

    Editor &m_editor;
    StrokesModel *m_model = nullptr;
    StrokesFilter *m_filter = nullptr;
    QTreeView *m_view = nullptr;
    QLineEdit *m_search = nullptr;
    bool m_syncing = false;
    bool m_stale = true;
};

} // namespace suffuse
