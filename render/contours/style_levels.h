// At which densities a style reaches a coverage: F backwards.
#pragma once

#include "model/painting/style.h"

#include <array>
#include <vector>

namespace suffuse::contours {

/// F of one style with its slope, quicker than model/paint has it.
class CoverageCurve {
public:
    explicit CoverageCurve(const Style &style);

    struct Value {
        double coverage = 0, slope = 0;
    };
    Value at(double density) const;

private:
    StyleKind m_kind;
    std::array<double, 3> m_xi;
    double m_start; ///< below it F is 0
    double m_lowest = 0;
};

/// From a density on, a coverage (until the next one).
struct CoverageStep {
    double density = 0;
    double coverage = 0;
};

/// The densities at which F comes to a level or leaves it, by turns and ascending. At jumps that is where it jumps.
std::vector<double> crossingsOf(const Style &style, double level);

/// F in steps of 1/count, each as far as F is nearer to it than to others: from each density on, the coverage.
std::vector<CoverageStep> stepsOf(const Style &style, int count);

} // namespace suffuse::contours
