#pragma once

#include "model/document/edit.h"

#include <QModelIndex>
#include <QWidget>

#include <functional>

class QLabel;
class QLineEdit;
class QMenu;
class QTreeView;

namespace suffuse {

class Editor;
class StrokesFilter;
class StrokesModel;
class StrokesView;

/// The painting's strokes and groups, topmost first, with thumbnails, names, eyes and locks, and the strokes' segments.
/// Selecting here selects in the painting and the other way round; dragging reorders.
class StrokesPanel : public QWidget {
    Q_OBJECT

public:
    explicit StrokesPanel(Editor &editor, QWidget *parent = nullptr);

    QTreeView *view() const;
    StrokesModel *model() const { return m_model; }
    QLineEdit *search() const { return m_search; }
    /// The view's index of a stroke; invalid where the search hides it.
    QModelIndex viewIndexOf(StrokeId id) const;
    /// What can be done with what is selected; `index`: the row that was clicked.
    void fillMenu(QMenu &menu, const QModelIndex &index);

    /// Something is searched for: not all rows are shown.
    bool isSearching() const;
    /// Selects the visible, unlocked strokes that the search has found; does nothing where none is made.
    void selectFound();

    QSize sizeHint() const override;

signals:
    void searchingChanged();

protected:
    void showEvent(QShowEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void search(const QString &text);
    void showWhetherFound();
    /// From the search to the list.
    void goToFirstFound();
    void documentChanged(const Change &change);
    void takeSelectionFromDocument();
    void giveSelectionToDocument();
    /// Of the view's rows, those below other groups too.
    void forEachGroup(const QModelIndex &parent, const std::function<void(const QModelIndex &)> &visit) const;
    std::set<GroupId> openGroups() const;
    /// The strokes that the view has in a row of its own: all where it is invalid.
    std::set<StrokeId> foundBelow(const QModelIndex &index) const;
    std::set<QModelIndex> groupsAroundSelected() const;
    void showMenu(const QPoint &at);
    void addSwitches(QMenu &menu, const QModelIndex &index);

    Editor &m_editor;
    StrokesModel *m_model = nullptr;
    StrokesFilter *m_filter = nullptr;
    StrokesView *m_view = nullptr;
    QLineEdit *m_search = nullptr;
    QLabel *m_notFound = nullptr;   ///< only there while it says so
    std::set<GroupId> m_openGroups; ///< before the search
    bool m_syncing = false;
    bool m_stale = true;
};

} // namespace suffuse
