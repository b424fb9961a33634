// The selection as the canvas shows it.
#pragma once

#include "app/canvas/overlay/selection_outline.h"
#include "app/session/selecting/begun_selection.h"

#include <QRegion>

namespace suffuse {

class Editor;

/// The selection without the strokes that are not begun at the moment that is looked at, which have neither outline nor
/// handles. It keeps what it has computed of the selection.
class ShownSelection {
public:
    explicit ShownSelection(Editor &editor) : m_editor(editor) {}

    const Selection &selection() const;
    /// To be called when the painting or the selection is another one.
    void noteChange() { m_begun.noteChange(); }
    /// To be called when the moment changes. Returns true if selected strokes begin, or are no longer begun.
    bool followMoment();

    /// The box that `selectionBox` gives for the selection. It is quick, since it is made from boxes of strokes that
    /// are kept.
    Rect curves() const;
    /// The part of that box that the view shows, in logical pixels of the canvas widget, whose area is `canvas`. It is
    /// empty where the view shows none of it.
    QRect curvesInView(const View &view, const QRect &canvas, double dpr) const;
    /// Where the selection is painted in the view, with `margin` pixels around control points. All are device pixels.
    QRegion area(const View &view, double margin, double dpr) const;
    /// The lines through the selection.
    SelectionOutline &outline() { return m_outline; }

private:
    Editor &m_editor;
    mutable SelectionOutline m_outline;
    mutable BegunSelection m_begun;
};

/// Where something is painted that stands in a box of the canvas, with `margin` pixels around it. All pixels are device
/// pixels.
QRect markedArea(const Rect &units, double margin, const View &view, double dpr);

} // namespace suffuse
