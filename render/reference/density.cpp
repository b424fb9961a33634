#include "render/reference/density.h"

#include "render/reference/quadrature.h"

#include <cmath>
#include <numbers>

namespace suffuse::reference {

namespace {

constexpr double sqrtPi = 1.7724538509055160273;

/// ∫ e^(−|q|²)|c′| dp and ∫ q e^(−|q|²)|c′| dp, q = A(x − c).
struct Moments {
    double zeroth = 0;
    Point first;
};

Moments operator+(const Moments &a, const Moments &b)
{
    return {a.zeroth + b.zeroth, a.first + b.first};
}

double distanceToOrigin(const Rect &r)
{
    const double x = std::max({r.left, -r.right, 0.0});
    const double y = std::max({r.top, -r.bottom, 0.0});
    return std::hypot(x, y);
}

/// A piece of the curve: `plain` for |c′|, and `q` = A(x − c) for the exponent.
struct Piece {
    Cubic plain;
    Cubic q;

    void addAt(double p, double weight, Moments &sum) const
    {
        const Point d = q.at(p);
        const double f = weight * std::exp(-dot(d, d)) * length(plain.derivative(p));
        sum.zeroth += f;
        sum.first = sum.first + f * d;
    }
};

Moments integrate(const Piece &piece, double tolerance, int depth)
{
    if (distanceToOrigin(piece.q.controlBox()) > adaptiveReach)
        return {};
    const bool last = depth >= 60;
    if (last || polygonLength(piece.q) <= 2) {
        Moments kronrod, gauss;
        const KronrodRule &rule = kronrod15();
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            for (int side = i == 0 ? 1 : -1; side <= 1; side += 2) {
                const double p = 0.5 * (1 + side * rule.nodes[i]);
                piece.addAt(p, 0.5 * rule.weights[i], kronrod);
                piece.addAt(p, 0.5 * rule.gaussWeights[i], gauss);
            }
        }
        const double error = std::abs(kronrod.zeroth - gauss.zeroth) + length(kronrod.first - gauss.first);
        if (last || error <= tolerance)
            return kronrod;
    }
    const auto plain = piece.plain.split(0.5);
    const auto q = piece.q.split(0.5);
    return integrate({plain[0], q[0]}, tolerance, depth + 1) + integrate({plain[1], q[1]}, tolerance, depth + 1);
}

/// The root of a polynomial (coefficients from the constant up) in (lo, hi), where it changes its sign.
double bisect(const std::array<double, 4> &f, double lo, double hi)
{
    const auto value = [&f](double p) { return f[0] + p * (f[1] + p * (f[2] + p * f[3])); };
    const bool rising = value(hi) > 0;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (lo + hi);
        if (middle <= lo || middle >= hi)
            break;
        ((value(middle) > 0) == rising ? hi : lo) = middle;
    }
    return 0.5 * (lo + hi);
}

} // namespace

Kernel isotropicKernel(double s)
{
    return {1 / s, 0, 0, 1 / s, 1 / (std::numbers::pi * s * s), s, s, true};
}

Kernel anisotropicKernel(double s, double ratio, double angle)
{
    const double along = s * std::sqrt(ratio);
    const double c = std::cos(angle), n = std::sin(angle);
    Kernel k{c / along, n / along, -n / s, c / s, 1 / (std::numbers::pi * along * s), 0, 0, false};
    k.smallerSpread = std::min(s, along);
    k.largerSpread = std::max(s, along);
    return k;
}

std::vector<double> speedExtrema(const Cubic &cubic)
{
    // c′ = ap² + bp + c (up to the factor 3), so c′·c″ is a cubic polynomial in p.
    const auto &p = cubic.p;
    const Point c = p[1] - p[0];
    const Point b = 2.0 * (p[2] - p[1]) - 2.0 * c;
    const Point a = (p[3] - p[2]) - 2.0 * (p[2] - p[1]) + c;
    const std::array<double, 4> f{dot(b, c), dot(b, b) + 2 * dot(a, c), 3 * dot(a, b), 2 * dot(a, a)};

    // Between its own extrema f is monotonic.
    std::vector<double> marks{0};
    const double qa = 3 * f[3], qb = 2 * f[2], qc = f[1];
    const double discriminant = qb * qb - 4 * qa * qc;
    if (discriminant > 0) {
        const double q = -0.5 * (qb + std::copysign(std::sqrt(discriminant), qb));
        for (double root : {q != 0 ? qc / q : -1, qa != 0 ? q / qa : -1})
            if (root > 0 && root < 1)
                marks.push_back(root);
        std::sort(marks.begin(), marks.end());
    }
    marks.push_back(1);

    const auto value = [&f](double t) { return f[0] + t * (f[1] + t * (f[2] + t * f[3])); };
    std::vector<double> roots;
    for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
        const double lo = value(marks[i]), hi = value(marks[i + 1]);
        if ((lo < 0 && hi > 0) || (lo > 0 && hi < 0))
            roots.push_back(bisect(f, marks[i], marks[i + 1]));
        else if (hi == 0 && marks[i + 1] < 1)
            roots.push_back(marks[i + 1]);
    }
    return roots;
}

std::vector<Cubic> piecesBetweenSpeedExtrema(const Cubic &cubic)
{
    std::vector<Cubic> pieces;
    Cubic rest = cubic;
    double start = 0;
    for (double root : speedExtrema(cubic)) {
        const auto halves = rest.split((root - start) / (1 - start));
        pieces.push_back(halves[0]);
        rest = halves[1];
        start = root;
    }
    pieces.push_back(rest);
    return pieces;
}

DensityAndGradient segmentDensity(const Cubic &cubic, const Kernel &kernel, double density, Point x)
{
    const double tolerance = 1e-14 * sqrtPi * kernel.smallerSpread;
    Moments sum;
    for (const Cubic &plain : piecesBetweenSpeedExtrema(cubic)) {
        Cubic q;
        for (int i = 0; i < 4; ++i)
            q.p[std::size_t(i)] = kernel.whiten(x - plain.p[std::size_t(i)]);
        sum = sum + integrate({plain, q}, tolerance, 0);
    }
    const double factor = density * kernel.norm;
    const Point m = sum.first;
    return {factor * sum.zeroth,
            -2 * factor * Point{kernel.a11 * m.x + kernel.a21 * m.y, kernel.a12 * m.x + kernel.a22 * m.y}};
}

double segmentDensity(const Cubic &cubic, double s, double density, Point x)
{
    return segmentDensity(cubic, isotropicKernel(s), density, x).density;
}

Point segmentDensityGradient(const Cubic &cubic, double s, double density, Point x)
{
    return segmentDensity(cubic, isotropicKernel(s), density, x).gradient;
}

double erfDifference(double a, double b)
{
    if (a > 0 && b > 0)
        return std::erfc(b) - std::erfc(a);
    if (a < 0 && b < 0)
        return std::erfc(-a) - std::erfc(-b);
    return std::erf(a) - std::erf(b);
}

double straightDensity(double length, double s, double density, double u, double v)
{
    return density / (2 * sqrtPi * s) * std::exp(-v * v / (s * s)) * erfDifference(u / s, (u - length) / s);
}

double rampDensity(double length, double s, double density, double slope, double u, double v)
{
    const double e = erfDifference(u / s, (u - length) / s);
    const double x = std::exp(-u * u / (s * s)) - std::exp(-(u - length) * (u - length) / (s * s));
    return std::exp(-v * v / (s * s)) / (std::numbers::pi * s * s) *
           ((density + slope * u) * (s * sqrtPi / 2) * e + slope * (s * s / 2) * x);
}

double straightDensity(Point a, Point b, const Kernel &kernel, double density, Point x)
{
    // In whitened space the segment is straight, too, and the spread is 1. Lengths along it shrink by one factor.
    const double plainLength = length(b - a);
    const Point end = kernel.whiten(b - a);
    const Point d = kernel.whiten(x - a);
    const double whiteLength = length(end);
    if (plainLength == 0)
        return 0;
    const double u = dot(d, end) / whiteLength, v = cross(end, d) / whiteLength;
    return density * kernel.norm * (plainLength / whiteLength) * (sqrtPi / 2) * std::exp(-v * v) *
           erfDifference(u, u - whiteLength);
}

} // namespace suffuse::reference
