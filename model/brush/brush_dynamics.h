// What a brush paints at a moment of a stroke. It is a pure function of brush, pen and the stroke's seed, so that a
// stroke is the same while it is drawn, when it is done, and when its recording is painted again (docs/brushes.md).
#pragma once

#include "model/brush/brush.h"

namespace suffuse {

/// The pen at one moment.
struct PenState {
    double pressure = 1; ///< [0, 1]
    double tilt = 0;     ///< 0: upright, 1: 60° or more
    double speed = 0;    ///< spreads a second
    double distance = 0; ///< arc length since the stroke's start, spreads
};

/// What is painted at that moment.
struct Paint {
    double size = 1; ///< share of the brush's spread
    double peak = 0; ///< pk
    double granulation = 1;
    double maxAge = 1;
    Colour colour;
};

/// Sizes and drying times never become smaller shares of the brush's than these, since a segment needs both above 0.
inline constexpr double leastSize = 0.02;
inline constexpr double leastAge = 0.01;

/// What is painted. All that is random follows from `seed`, which is the same for a whole stroke.
Paint paintAt(const Brush &brush, const PenState &pen, std::uint64_t seed);

/// The share of the size that the taper leaves `distance` after the stroke's start and `rest` before its end, both in
/// spreads (`rest` is infinite while the pen is down). It rises from the tip's share to 1 along a parabola.
double taperAt(const Taper &taper, double distance, double rest);

/// The spread s of what is painted, units, without a tip's ratio.
double spreadOf(const Brush &brush, double size, double maxAge);

/// The spread s across a path of a direction: that of the tip in the direction of the path's normal.
double spreadAcross(const TipShape &tip, double spread, Point direction);

/// The angle of the tip on a path of a direction.
double tipAngle(const TipShape &tip, Point direction);

} // namespace suffuse
