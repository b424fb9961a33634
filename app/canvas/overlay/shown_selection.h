// The selection as the canvas shows it.
#pragma once

#include "app/canvas/overlay/selection_outline.h"
#include "app/session/selecting/begun_selection.h"

#include <QRegion>

namespace suffuse {

class Editor;

/// What is selected, less the strokes that are not begun at the moment that is looked at: they have neither outline nor
/// handles. It keeps what it has computed of it.
class ShownSelection {
public:
    explicit ShownSelection(Editor &editor) : m_editor(editor) {}

    const Selection &selection() const;
    /// The painting or the selection is another one.
    void noteChange() { m_begun.noteChange(); }
    /// Time goes on or back: true where selected strokes begin, or are not begun any more.
    bool followMoment();

    /// `selectionBox` of the selection, from boxes of strokes that are kept.
    Rect curves() const;
    /// The same on the screen, as far as the view shows it: logical pixels of the canvas, of which
    /// `canvas` is all; empty: nowhere.
    QRect curvesInView(const View &view, const QRect &canvas, double dpr) const;
    /// Where it is painted, with so many pixels around control points. Device pixels.
    QRegion area(const View &view, double margin, double dpr) const;
    /// The lines through it.
    SelectionOutline &outline() { return m_outline; }

private:
    Editor &m_editor;
    mutable SelectionOutline m_outline;
    mutable BegunSelection m_begun;
};

/// Where something that stands in a box, canvas units, is painted with so many pixels around it.
QRect markedArea(const Rect &units, double margin, const View &view, double dpr);

} // namespace suffuse
