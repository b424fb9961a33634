// The density at a point (eq 13, 14), quickly, for tools and panels. render/probe.h has the exact figures.
#pragma once

#include "model/painting/stroke.h"

#include <array>
#include <vector>

namespace suffuse {

/// How near the straight pieces of a segment's curve stay to it, in spreads. The density is wrong by about half as much
/// of its peak.
enum class CurveDetail {
    Rough, ///< 0.03, for hit tests, which ask thousands of times
    Fine   ///< 0.001, for figures and plots
};

/// φ_k of a segment of spread s > 0, as a function of the point. The curve counts as straight pieces, whose density has
/// a closed form. Whoever asks for many points keeps the object, since the pieces are found when it is made.
class DensityOfSegment {
public:
    DensityOfSegment(const Segment &segment, double spread, CurveDetail detail);
    /// At a point relative to the stroke's origin; 0 beyond the reach.
    double operator()(Point fromOrigin) const;
    /// Whether the segment's influence (see `influenceOf`) reaches a point relative to its stroke's origin.
    bool reaches(Point fromOrigin) const { return m_influence.contains(fromOrigin); }

    struct Piece;

private:
    Rect m_influence;               ///< as seen from the stroke's origin
    std::array<Point, 2> m_toWhite; ///< what the canvas' unit vectors are in that plane
    std::vector<Piece> m_pieces;
};

/// A straight piece of a curve, in the plane where the segment's Gaussian is e^(−|x|²).
struct DensityOfSegment::Piece {
    Point start, along; ///< along: of length 1
    double length;
    double weight; ///< what the integral counts on the canvas
};

/// φ_k of a segment of spread s > 0, at one point relative to its stroke's origin.
double segmentDensity(const Segment &segment, double spread, Point fromOrigin, CurveDetail detail);

/// Whether the influence of a segment of a spread (see `influenceOf`) reaches a point relative to its stroke's origin.
bool reaches(const Segment &segment, double spread, Point fromOrigin);

/// φ_k of a segment at a canvas point, in fine detail. It is 0 where the segment is not there yet and beyond its reach.
double segmentDensityAt(const Stroke &stroke, const Segment &segment, Microseconds time, Point point);
/// φ = max(0, φ⁺ − φ⁻) of a stroke.
double strokeDensityAt(const Stroke &stroke, Microseconds time, Point point);

} // namespace suffuse
