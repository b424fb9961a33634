// Makes segments of knots: the pieces of the spline (docs/strokes.md).
#pragma once

#include "model/brush/brush_dynamics.h"

#include <span>
#include <vector>

namespace suffuse {

/// What the spline goes through at a knot: the position (as an offset from the stroke's origin) and what is painted
/// there.
using KnotValues = std::array<double, 10>;
namespace knot_column {
enum { X, Y, Size, Peak, Granulation, MaxAge, Red, Yellow, Blue, Opacity };
}

struct Knot {
    double parameter = 0;  ///< the spline's parameter, µs: real time without its pauses
    double distance = 0;   ///< the distance from the stroke's start along the samples, spreads
    Microseconds time = 0; ///< document time
    KnotValues value{};
    KnotValues derivative{}; ///< with respect to the parameter

    Point position() const { return {value[knot_column::X], value[knot_column::Y]}; }
    void setPaint(const Paint &paint);
    Paint paint() const; ///< in the domains of segments
};

/// Gives a segment what is painted where the path has a direction. Its curve, birth and node stay. φˢ = pk·√π·s, with s
/// across the path, is that of a long line.
void setPaint(Segment &segment, const Brush &brush, const Paint &paint, Point direction);

/// The values between two knots at fraction u in [0, 1], linearly. Derivatives are left at 0.
Knot interpolated(const Knot &a, const Knot &b, double u);

/// How a stroke grows from its start and runs out at its end.
struct TaperedPath {
    Taper taper;
    double length = std::numeric_limits<double>::infinity(); ///< spreads; infinite while it is drawn
};

/// Fits the C² spline through the knots (two or more), and stores the derivatives in them. The end is natural, and so
/// is the start unless its derivative is given (`startIsFixed`).
void fitSpline(std::span<Knot> knots, bool startIsFixed);

/// Appends the segments of the interval from knots[i] to knots[i + 1], which is split where attributes vary until
/// segments are at most s/2 long. Each has the spline's attributes at the middle of its interval, tapered towards the
/// ends of the path. The first starts at the end of the last segment of `segments`, if there is one. Returns their arc
/// length, units.
double appendInterval(const Brush &brush, std::span<const Knot> knots, std::size_t i, const TaperedPath &path,
                      std::vector<Segment> &segments);

/// Arc length of a cubic, units; relative error below 1e-4 for the pieces of a fitted stroke.
double arcLength(const Cubic &cubic);

/// By what φˢ of a stroke of this arc length is multiplied so that its middle is as dense as a long line:
/// 1/erf(L/(2s)) below 2s, else 1.
double shortStrokeRaise(double arcLength, double spread);

} // namespace suffuse
