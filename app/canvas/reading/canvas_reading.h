// What screen readers and other helpers find on the canvas: the painting's strokes.
#pragma once

#include "app/canvas/reading/stroke_tree.h"

#include <QAccessible>
#include <QObject>

#include <map>
#include <set>

namespace suffuse {

class CanvasWidget;
struct Change;

/// Lets every canvas that is made from now on be read. May be called again.
void installCanvasReading();

/// Gives a canvas its children for accessibility, one for each stroke and each group, and tells of what happens to them.
/// They are made when something asks for them, and know nothing but their ids: what they answer is read off the painting
/// as it is. Without a screen reader it keeps nothing.
class CanvasReading : public QObject, private QAccessible::ActivationObserver {
    Q_OBJECT

public:
    /// It must go before the canvas does.
    CanvasReading(CanvasWidget &canvas, QObject *parent);
    ~CanvasReading() override;

    CanvasWidget &canvas() const { return m_canvas; }
    /// The painting as it is, as a tree.
    const StrokeTree &tree() const;
    /// The stroke with this id; null where it is gone.
    StrokePtr stroke(StrokeId id) const { return tree().painting()->find(id); }

    /// What stands for an item; null where there is no such item.
    QAccessibleInterface *interfaceOf(const TreeItem &item);
    /// The interface of the canvas, or of the group around an item.
    QAccessibleInterface *parentOf(const TreeItem &item);

    /// The one stroke that is selected while the canvas has the keyboard; 0: there is none.
    StrokeId focused() const;
    bool isSelected(const TreeItem &item) const;
    /// Whether tools could select it now.
    bool canBeSelected(const TreeItem &item) const;
    /// Where it is on the screen, global logical pixels.
    QRect areaOf(const TreeItem &item) const;
    /// The stroke at a place on the screen; 0: there is none.
    StrokeId strokeAt(QPoint global) const;
    /// Selects a stroke or the strokes of a group: alone, or besides what is selected; those that are selected already are
    /// selected no more then. Does nothing with what is hidden or locked.
    void select(const TreeItem &item, bool besides);
    /// What was said last, by `say`.
    const QString &said() const { return m_said; }
    /// Tells readers a sentence: it becomes a part of what the canvas says about itself.
    void say(const QString &sentence);

    bool eventFilter(QObject *watched, QEvent *event) override;

signals:
    /// Readers were told of something about a stroke, a group or, where it is neither, the canvas.
    void told(QAccessible::Event what, const suffuse::TreeItem &about);

private:
    void accessibilityActiveChanged(bool active) override { m_active = active; }
    void tell(const TreeItem &about, QAccessible::Event what);
    void follow(const Change &change);
    void forgetGone();
    void tellStrokes(const Change &change, const Painting &before);
    void tellGone(QAccessible::Id interface, StrokeId stroke);
    void tellSelection();
    void tellFocus();
    QAccessibleInterface *ownInterface() const;
    std::set<StrokeId> strokesOf(const TreeItem &item) const;

    CanvasWidget &m_canvas;
    bool m_active = QAccessible::isActive(); ///< somebody reads
    mutable StrokeTree m_tree;
    std::map<std::pair<StrokeId, GroupId>, QAccessible::Id> m_ids; ///< of the interfaces that were made
    PaintingPtr m_told;                                            ///< as it was told last
    std::set<StrokeId> m_selected;                                 ///< as it was told last
    StrokeId m_focused = 0;                                        ///< as it was told last
    QString m_said;
};

} // namespace suffuse
