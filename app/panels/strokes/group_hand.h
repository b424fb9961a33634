// Mode and opacity of groups, changed in their rows.
#pragma once

#include "app/session/value_entry.h"
#include "model/painting/painting.h"

#include <QObject>
#include <QPoint>

#include <optional>

class QKeyEvent;
class QMenu;
class QModelIndex;
class QMouseEvent;
class QTreeView;

namespace suffuse {

class Editor;
struct GroupCells;

/// A click on the mode of a row lists the modes. The opacity is dragged to the sides, in one step, or typed after a
/// click.
class GroupHand : public QObject {
    Q_OBJECT

public:
    static constexpr double perPixel = 0.005; ///< how much of the opacity a logical pixel is

    GroupHand(Editor &editor, QTreeView &view);

    /// Returns whether it used a mouse event of the view's viewport. `group` is that of the row where it happened; null
    /// where there is none.
    bool takes(const QMouseEvent &event, const QModelIndex &row, const Group *group, const GroupCells &cells);
    /// Gives up what is being dragged. Until the button is let go, the press does nothing any more.
    void giveUp();
    bool isDragging() const { return m_press && !m_press->isOver; }
    /// The menu of the modes; the one in use is checked.
    void fillModes(QMenu &menu, GroupId group);
    /// Opens a field for the opacity in the row.
    void typeOpacity(const QModelIndex &row, const Group &group, const GroupCells &cells);

    bool eventFilter(QObject *watched, QEvent *event) override;

signals:
    /// Why nothing was done.
    void said(const QString &text);

private:
    static bool goesToLetter(QMenu &menu, QKeyEvent &key);
    void close(QWidget &field);
    void setOpacity(GroupId group, double opacity, ValueEntry *entry);
    std::optional<float> opacityOf(GroupId group) const;
    void dragTo(const QPoint &at);

    Editor &m_editor;
    QTreeView &m_view;
    ValueEntry m_entry;
    /// A press on the opacity of a group.
    struct Press {
        GroupId group = 0;
        double from = 1; ///< the opacity at the press
        QPoint at;
        std::optional<float> shown = {}; ///< the opacity that was dragged to last; no value: not dragged yet
        bool isOver = false;             ///< given up, or taken back by an undo
    };
    std::optional<Press> m_press;
};

} // namespace suffuse
