// Drags of nodes, handles and curves, and of the reach within which a stroke follows them.
#pragma once

#include "app/canvas/input/pointer_event.h"
#include "app/session/gesture.h"
#include "app/session/selecting/snapping.h"
#include "app/tools/nodes/node_marks.h"
#include "app/tools/nodes/soft_reach.h"

#include <map>

namespace suffuse {

class CanvasWidget;

/// The part of a stroke that lies under the pointer: a node or a handle, or else a place on the curve.
struct NodeHit {
    NodeMarks::Hit mark;
    StrokeId curve = 0; ///< the stroke whose curve is hit; 0 if none is
    CurvePlace place;   ///< the place on that curve
    /// Whether an erasure is meant, which is moved as it is: by its nodes, and without a reach.
    bool erasure = false;
    /// The node of an erasure that lies there. The erasure is meant, and the node only by a click once that is selected.
    std::optional<NodeRef> within;

    SegmentRef segment() const { return {curve, place.segment}; }
};

/// There is one drag at a time, which is one gesture. A drag with Alt, from a node or the curve, sets the reach and
/// leaves the painting as it is.
class NodeDrag {
public:
    NodeDrag(CanvasWidget &canvas, SoftReach &reach) : m_canvas(canvas), m_soft(reach) {}

    /// Takes hold of what a press has hit. If that is a node, takes all selected nodes. A locked stroke cannot be
    /// taken.
    void begin(const PointerEvent &press, const NodeHit &hit, const std::set<NodeRef> &nodes);
    bool isOpen() const { return m_gesture.isOpen() || m_setsReach; }
    /// Whether a stroke is in hand.
    bool holds(StrokeId stroke) const { return m_gesture.before(stroke); }
    void move(const PointerEvent &event);
    /// Makes the reach larger by so many steps of the wheel, or smaller. Returns false if no drag with a reach goes on.
    bool stepReach(double steps);
    void commit();
    void giveUp();

    void paint(QPainter &painter, const View &view, double dpr) const;
    /// How far around the strokes `paint` may draw, in device pixels.
    double margin() const;

private:
    void take(const std::set<StrokeId> &strokes, const QString &name);
    void gatherPlaces();
    void setReach(double reach);
    void show();
    void showNodes();
    void showHandle();
    void showCurve();
    void end();
    StrokeId grabbed() const;
    /// The grabbed stroke as it is shown; null if what was grabbed is not there any more.
    StrokePtr grabbedStroke() const;
    /// The grabbed node or place of the curve, in canvas units.
    Point placeOn(const Stroke &stroke) const;
    double dpr() const;

    CanvasWidget &m_canvas;
    SoftReach &m_soft;
    Gesture m_gesture;
    NodeHit m_hit;
    std::map<StrokeId, std::vector<int>> m_nodes; ///< the nodes that are moved
    PointerEvent m_start, m_now;
    double m_reach = 0; ///< canvas units
    bool m_setsReach = false;
    std::optional<double> m_chosenBefore;
    Snapping m_snapping;
    Snap m_snap;
};

} // namespace suffuse
