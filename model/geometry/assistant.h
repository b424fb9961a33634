// What leads a stroke: straight lines, lines to vanishing points, ellipses.
#pragma once

#include "model/geometry/geometry.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace suffuse {

/// A line or an ellipse on which the points of a stroke are put.
struct AssistantTrack {
    Point origin;      ///< of a line any of its points, of an ellipse the centre
    Point along{1, 0}; ///< direction of the line, or of the first half axis; length 1
    double first = 0;  ///< half axes; both 0: it is a line
    double second = 0;

    bool isLine() const { return first == 0 && second == 0; }
    /// The point of it that is nearest to another one, of an ellipse by Newton's method. What is not finite comes back
    /// as it is.
    Point nearest(Point point) const;
    friend bool operator==(const AssistantTrack &, const AssistantTrack &) = default;
};

enum class AssistantKind {
    Ruler,          ///< the line through two points
    Parallel,       ///< lines in the direction from one point to another
    VanishingPoint, ///< lines through a point
    Perspective,    ///< lines as the sides of a quadrilateral have them: through the points where opposite ones meet
    Ellipse,        ///< centre, and the ends of two half axes at a right angle
    Concentric      ///< ellipses of one centre and form; the points are those of one of them
};

/// An assistant is its points, by which it is dragged, too.
struct Assistant {
    static constexpr std::size_t mostPoints = 4;

    AssistantKind kind = AssistantKind::Ruler;
    std::vector<Point> points; ///< canvas units, `pointsOf(kind)` of them

    friend bool operator==(const Assistant &, const Assistant &) = default;

    static std::size_t pointsOf(AssistantKind kind);
    bool isRound() const { return kind == AssistantKind::Ellipse || kind == AssistantKind::Concentric; }
    /// Whether it has all of its points, and none lies too far away to be computed with.
    bool isSound() const;
    /// The one that a drag from a point to another makes: a line, a point, or what fills the box between them.
    static Assistant between(AssistantKind kind, Point from, Point to);

    /// With a point dragged elsewhere. Dragging the centre of an ellipse takes all of it along; at the end of the first
    /// half axis it is turned, at that of the second its form is changed.
    Assistant withPoint(std::size_t number, Point to) const;
    Assistant movedBy(Point by) const;

    /// Of round ones: the half axes, and the angle of the first one, clockwise in radians.
    struct Form {
        double first = 0, second = 0, angle = 0;
    };
    Form form() const;
    Assistant withForm(const Form &form) const;

    /// The ellipse of a round one, the line of a ruler or of parallels; no value where it is none.
    std::optional<AssistantTrack> ownTrack() const;
    /// Where the sides of a perspective meet, or the vanishing point; those at infinity are left out.
    std::vector<Point> vanishingPoints() const;
};

/// The track of the assistants that a stroke is meant to follow which began at `start` and has come to `now`; no value:
/// none, and it stays free. Of those whose direction is at most 30° off the one that agrees best is taken. A ruler and
/// an ellipse lead strokes that begin within `reach` (canvas units) of them, and count as if they agreed twice as well:
/// one begins there on purpose, and the lines of the others are everywhere.
std::optional<AssistantTrack> trackOf(const std::vector<Assistant> &assistants, Point start, Point now, double reach);

} // namespace suffuse
