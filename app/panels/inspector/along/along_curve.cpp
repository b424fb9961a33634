#include "app/panels/inspector/along/along_curve.h"

#include "model/restyling/profile.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace suffuse {

void ValueAxis::include(double value)
{
    constexpr double below = 0.5; // by this factor `low` stands below the values, so that none of them is taken for 0
    const bool isZero = logarithmic && value <= 0;
    if (isZero && !std::exchange(endsInZero, true))
        low *= below;
    else if (!isZero && endsInZero && value <= low)
        low = below * value;
    else if (!isZero)
        low = std::min(low, value);
    high = std::max(high, value);
}

double ValueAxis::toShare(double value) const
{
    if (endsInZero && value <= 0)
        return reversed ? 1 : 0;
    const double v = std::clamp(value, low, high);
    const double share = logarithmic ? std::log(v / low) / std::log(high / low) : (v - low) / (high - low);
    return reversed ? 1 - share : share;
}

double ValueAxis::toValue(double place) const
{
    const double share = reversed ? 1 - place : place;
    if (endsInZero && share <= 0)
        return 0;
    return std::clamp(logarithmic ? low * std::pow(high / low, share) : std::lerp(low, high, share), low, high);
}

double CurveAlong::valueAt(double place, double old) const
{
    constexpr double least = 1e-9; // Curves that differ by rounding are the same.
    const double now = curve.at(place), drawn = from ? curve.drawnAt(place) : 1;
    const double change = from ? now - from->at(place) : 0;
    const bool multiplies = axis.logarithmic && drawn == 0; // which leaves a 0
    if (drawn == 0 && (std::abs(change) < least || (multiplies && old <= 0)))
        return old;
    return axis.toValue(std::lerp(axis.toShare(old) + change, now, drawn));
}

bool CurveAlong::varies() const
{
    if (!from)
        return std::ranges::any_of(curve.knots, [&](double k) { return k != curve.knots.front(); });
    if (curve.places != from->places || curve.knots.size() != from->knots.size() || curve.drawn != from->drawn)
        return true;
    // The same change all along is exact on segments of any length.
    const double change = curve.knots.front() - from->knots.front();
    for (std::size_t i = 0; i < curve.knots.size(); ++i)
        if (std::abs(curve.knots[i] - from->knots[i] - change) > 1e-9)
            return true;
    return false;
}

void CurveAlong::growAxis(double value)
{
    ValueAxis grown = axis;
    grown.include(value);
    const auto move = [&](PlaceCurve &moved) {
        for (double &k : moved.knots)
            k = grown.toShare(axis.toValue(k));
    };
    move(curve);
    if (from)
        move(*from);
    axis = grown;
}

void CurveAlong::change(const ValueChange &change)
{
    growAxis(change.applied(axis.high));
    growAxis(change.applied(axis.low));
    for (double &k : curve.knots)
        k = axis.toShare(change.applied(axis.toValue(k)));
}

PlaceCurve pointsThrough(const std::vector<Point> &points, double drawn)
{
    PlaceCurve curve;
    curve.knots.clear();
    for (const Point &p : points) {
        curve.places.push_back(p.x);
        curve.knots.push_back(p.y);
    }
    curve.drawn = {drawn};
    return curve;
}

PlaceCurve drawnThrough(const std::vector<Point> &points, double drawn)
{
    PlaceCurve curve = pointsThrough(points, drawn);
    curve.places.clear();
    curve.drawn.assign(points.size(), drawn);
    return curve;
}

PlaceCurve presentCurve(const StrokeRuns &runs, Quantity quantity, const ValueAxis &axis)
{
    constexpr std::size_t mostRuns = 200;
    constexpr double tolerance = 0.015;
    std::vector<std::vector<Point>> shares;
    for (const auto &[id, run] : runs) {
        if (shares.size() == mostRuns)
            break;
        shares.emplace_back();
        for (const RunPlace &p : run.places)
            shares.back().push_back(
                {p.place, axis.toShare(double(valueOf(run.stroke->segments[std::size_t(p.segment)], quantity)))});
    }
    return pointsThrough(simplifiedProfile(sampledProfile(shares, CurveEditor::drawnKnots), tolerance), 0);
}

} // namespace suffuse
