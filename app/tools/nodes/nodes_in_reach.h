// What of the selected strokes lies under the pointer of the Segments tool.
#pragma once

#include "app/tools/nodes/erasures.h"
#include "app/tools/nodes/node_drag.h"
#include "app/tools/nodes/node_marks.h"

namespace suffuse {

class CanvasWidget;
class Editor;
struct Change;

/// The marks of nodes and handles for the present state of painting, selection and view, made when they are needed.
class NodesInReach {
public:
    /// `nodes` are those that are selected. It and the canvas must live longer.
    NodesInReach(CanvasWidget &canvas, const std::set<NodeRef> &nodes);

    const NodeMarks &marks() const;
    /// The node or handle at a pixel of the canvas; where something of the tool's own lies around it, `narrow` leaves
    /// that a ring.
    NodeMarks::Hit markAt(Point pixel, bool narrow) const;
    /// The node, the handle, or the place on the curve of a selected stroke that the pointer is over; else, where
    /// erasures are shown, the one that is.
    NodeHit hitAt(const PointerEvent &event, bool narrow) const;

    /// Other marks are shown from now on: something was selected, or else may be reached.
    void reset() { m_marks.reset(); }
    /// Strokes have become others while they are dragged, and nothing else has changed.
    void followDrag(const Change &change);
    /// The painting has changed. Of strokes that `drag` holds the same nodes are shown as before.
    void follow(const Change &change, const NodeDrag &drag);

private:
    bool meansErasure(const NodeRef &node) const;
    /// The place on an erasure, of those that are shown, that the pointer is over.
    std::optional<ErasurePlace> shownErasureAt(Point point, double reach) const;
    /// The place on a selected erasure that the pointer is over, where a node or handle of paint is so near that it
    /// would be taken instead: a drag moves what a click has chosen.
    std::optional<ErasurePlace> selectedErasureAt(Point point, double reach) const;
    /// Looks for the place on the curve of a selected stroke that is nearest to a point, at most so far away.
    void findCurve(Point point, double reach, NodeHit &hit) const;

    CanvasWidget &m_canvas;
    Editor &m_editor;
    const std::set<NodeRef> &m_nodes;
    mutable ShownNodes m_shown;
    mutable std::optional<NodeMarks> m_marks; ///< none after a change, until they are needed
};

} // namespace suffuse
