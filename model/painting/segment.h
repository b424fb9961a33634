// One segment of a stroke: a cubic that is a source of the heat equation.
#pragma once

#include "model/geometry/geometry.h"
#include "model/painting/style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace suffuse {

using Microseconds = std::int64_t; ///< document time in whole microseconds

inline double toSeconds(Microseconds t)
{
    return double(t) * 1e-6;
}
inline Microseconds toMicroseconds(double seconds)
{
    return Microseconds(std::llround(seconds * 1e6));
}

/// The kind of the node at the start of a segment.
enum class NodeKind : std::uint8_t { Smooth, Symmetric, Corner };

/// From `time` (T_r) on, the segment spreads for another `extra` seconds.
struct Rewet {
    Microseconds time = 0;
    Microseconds extra = 0;
    friend bool operator==(const Rewet &, const Rewet &) = default;
};

/// The values of one segment (eq 13). Their domains are checked by `problemOf` (model/painting/validate.h), not here.
struct Segment {
    std::array<Offset, 4> bezier;     ///< control points, offsets from the stroke's origin, canvas units
    float diffusion = 12.5f;          ///< D, unit²/s, (0, 1e12]
    float density = 9;                ///< φˢ, unit, [0, 1e12]
    float granulation = 1;            ///< ω, [0, 1]; 1 hides the paper, 0 shows it fully
    float maxAge = 1;                 ///< t_max, s, (0, 1e6]
    Microseconds born = 0;            ///< time of the segment's first sample
    Colour colour;                    ///< C, RYB and opacity
    std::optional<Style> style;       ///< if set, it replaces the stroke's style
    float anisotropyRatio = 1;        ///< D·ratio along the angle, D across it
    float anisotropyAngle = 0;        ///< radians, from the x axis towards the y axis
    NodeKind node = NodeKind::Smooth; ///< kind of the node at its start
    std::vector<Rewet> rewet;         ///< in order of time
    /// Whether the segment begins a new chain, so that it need not start where the one before it ends. A stroke's first
    /// segment begins a chain in any case, and has false here.
    bool start = false;
    /// Whether it takes density away: its own is subtracted from that of the segments that lay paint.
    bool lift = false;
    /// Whether it makes the stroke's paint paler: of the opacity e^−φ is left, φ the density of what fades. No segment
    /// both lifts and fades.
    bool fade = false;

    friend bool operator==(const Segment &, const Segment &) = default;

    /// Whether it takes paint away, in whichever way. Its colour, granulation and style then count for nothing.
    bool takesPaint() const { return lift || fade; }
    bool isIsotropic() const { return anisotropyRatio == 1; }

    /// The age t in seconds at document time T. Up to 0 the segment is not there yet.
    double age(Microseconds T) const
    {
        double t = std::min(toSeconds(T - born), double(maxAge));
        if (T >= born)
            for (const Rewet &r : rewet)
                t += toSeconds(std::min(std::max<Microseconds>(T - r.time, 0), r.extra));
        return t;
    }
    /// The time when it stops spreading. It is rounded up, so that from then on the age is t_max to the last bit.
    Microseconds driesAt() const
    {
        Microseconds end = born + Microseconds(std::ceil(double(maxAge) * 1e6));
        for (const Rewet &r : rewet)
            end = std::max(end, r.time + r.extra);
        return end;
    }
    /// The spread s = √(4Dt), canvas units; 0 at age 0. Of an anisotropic segment it is the spread across the tensor's
    /// angle.
    double spread(Microseconds T) const { return std::sqrt(4 * double(diffusion) * std::max(age(T), 0.0)); }
};

/// The control points as offsets from the stroke's origin, in double precision, which is exact.
inline Cubic offsetsOf(const Segment &segment)
{
    const auto &b = segment.bezier;
    return {{Point{} + b[0], Point{} + b[1], Point{} + b[2], Point{} + b[3]}};
}

} // namespace suffuse
