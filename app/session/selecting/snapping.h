// Snapping: draws a point that is being dragged to nodes of strokes, to guides and to the grid.
#pragma once

#include "model/geometry/guide.h"
#include "model/painting/painting.h"
#include "render/view.h"

#include <functional>
#include <vector>

namespace suffuse {

inline constexpr double minGridStep = 1e-6;
inline constexpr double maxGridStep = 1e6;

/// What rulers count; the painting says how many canvas units are an inch (`Editor::resolution`).
enum class RulerUnits { Canvas, Millimetres, Inches };

/// Aids of the canvas. Each window has its own; the next window begins with those that were changed last.
struct CanvasAids {
    bool snapToNodes = false;
    bool snapToGrid = false;
    bool showGrid = false;
    double gridStep = 20;      ///< canvas units
    bool showOutlines = true;  ///< outlines of the selected strokes
    bool showErasures = false; ///< lines along what takes paint away
    bool showBeyond = false;   ///< paint beyond the canvas, under a veil
    bool showSymmetry = true;  ///< axes of the symmetry, and what drags them
    bool showRulers = false;
    RulerUnits rulerUnits = RulerUnits::Canvas;
    bool showGuides = true; ///< nothing snaps to those that are not seen
    bool snapToGuides = true;
    bool lockGuides = false;    ///< no press takes hold of one
    bool showAssistants = true; ///< no stroke follows those that are not seen
    bool snapToAssistants = true;
    friend bool operator==(const CanvasAids &, const CanvasAids &) = default;
};

enum class SnapTo { Nothing, Node, Line };

/// A point, and what it was snapped to.
struct Snap {
    Point point;
    SnapTo to = SnapTo::Nothing;
};

/// Gathers the places to snap to when a drag begins, and is asked at each of its moves.
class Snapping {
public:
    /// A point snaps to places within so many logical pixels.
    static constexpr double reach = 8;
    /// True for nodes that move themselves and are no places to snap to. Nodes are counted as in
    /// model/shaping/curves/chains.h.
    using LeftOut = std::function<bool(const Stroke &, int node)>;

    /// This one snaps to nothing.
    Snapping() = default;
    /// Snaps to nodes of visible strokes that are not left out, and to the grid, as the aids ask for.
    Snapping(const Painting &painting, const CanvasAids &aids, const LeftOut &leftOut = {});
    /// The same, and to those of the guides that the aids show and let snap.
    Snapping(const Painting &painting, const CanvasAids &aids, const std::vector<Guide> &guides,
             const LeftOut &leftOut = {});

    /// Returns the nearest node within reach, else the guides or lines of the grid within reach, else the point itself.
    Snap snap(Point point, const View &view, double dpr) const;
    /// For points that move together by `by`: returns the move that brings one of them to a node or, along each axis,
    /// to a guide or a line of the grid; `by` itself where none comes near. `at` gets the place to which it was
    /// brought.
    Snap snapMove(const std::vector<Point> &points, Point by, const View &view, double dpr, Point *at = nullptr) const;

private:
    /// The nearest node, or null where none is nearer than `limit`.
    const Point *nearestNode(Point point, double limit, double *distance) const;
    /// The way from a coordinate to the nearest upright or level line; infinite where there is none.
    double toLine(double v, bool upright) const;

    std::vector<Point> m_nodes;
    std::vector<Guide> m_guides;
    double m_step = 0; ///< 0: no grid
};

} // namespace suffuse
