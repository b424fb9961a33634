#include "render/nodes/level0.h"

#include "render/nodes/ellipse_bounds.h"

#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

QuadratureRule makeRule(int n)
{
    QuadratureRule rule;
    for (int i = 0; i < n; ++i) {
        long double z = std::cos(std::numbers::pi_v<long double> * (i + 0.75L) / (n + 0.5L)), slope = 1;
        for (int step = 0; step < 60; ++step) {
            long double before = 1, p = z;
            for (int k = 2; k <= n; ++k) {
                const long double next = ((2 * k - 1) * z * p - (k - 1) * before) / k;
                before = p;
                p = next;
            }
            slope = n * (z * p - before) / (z * z - 1);
            const long double dz = p / slope;
            z -= dz;
            if (std::fabs(dz) < 1e-19L)
                break;
        }
        // The points ascend in x, while z descends.
        rule.x[n - 1 - i] = double(0.5L * (1 + z));
        rule.weight[n - 1 - i] = double(1 / ((1 - z * z) * slope * slope));
    }
    return rule;
}

} // namespace

const QuadratureRule &gaussLegendre(int n)
{
    static const auto rules = [] {
        std::array<QuadratureRule, maxPanelNodes + 1> all;
        for (int i = 1; i <= maxPanelNodes; ++i)
            all[i] = makeRule(i);
        return all;
    }();
    return rules[n];
}

int panelNodes(const panels::Curve &whitened, const panels::Curve &metric, double tolerance)
{
    return panels::nodesOf(whitened, metric, tolerance, panelTables(), nodesOfEvenCurve, sampleEllipse);
}

} // namespace suffuse
