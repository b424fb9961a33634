// From knots to segments: the spline's pieces (docs/strokes.md).
#pragma once

#include "model/brush.h"
#include "model/segment.h"

#include <span>
#include <vector>

namespace suffuse {

/// What the spline runs through at a knot: position (offset from the stroke's origin), φˢ, colour and opacity.
using KnotValues = std::array<double, 7>;
namespace knot_column {
enum { X, Y, Density, Red, Yellow, Blue, Opacity };
}

struct Knot {
    double parameter = 0;  ///< of the spline, µs: real time without its pauses
    Microseconds time = 0; ///< document time
    KnotValues value{};
    KnotValues derivative{}; ///< with respect to the parameter

    Point position() const { return {value[knot_column::X], value[knot_column::Y]}; }
};

/// φˢ of a long line whose peak is pk at full pressure: pk·√π·s·(floor + (1 − floor)·pressure).
double densityFor(const Brush &brush, double pressure);

/// Between two knots' values at fraction u in [0, 1], linearly; derivatives are left at 0.
Knot interpolated(const Knot &a, const Knot &b, double u);

/// Fits the C² spline through the knots (two or more) and stores the derivatives. The end is natural, and so is the
/// start unless its derivative is `startIsFixed`.
void fitSpline(std::span<Knot> knots, bool startIsFixed);

/// Appends the segments of the interval from knots[i] to knots[i + 1], split where attributes vary until they are at
/// most s/2 long; each has the spline's attributes at the middle of its interval. The first starts at the end of the
/// last segment of `segments`, if there is one. Returns their arc length, units.
double appendInterval(const Brush &brush, std::span<const Knot> knots, std::size_t i, std::vector<Segment> &segments);

/// Arc length of a cubic, units; relative error below 1e-4 for the pieces of a fitted stroke.
double arcLength(const Cubic &cubic);

/// By what φˢ of a stroke of this arc length is multiplied so that its middle is as dense as a long line:
/// 1/erf(L/(2s)) below 2s, else 1.
double shortStrokeRaise(double arcLength, double spread);

} // namespace suffuse
