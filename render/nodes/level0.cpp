#include "render/nodes/level0.h"

#include "render/nodes/ellipse_bounds.h"

#include <algorithm>
#include <complex>
#include <numbers>

namespace suffuse {

namespace {

using Complex = std::complex<double>;

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

// The bound is sampled at 16 points of the (symmetric) half ellipse. This factor covers what lies between them.
constexpr double samplingSlack = 1.1;

double bernsteinRadius(Complex z)
{
    const Complex w = 2.0 * z - 1.0, q = std::sqrt(w * w - 1.0);
    return std::sqrt(std::max(std::norm(w + q), std::norm(w - q)));
}

// |g′| is analytic inside the ellipse that passes through the nearest root of g′·g′ = (x′ + iy′)(x′ − iy′).
double analyticRadius(const Cubic &g)
{
    const auto asComplex = [](Point p) { return Complex(p.x, p.y); };
    const Complex d0 = asComplex(g.p[1] - g.p[0]), d1 = asComplex(g.p[2] - g.p[1]), d2 = asComplex(g.p[3] - g.p[2]);
    const Complex a = d0, b = 2.0 * (d1 - d0), c = d0 - 2.0 * d1 + d2; // g′/3 = a + bz + cz²
    const double size = std::abs(d0) + std::abs(d1) + std::abs(d2);
    if (std::abs(c) > 1e-12 * size) {
        const Complex root = std::sqrt(b * b - 4.0 * a * c);
        return std::min(bernsteinRadius((-b + root) / (2.0 * c)), bernsteinRadius((-b - root) / (2.0 * c)));
    }
    return std::abs(b) > 1e-12 * size ? bernsteinRadius(-a / b) : 1e9;
}

/// Writes a cubic about its middle as m1 u + m2 u² + m3 u³ and a constant, u = 2z − 1.
struct Centred {
    Point m1, m2, m3;

    explicit Centred(const Cubic &c)
    {
        const Point a1 = 3 * (c.p[1] - c.p[0]), a2 = 3 * ((c.p[2] - c.p[1]) - (c.p[1] - c.p[0]));
        const Point a3 = (c.p[3] - c.p[0]) - 3 * (c.p[2] - c.p[1]);
        m1 = 0.5 * a1 + 0.5 * a2 + 0.375 * a3;
        m2 = 0.25 * a2 + 0.375 * a3;
        m3 = 0.125 * a3;
    }
};

float lengthOf(Point p)
{
    return float(std::sqrt(dot(p, p)));
}

/// Returns the number of nodes that the bound demands (not rounded), with its maxima bounded by Chebyshev coefficients.
/// It is close if the curve is nearly straight and even, and ten times faster than sampling. 1e30 means that nothing
/// can be said.
float nodesIfNearlyStraight(const Cubic &whitened, const Cubic &metric, float target)
{
    const Centred c(whitened), g(metric);
    const Point first = c.m1 + 0.75 * c.m3, second = 0.5 * c.m2; // Chebyshev coefficients
    const float speed = 2 * lengthOf(g.m1 + 1.5 * g.m3);
    if (!(speed > 1e-20f && speed < 1e20f))
        return 1e30f;
    EvenCurve curve;
    curve.first = lengthOf(first), curve.second = lengthOf(second), curve.third = 0.25f * lengthOf(c.m3);
    curve.crossed = float(std::abs(dot(first, second)));
    curve.rest1 = 4 * lengthOf(g.m2), curve.rest2 = 3 * lengthOf(g.m3);
    curve.perSpeed = 1 / speed;
    return nodesOfEvenCurve(curve, std::log(speed) - target);
}

/// Returns the number of nodes by sampling the maxima of the bound, or 0 if it is more than maxPanelNodes.
int sampledNodes(const Cubic &whitened, const Cubic &metric, double target)
{
    CurveDifferences curve;
    for (int i = 0; i < 4; ++i) {
        // Relative to the first point, float differences keep their digits.
        curve.x[i] = float(whitened.p[i].x - whitened.p[0].x);
        curve.y[i] = float(whitened.p[i].y - whitened.p[0].y);
    }
    for (int i = 0; i < 3; ++i) {
        curve.dx[i] = float(metric.p[i + 1].x - metric.p[i].x);
        curve.dy[i] = float(metric.p[i + 1].y - metric.p[i].y);
    }
    const double radius = 0.97 * analyticRadius(metric);
    const auto within = std::ranges::find_if(ellipseRadii, [&](double rho) { return !(rho < radius); });
    // The bound needs the maximum of a product; the maxima of |Im c|² and |g′·g′|², taken separately, bound it.
    float growth[ellipseCount], speed[ellipseCount];
    const int count = sampleEllipses(curve, int(within - ellipseRadii.begin()), growth, speed);
    double best = 1e300;
    for (int e = 0; e < count; ++e) {
        const double rho = ellipseRadii[std::size_t(e)];
        const double bound = growth[e] + 0.25 * std::log(double(speed[e]) + 1e-300) - std::log(1 - 1 / (rho * rho));
        // n nodes are enough if bound − 2n ln ρ ≤ target.
        best = std::min(best, (bound - target) / (2 * std::log(rho)));
    }
    if (best > maxPanelNodes)
        return 0;
    return std::max(1, int(std::ceil(best)));
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

int panelNodes(const Cubic &whitened, const Cubic &metric, double tolerance)
{
    const double allowed = std::log(tolerance * std::sqrt(std::numbers::pi) * 15 / 32);
    constexpr float few = 8, rounding = 1e-3f;
    if (const float n = nodesIfNearlyStraight(whitened, metric, float(allowed)) + rounding; n <= few)
        return std::max(1, int(std::ceil(n)));
    return sampledNodes(whitened, metric, allowed - std::log(samplingSlack));
}
} // namespace suffuse
