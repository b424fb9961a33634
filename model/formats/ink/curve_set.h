// Diffusion curves (Orzan et al. 2008) as they stand in the XML of their authors' program.
#pragma once

#include "model/geometry/geometry.h"
#include "model/result.h"

#include <QByteArray>

#include <algorithm>
#include <array>
#include <vector>

namespace suffuse {

/// The positions of colours and blurs ("globalID") count tenths of a cubic.
inline constexpr double curveStopsPerCubic = 10;

/// sRGB-encoded R, G, B in [0, 1].
using CurveColour = std::array<double, 3>;

inline double mixedStops(double a, double b, double t)
{
    return a + t * (b - a);
}
inline CurveColour mixedStops(const CurveColour &a, const CurveColour &b, double t)
{
    return {mixedStops(a[0], b[0], t), mixedStops(a[1], b[1], t), mixedStops(a[2], b[2], t)};
}

/// Values at positions along a curve. Between them they are linear, beyond the first and the last one constant.
template <typename Value>
class CurveStops {
public:
    void add(double place, Value value) { m_stops.push_back({place, value}); }
    bool empty() const { return m_stops.empty(); }
    /// To be called when all have been added.
    void sort()
    {
        std::stable_sort(m_stops.begin(), m_stops.end(),
                         [](const auto &a, const auto &b) { return a.place < b.place; });
    }
    /// There must be one at least.
    Value at(double place) const
    {
        const auto after =
            std::partition_point(m_stops.begin(), m_stops.end(), [&](const auto &stop) { return stop.place < place; });
        if (after == m_stops.begin())
            return m_stops.front().value;
        if (after == m_stops.end())
            return m_stops.back().value;
        const auto before = after - 1;
        return mixedStops(before->value, after->value, (place - before->place) / (after->place - before->place));
    }

private:
    struct Stop {
        double place;
        Value value;
    };
    std::vector<Stop> m_stops;
};

/// A chain of cubics with colours along both of its sides. Who walks along it, and looks at it with y pointing down,
/// has the left colours at the left hand.
struct DiffusionCurve {
    std::vector<Point> points;           ///< 3n + 1 control points, pixels
    CurveStops<CurveColour> left, right; ///< one at least on each side
    CurveStops<double> blur;             ///< standard deviation of the blur, pixels, ≥ 0; may be empty

    double blurAt(double place) const { return blur.empty() ? 0 : blur.at(place); }
};

struct CurveSet {
    double width = 0, height = 0; ///< of the picture, pixels
    std::vector<DiffusionCurve> curves;
};

/// Reads the curves of a file. Errors name the file and the line. Sizes are those of the file, whatever they are.
Result<CurveSet> readCurveSet(const QByteArray &bytes, const QString &fileName);

} // namespace suffuse
