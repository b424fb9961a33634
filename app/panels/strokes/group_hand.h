// Mode and opacity of groups, changed in their rows.
#pragma once

#include "app/session/value_entry.h"
#include "model/painting/painting.h"

#include <QObject>
#include <QPoint>

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
    /// Gives up what is being dragged.
    void giveUp();
    bool isDragging() const { return m_group != 0; }
    /// The menu of the modes; the one in use is checked.
    void fillModes(QMenu &menu, GroupId group);
    /// Opens a field for the opacity in the row.
    void typeOpacity(const QModelIndex &row, const Group &group, const GroupCells &cells);

    bool eventFilter(QObject *watched, QEvent *event) override;

signals:
    /// Why nothing was done.
    void said(const QString &text);

private:
    void close(QWidget &field);
    void setOpacity(GroupId group, double opacity, ValueEntry *entry);

    Editor &m_editor;
    QTreeView &m_view;
    ValueEntry m_entry;
    GroupId m_group = 0; ///< whose opacity is pressed
    double m_from = 1;   ///< the opacity at the press
    QPoint m_pressed;
    bool m_moved = false;
};

} // namespace suffuse
