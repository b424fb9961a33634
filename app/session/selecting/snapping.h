// Where a point that is being dragged is drawn to: nodes of strokes and the grid.
#pragma once

#include "model/painting/painting.h"
#include "render/view.h"

#include <functional>
#include <vector>

namespace suffuse {

inline constexpr double minGridStep = 1e-6;
inline constexpr double maxGridStep = 1e6;

/// What helps the hand on the canvas; a window's own, remembered for the next one.
struct CanvasAids {
    bool snapToNodes = false;
    bool snapToGrid = false;
    bool showGrid = false;
    double gridStep = 20; ///< canvas units
    bool showOutlines = true; ///< of the selected strokes
    bool showBeyond = false;  ///< veiled, the paint that lies beside the canvas
    friend bool operator==(const CanvasAids &, const CanvasAids &) = default;
};

enum class SnapTo { Nothing, Node, Grid };

/// A point, and what it was drawn to.
struct Snap {
    Point point;
    SnapTo to = SnapTo::Nothing;
};

/// Gathers what there is to snap to when a drag begins, and is asked at each of its moves.
class Snapping {
public:
    /// Logical pixels within which a point is drawn to something.
    static constexpr double reach = 8;
    /// True for nodes that move themselves; node n of n segments is the end.
    using LeftOut = std::function<bool(const Stroke &, int node)>;

    /// Snaps to nothing.
    Snapping() = default;
    /// Nodes of visible strokes, but for those left out, and the grid, as the aids ask for.
    Snapping(const Painting &painting, const CanvasAids &aids, const LeftOut &leftOut = {});

    /// The nearest node within reach, else the grid lines within reach, else the point itself.
    Snap snap(Point point, const View &view, double dpr) const;
    /// For points that move together by `by`: the move that brings one of them to a node or, along each axis, to a line
    /// of the grid (`by` itself where none comes near), and in `at` where that is.
    Snap snapMove(const std::vector<Point> &points, Point by, const View &view, double dpr, Point *at = nullptr) const;

private:
    /// Null: none nearer than `limit`.
    const Point *nearestNode(Point point, double limit, double *distance) const;
    /// From a coordinate to the nearest line.
    double toGrid(double v) const;

    std::vector<Point> m_nodes;
    double m_step = 0; ///< 0: no grid
};

} // namespace suffuse
