#include "render/level0.h"

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
        // Ascending in x.
        rule.x[n - 1 - i] = double(0.5L * (1 + z));
        rule.weight[n - 1 - i] = double(1 / ((1 - z * z) * slope * slope));
    }
    return rule;
}

constexpr int ellipses = 17, points = 16;
constexpr std::array<double, ellipses> rho{1.15, 1.3, 1.5, 1.75, 2,  2.4, 2.9, 3.5, 4.2,
                                           5,    6,   7.5, 9.5,  12, 16,  22,  30};
// The bound is sampled at 16 points of the (symmetric) half ellipse; this covers what lies between them.
constexpr double samplingSlack = 1.1;

// Bernstein basis on the points of each ellipse: imaginary parts for the curve, both parts for its derivative.
struct EllipseBasis {
    float curve[4][points];
    float real[3][points];
    float imag[3][points];
};

std::array<EllipseBasis, ellipses> makeBasis()
{
    std::array<EllipseBasis, ellipses> all;
    for (int e = 0; e < ellipses; ++e)
        for (int k = 0; k < points; ++k) {
            const double angle = std::numbers::pi * k / (points - 1);
            const Complex w = 0.5 * (std::polar(rho[e], angle) + std::polar(1 / rho[e], -angle));
            const Complex z = 0.5 * (w + 1.0), u = 1.0 - z;
            const Complex c[4] = {u * u * u, 3.0 * u * u * z, 3.0 * u * z * z, z * z * z};
            const Complex d[3] = {3.0 * u * u, 6.0 * u * z, 3.0 * z * z};
            for (int i = 0; i < 4; ++i)
                all[e].curve[i][k] = float(c[i].imag());
            for (int i = 0; i < 3; ++i) {
                all[e].real[i][k] = float(d[i].real());
                all[e].imag[i][k] = float(d[i].imag());
            }
        }
    return all;
}

double bernsteinRadius(Complex z)
{
    const Complex w = 2.0 * z - 1.0, q = std::sqrt(w * w - 1.0);
    return std::max(std::abs(w + q), std::abs(w - q));
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

/// Bounds of Chebyshev polynomials on the ellipses: |Im T_k| ≤ (ρ^k − ρ^−k)/2, |T_k| ≤ (ρ^k + ρ^−k)/2.
struct ChebyshevBounds {
    float imaginary[3][ellipses]; // k = 1 … 3
    float whole[2][ellipses];     // k = 1, 2
    float remainder[ellipses];    // −ln(1 − ρ⁻²)
    float perNode[ellipses];      // 1 / (2 ln ρ)
};

ChebyshevBounds makeChebyshevBounds()
{
    ChebyshevBounds all;
    for (int e = 0; e < ellipses; ++e) {
        for (int k = 1; k <= 3; ++k)
            all.imaginary[k - 1][e] = float(0.5 * (std::pow(rho[e], k) - std::pow(rho[e], -k)));
        for (int k = 1; k <= 2; ++k)
            all.whole[k - 1][e] = float(0.5 * (std::pow(rho[e], k) + std::pow(rho[e], -k)));
        all.remainder[e] = float(-std::log(1 - 1 / (rho[e] * rho[e])));
        all.perNode[e] = float(0.5 / std::log(rho[e]));
    }
    return all;
}

/// A cubic about its middle: m1 u + m2 u² + m3 u³, u = 2z − 1.
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

float norm(Point p)
{
    return float(std::sqrt(dot(p, p)));
}

/// Nodes that the bound asks for (not rounded) with its maxima bounded by Chebyshev coefficients: close where the curve
/// is nearly straight and even, and an order of magnitude faster than sampling. 1e30: nothing can be said.
float nodesIfNearlyStraight(const Cubic &whitened, const Cubic &metric, float target)
{
    static const ChebyshevBounds bounds = makeChebyshevBounds();
    const Centred c(whitened), g(metric);
    const Point first = c.m1 + 0.75 * c.m3, second = 0.5 * c.m2; // Chebyshev coefficients
    const float c1 = norm(first), c2 = norm(second), c12 = float(std::abs(dot(first, second))), c3 = 0.25f * norm(c.m3);
    const float d0 = 2 * norm(g.m1 + 1.5 * g.m3), d1 = 4 * norm(g.m2), d2 = 3 * norm(g.m3);
    if (!(d0 > 1e-20f && d0 < 1e20f))
        return 1e30f;
    const float logSpeed = std::log(d0) - target, perSpeed = 1 / d0;
    float best = 1e30f;
    for (int e = 0; e < ellipses; ++e) {
        // Im c = Σ c_k (ρ^k − ρ^−k)/2 sin kθ on the ellipse; |sin θ sin 2θ| ≤ 0.77.
        const float a = c1 * bounds.imaginary[0][e], b = c2 * bounds.imaginary[1][e], aa = a * a, bb = 4 * b * b;
        const float apart = aa >= bb ? aa : 0.25f * (aa + bb) * (aa + bb) / (bb + 1e-30f);
        const float crossed = 1.54f * c12 * bounds.imaginary[0][e] * bounds.imaginary[1][e];
        const float lift = std::sqrt(apart + crossed) + c3 * bounds.imaginary[2][e];
        // g′·g′ is the product of x′ ± iy′, neither of which has a root where the rest r is less than the constant d;
        // and ln|g′| ≤ ln d + ln(1 + r/d).
        const float r = (d1 * bounds.whole[0][e] + d2 * bounds.whole[1][e]) * perSpeed;
        const float nodes =
            (lift * lift + r * (1 - r * (0.5f - r / 3)) + bounds.remainder[e] + logSpeed) * bounds.perNode[e];
        best = std::min(best, r < 0.97f ? nodes : 1e30f);
    }
    return best;
}

/// Nodes by sampling the bound's maxima; 0: more than maxPanelNodes.
int sampledNodes(const Cubic &whitened, const Cubic &metric, double target)
{
    static const std::array<EllipseBasis, ellipses> basis = makeBasis();
    float x[4], y[4], dx[3], dy[3];
    for (int i = 0; i < 4; ++i) {
        // From the first point: float differences keep their digits.
        x[i] = float(whitened.p[i].x - whitened.p[0].x);
        y[i] = float(whitened.p[i].y - whitened.p[0].y);
    }
    for (int i = 0; i < 3; ++i) {
        dx[i] = float(metric.p[i + 1].x - metric.p[i].x);
        dy[i] = float(metric.p[i + 1].y - metric.p[i].y);
    }
    const double radius = 0.97 * analyticRadius(metric);
    double best = 1e300;
    for (int e = 0; e < ellipses && rho[e] < radius; ++e) {
        const EllipseBasis &b = basis[e];
        float growth = 0, speed = 0; // max |Im c|², max |g′·g′|²: their product bounds the maximum
        for (int k = 0; k < points; ++k) {
            const float ix = b.curve[1][k] * x[1] + b.curve[2][k] * x[2] + b.curve[3][k] * x[3];
            const float iy = b.curve[1][k] * y[1] + b.curve[2][k] * y[2] + b.curve[3][k] * y[3];
            const float xr = b.real[0][k] * dx[0] + b.real[1][k] * dx[1] + b.real[2][k] * dx[2];
            const float xi = b.imag[0][k] * dx[0] + b.imag[1][k] * dx[1] + b.imag[2][k] * dx[2];
            const float yr = b.real[0][k] * dy[0] + b.real[1][k] * dy[1] + b.real[2][k] * dy[2];
            const float yi = b.imag[0][k] * dy[0] + b.imag[1][k] * dy[1] + b.imag[2][k] * dy[2];
            const float re = xr * xr - xi * xi + yr * yr - yi * yi, im = 2 * (xr * xi + yr * yi);
            growth = std::max(growth, ix * ix + iy * iy);
            speed = std::max(speed, re * re + im * im);
        }
        if (!(growth < 1e4f)) // larger ellipses only grow; also stops on overflow
            break;
        const double bound = growth + 0.25 * std::log(double(speed) + 1e-300) - std::log(1 - 1 / (rho[e] * rho[e]));
        // n nodes suffice when bound − 2n ln ρ ≤ target.
        best = std::min(best, (bound - target) / (2 * std::log(rho[e])));
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
