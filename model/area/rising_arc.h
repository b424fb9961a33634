// A part of a curve along which y rises and x never turns.
#pragma once

#include "model/geometry/geometry.h"

#include <vector>

namespace suffuse {

/// A cubic with p[0].y < p[3].y along which both coordinates are monotone, so that each height is met once.
struct RisingArc {
    Cubic curve;

    double top() const { return curve.p[0].y; }
    double bottom() const { return curve.p[3].y; }
    double left() const { return std::min(curve.p[0].x, curve.p[3].x); }
    double right() const { return std::max(curve.p[0].x, curve.p[3].x); }
    Rect box() const { return {left(), top(), right(), bottom()}; }

    /// The parameter where the arc is at a height within it, and its x there.
    double parameterAtY(double y) const;
    double xAt(double y) const { return xAtParameter(parameterAtY(y)); }
    double xAtParameter(double t) const;
    /// The parameter where the arc is at an x within it.
    double parameterAtX(double x) const;
};

/// The chord of an arc, which says most often on which side of the arc a place is, without a search for it.
class ArcChord {
public:
    explicit ArcChord(const RisingArc &arc);
    /// At a height of the arc: −1 if it is surely left of x by more than `near`, +1 if it is right of it so, else 0.
    int sideOf(double x, double y, double near) const
    {
        const double off = xAt(y) - x, most = m_bend + near;
        return off < -most ? -1 : off > most ? 1 : 0;
    }
    /// Whether the arcs surely do not meet between two heights, within both.
    bool isApartFrom(const ArcChord &other, double top, double bottom) const
    {
        const auto off = [&](double y) { return xAt(y) - other.xAt(y); };
        const double first = off(top), last = off(bottom), most = m_bend + other.m_bend;
        return (first > most && last > most) || (first < -most && last < -most);
    }

private:
    double xAt(double y) const { return m_x + m_slope * (y - m_y); }

    double m_x, m_y, m_slope = 0;
    double m_bend; ///< how far the arc is from its chord at most, in x at the same height, rounding included
};

/// The parts of a curve between its turns in x and y that have a height, in its order. `falls` says of each whether the
/// curve goes down it, from its end to its begin.
struct RisingPart {
    RisingArc arc;
    bool falls = false;
};
void appendRisingParts(const Cubic &curve, std::vector<RisingPart> &out);

/// The part of a curve between two parameters.
Cubic between(const Cubic &curve, double from, double to);

} // namespace suffuse
