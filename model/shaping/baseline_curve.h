// Lengths along a chain of curves, and the chains along which texts stand.
#pragma once

#include "model/geometry/affine.h"
#include "model/painting/stroke.h"

#include <optional>
#include <vector>

namespace suffuse {

/// A chain of cubics by the length along it.
class BaselineCurve {
public:
    explicit BaselineCurve(const std::vector<Cubic> &curves);

    double length() const { return m_at.empty() ? 0 : m_at.back().length; }
    struct Place {
        Point point;
        Point direction{1, 0}; ///< of length 1
    };
    /// The place at a length along the chain; before its start and behind its end on a straight line.
    Place at(double length) const;
    /// The length near another one at which a point lies straight beside the chain. Of a corner's outer side it is the
    /// corner's.
    double besides(Point point, double near) const;
    /// The chain from one length along it to another, both within it.
    std::vector<Cubic> between(double from, double to) const;
    /// The lengths at which a part of it begins and ends, if it is one: as far as a thousandth of its extent.
    std::optional<std::pair<double, double>> endsOf(const BaselineCurve &part) const;

private:
    struct Step {
        double length = 0;
        std::size_t curve = 0;
        double t = 0;
    };
    Place placeOn(std::size_t curve, double t) const;
    Step stepAt(double length) const;

    std::vector<Cubic> m_curves; ///< those that have a length
    std::vector<Step> m_at;
};

/// The first chain of a stroke, canvas units: what a text on it follows. It is empty where a text cannot have it, since
/// it has more than `Text::mostCurves` curves.
std::vector<Cubic> baselineOf(const Stroke &stroke);
std::vector<Cubic> mapped(std::vector<Cubic> curves, const Affine &map);
/// Whether two chains are the same: within what float32 can tell, or, where they are divided otherwise, within a
/// thousandth of their extent.
bool isSameCurve(const std::vector<Cubic> &a, const std::vector<Cubic> &b);

} // namespace suffuse
