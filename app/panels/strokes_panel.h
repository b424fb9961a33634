#pragma once

#include "model/edit.h"

#include <QWidget>

class QLineEdit;
class QSortFilterProxyModel;
class QTreeView;

namespace suffuse {

class Editor;
class StrokesModel;

/// The painting's strokes and groups, topmost first, with names, eyes and locks. Selecting here selects in the painting
/// and the other way round; dragging reorders.
class StrokesPanel : public QWidget {
    Q_OBJECT

public:
    explicit StrokesPanel(Editor &editor, QWidget *parent = nullptr);

    QTreeView *view() const { return m_view; }
    StrokesModel *model() const { return m_model; }
    QLineEdit *search() const { return m_search; }
    /// The view's index of a stroke; invalid where the search hides it.
    QModelIndex viewIndexOf(StrokeId id) const;

    QSize sizeHint() const override;

protected:
    void showEvent(QShowEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void setUpView();
    void documentChanged(const Change &change);
    void takeSelectionFromDocument();
    void giveSelectionToDocument();

    Editor &m_editor;
    StrokesModel *m_model = nullptr;
    QSortFilterProxyModel *m_filter = nullptr;
    QTreeView *m_view = nullptr;
    QLineEdit *m_search = nullptr;
    bool m_syncing = false;
    bool m_stale = true;
};

} // namespace suffuse
