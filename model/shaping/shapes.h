// Outlines of simple shapes, as chains of cubics that end where they begin.
#pragma once

#include "model/brush/brush.h"
#include "model/painting/stroke.h"

#include <numbers>
#include <vector>

namespace suffuse {

enum class ShapeKind { Rectangle, Ellipse, Polygon, Star };

/// What a shape is besides the two points between which it is drawn.
struct ShapeForm {
    static constexpr int leastCorners = 3, mostCorners = 200;

    ShapeKind kind = ShapeKind::Rectangle;
    /// How round corners are: of rectangles the radius in canvas units, which half of the shorter side limits; of
    /// polygons and stars the share of each side that is round, [0, 1].
    double radius = 0;
    double rounding = 0;
    int corners = 5;    ///< of polygons and tips of stars, from `leastCorners` to `mostCorners`
    double inner = 0.4; ///< of stars: the radius of the inner corners as a share of that of the tips, [0.01, 1]
    /// Of ellipses: where the arc begins, and how far it goes round clockwise, radians; a sweep of 2π is all of it.
    double from = 0;
    double sweep = 2 * std::numbers::pi;
    bool isPie = true; ///< of arcs: they are closed through the middle; else by a straight line
};

/// Whether a shape is drawn from its middle to a corner, and not in the box between two points.
constexpr bool isFromMiddle(ShapeKind kind)
{
    return kind == ShapeKind::Polygon || kind == ShapeKind::Star;
}

/// The outline of a shape. A rectangle or an ellipse stands in the box of which `a` and `b` are opposite corners; a
/// polygon or a star has its middle at `a` and a corner at `b`. Ellipses and the round corners of rectangles are off by
/// at most 3e-4 of their radius. It is empty where the shape has no size.
std::vector<Cubic> outlineOf(const ShapeForm &form, Point a, Point b);

/// A stroke along curves, each of which begins where the one before it ends, with the values that the brush has at full
/// pressure. Joints at which the direction does not change are smooth nodes. Curves of no length are left out. The
/// stroke has no segments where no curve has a length, and it may be out of the bounds of coordinates (`problemOf`).
Stroke strokeAlong(const std::vector<Cubic> &curves, const Brush &brush, StrokeId id, Microseconds born);

} // namespace suffuse
