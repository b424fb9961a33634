#pragma once

#include "app/session/value_entry.h"
#include "model/document/edit.h"

#include <QModelIndex>
#include <QWidget>

#include <optional>
#include <vector>

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QMenu;
class QTreeView;

namespace suffuse {

class Editor;
class GroupHand;
class KeptRows;
class RowSelection;
class StrokesFilter;
class StrokesModel;
class StrokesView;

/// Shows the painting's strokes and groups, the topmost first, with pictures, names, eyes and locks, and the segments
/// of the strokes. Selecting rows selects strokes in the painting, and the other way round; dragging rows reorders
/// strokes.
class StrokesPanel : public QWidget {
    Q_OBJECT

public:
    /// `more` stand in the menu of a row as well: commands that do something to what is selected.
    explicit StrokesPanel(Editor &editor, const QList<QAction *> &more = {}, QWidget *parent = nullptr);

    /// Puts a button for a switch beside the search.
    void addSwitch(QAction &action);

    QTreeView *view() const;
    StrokesModel *model() const { return m_model; }
    QLineEdit *search() const { return m_search; }
    /// The view's index of a stroke; invalid where the search hides it.
    QModelIndex viewIndexOf(StrokeId id) const;
    /// Makes the menu of a row: what can be done with the selection and, of a group's, its mode and opacity. No letter
    /// stands in it twice.
    void makeMenu(QMenu &menu, const QModelIndex &index);
    /// Fills a menu with what can be done with the selection; `index` is the row that was clicked.
    void fillMenu(QMenu &menu, const QModelIndex &index);

    /// Whether something is searched for, so that not all rows are shown.
    bool isSearching() const;
    /// Selects the visible, unlocked strokes that the search has found. Without a search it does nothing.
    void selectFound();

    /// The groups that are open, or were before what is searched for now.
    std::vector<GroupId> openGroups() const;
    /// Opens these groups and closes the others, or does so after what is searched for now.
    void openOnly(const std::vector<GroupId> &groups);

    QSize sizeHint() const override;

signals:
    /// Emitted when a search begins or ends.
    void searchingChanged();
    /// Why nothing was done, for the status bar.
    void said(const QString &message);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// Eyes and locks are switched without changing the selection: that of the row that is pressed, and likewise those
    /// of the rows over which the pointer is drawn then, in one step. Returns whether the event was used for that.
    bool sweep(const QEvent &event);
    /// Mode and opacity are changed in the rows of groups. Returns whether the event was used for that.
    bool handTakes(const QEvent &event);
    void search(const QString &text);
    void showWhetherFound();
    void showLayer();
    void showRowOfLayer();
    /// What is painted goes to where a row is: into the group, or into the one that the stroke is in.
    void chooseLayer(const QModelIndex &index);
    /// Moves the focus from the search to the first row that was found.
    void goToFirstFound();
    void showMenu(const QPoint &at);
    void step(bool up, bool held);

    Editor &m_editor;
    QList<QAction *> m_more;
    /// The column that is switched while the button is held, and what its switches are switched from.
    struct Sweep {
        int column = 0;
        bool from = false;
    };
    std::optional<Sweep> m_sweep;
    ValueEntry m_sweepStep;
    ValueEntry m_moves; ///< of rows, by keys
    StrokesModel *m_model = nullptr;
    StrokesFilter *m_filter = nullptr;
    StrokesView *m_view = nullptr;
    GroupHand *m_hand = nullptr;
    KeptRows *m_kept = nullptr;
    RowSelection *m_selection = nullptr;
    QHBoxLayout *m_header = nullptr;
    QLineEdit *m_search = nullptr;
    QLabel *m_notFound = nullptr; ///< shown only while nothing is found
    QLabel *m_layer = nullptr;    ///< shown only while there is a layer
};

} // namespace suffuse
