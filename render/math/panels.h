// How many Gauss-Legendre nodes a piece of a cubic needs (docs/solver.md, "Nodes"), once for host and device. Both get
// the same bits: there are only products, sums, quotients and square roots, each rounded by itself, and a logarithm
// made of them. The header is C++17, since .cu files include it.
#pragma once

#include "render/math/compat.h"

#include <cmath>
#include <cstdint>
#include <cstring>

/// Marks functions that are called from many places, so that a kernel's code fits the instruction cache.
#ifdef __CUDACC__
#define SUFFUSE_SHARED inline __host__ __device__ __noinline__
#else
#define SUFFUSE_SHARED inline
#endif

namespace suffuse::panels {

/// One rule has at most this many nodes. A panel is a piece of a curve that gets one rule.
inline constexpr int mostNodes = 10;
/// The bound is tried on so many Bernstein ellipses.
inline constexpr int ellipses = 17;
inline constexpr int paddedEllipses = 24; ///< the same, rounded up to whole vectors
inline constexpr int ellipsePoints = 16;  ///< on each ellipse
/// A piece that was halved so often is not halved again.
inline constexpr int mostHalvings = 40;

/// Holds the Bernstein basis at the points of one ellipse: imaginary parts for the curve, and both parts for its
/// derivative.
struct alignas(32) EllipseBasis {
    float curve[4][ellipsePoints];
    float real[3][ellipsePoints];
    float imag[3][ellipsePoints];
};

/// Holds bounds of the Chebyshev polynomials on all ellipses: |Im T_k| ≤ (ρ^k − ρ^−k)/2 and |T_k| ≤ (ρ^k + ρ^−k)/2.
struct alignas(32) ChebyshevBounds {
    float imaginary[3][paddedEllipses]; // k = 1 … 3
    float whole[2][paddedEllipses];     // k = 1, 2
    float remainder[paddedEllipses];    // −ln(1 − ρ⁻²)
    float perNode[paddedEllipses];      // 1 / (2 ln ρ)
};

/// Holds what is the same for all curves. The host makes it once.
struct Tables {
    EllipseBasis basis[ellipses];
    ChebyshevBounds bounds;
    double radius[ellipses];            ///< the size ρ of each ellipse
    double remainder[ellipses];         ///< ln(1 − ρ⁻²)
    double perNode[ellipses];           ///< 2 ln ρ
    double x[mostNodes + 1][mostNodes]; ///< the rule of each number of nodes on [0, 1]
    double weight[mostNodes + 1][mostNodes];
};

/// Returns the natural logarithm of a finite number > 0, exact to some units in the last place.
SUFFUSE_SHARED double logarithm(double v)
{
    std::uint64_t bits = 0;
    std::memcpy(&bits, &v, sizeof bits);
    int exponent = int(bits >> 52) - 1023;
    bits = (bits & 0x000fffffffffffff) | 0x3ff0000000000000;
    double m = 0;
    std::memcpy(&m, &bits, sizeof m);
    if (m > 1.4142135623730951)
        m *= 0.5, ++exponent;
    const double f = (m - 1) / (m + 1), s = f * f; // ln m = 2 artanh f, |f| ≤ 0.172
    const double s2 = s * s, s4 = s2 * s2;         // Sums that do not wait for each other are quicker.
    const double low = (1.0 / 3 + s * (1.0 / 5)) + s2 * (1.0 / 7 + s * (1.0 / 9));
    const double high = (1.0 / 11 + s * (1.0 / 13)) + s2 * (1.0 / 15 + s * (1.0 / 17));
    const double p = low + s4 * (high + s4 * (1.0 / 19));
    return exponent * 0.6931471805599453 + (2 * f + 2 * f * s * p);
}

struct Vector {
    double x, y;
};
SUFFUSE_INLINE Vector operator+(Vector a, Vector b)
{
    return {a.x + b.x, a.y + b.y};
}
SUFFUSE_INLINE Vector operator-(Vector a, Vector b)
{
    return {a.x - b.x, a.y - b.y};
}
SUFFUSE_INLINE Vector operator*(double k, Vector a)
{
    return {k * a.x, k * a.y};
}
SUFFUSE_INLINE double product(Vector a, Vector b)
{
    return a.x * b.x + a.y * b.y;
}
SUFFUSE_INLINE double size(Vector a)
{
    return std::sqrt(product(a, a));
}

/// Holds the control points of a cubic.
struct Curve {
    Vector a, b, c, d;
};
SUFFUSE_INLINE Vector pointAt(const Curve &s, double t)
{
    const double u = 1 - t;
    return (u * u * u) * s.a + (3 * u * u * t) * s.b + (3 * u * t * t) * s.c + (t * t * t) * s.d;
}
SUFFUSE_INLINE Vector derivativeAt(const Curve &s, double t)
{
    const double u = 1 - t;
    return (3 * u * u) * (s.b - s.a) + (6 * u * t) * (s.c - s.b) + (3 * t * t) * (s.d - s.c);
}
/// Returns the first or the second half of a curve.
SUFFUSE_INLINE Curve halfOf(const Curve &s, bool second)
{
    const Vector a = 0.5 * s.a + 0.5 * s.b, m = 0.5 * s.b + 0.5 * s.c, b = 0.5 * s.c + 0.5 * s.d;
    const Vector am = 0.5 * a + 0.5 * m, mb = 0.5 * m + 0.5 * b, q = 0.5 * am + 0.5 * mb;
    return second ? Curve{q, mb, b, s.d} : Curve{s.a, a, am, q};
}
/// Returns the curve relative to a point, in units of 1/scale.
SUFFUSE_INLINE Curve scaledFrom(const Curve &s, Vector from, double scale)
{
    return {scale * (s.a - from), scale * (s.b - from), scale * (s.c - from), scale * (s.d - from)};
}
SUFFUSE_SHARED double sumOfSides(const Curve &s)
{
    return size(s.b - s.a) + size(s.c - s.b) + size(s.d - s.c);
}

/// Describes a curve that is nearly straight and evenly drawn by the magnitudes of Chebyshev coefficients, in spreads.
struct EvenCurve {
    float first, second, third; ///< those of the curve
    float crossed;              ///< |c₁ · c₂|, where c₁ and c₂ are the first two as vectors
    float rest1, rest2;         ///< those of the derivative g′ of its measure, but for the constant one
    float perSpeed;             ///< 1 divided by the constant coefficient of g′
};

/// Returns the number of nodes, not rounded, that the bound demands on one ellipse if the maxima are bounded by
/// Chebyshev coefficients. 1e30 means that nothing can be said.
SUFFUSE_INLINE float evenNodesOn(const ChebyshevBounds &bounds, int e, const EvenCurve &curve, float logAllowed)
{
    const float im1 = bounds.imaginary[0][e], im2 = bounds.imaginary[1][e];
    // On the ellipse Im c = Σ c_k (ρ^k − ρ^−k)/2 sin kθ, and |sin θ sin 2θ| ≤ 0.77.
    const float a = curve.first * im1, b = curve.second * im2;
    const float aa = a * a, bb = 4 * b * b, both = aa + bb;
    const float apart = aa >= bb ? aa : 0.25f * both * both / (bb + 1e-30f);
    const float crossed = 1.54f * curve.crossed * im1 * im2;
    const float lift = std::sqrt(apart + crossed) + curve.third * bounds.imaginary[2][e];
    // g′·g′ is the product of x′ ± iy′. Neither has a root where the rest r is less than the constant coefficient d,
    // and there ln|g′| ≤ ln d + ln(1 + r/d).
    const float rest = curve.rest1 * bounds.whole[0][e] + curve.rest2 * bounds.whole[1][e];
    const float r = rest * curve.perSpeed;
    const float gain = r * (1 - r * (0.5f - r / 3));
    const float bound = ((lift * lift + gain) + bounds.remainder[e]) + logAllowed;
    return r < 0.97f ? bound * bounds.perNode[e] : 1e30f;
}

/// Holds the control points of a cubic relative to the first one, which is left out, and the differences between the
/// control points of the curve g whose speed |g′| is the measure, in spreads.
struct Differences {
    float x1, y1, x2, y2, x3, y3;
    float dx0, dy0, dx1, dy1, dx2, dy2;
};

/// Raises `lift` and `speed` to |Im c|² and |g′·g′|² at a point of an ellipse.
SUFFUSE_INLINE void sampleAt(const EllipseBasis &basis, int k, const Differences &s, float &lift, float &speed)
{
    const auto sum = [](float w0, float v0, float w1, float v1, float w2, float v2) {
        return w0 * v0 + w1 * v1 + w2 * v2;
    };
    const float c0 = basis.curve[1][k], c1 = basis.curve[2][k], c2 = basis.curve[3][k];
    const float r0 = basis.real[0][k], r1 = basis.real[1][k], r2 = basis.real[2][k];
    const float i0 = basis.imag[0][k], i1 = basis.imag[1][k], i2 = basis.imag[2][k];
    const float ix = sum(c0, s.x1, c1, s.x2, c2, s.x3), iy = sum(c0, s.y1, c1, s.y2, c2, s.y3);
    const float xr = sum(r0, s.dx0, r1, s.dx1, r2, s.dx2), xi = sum(i0, s.dx0, i1, s.dx1, i2, s.dx2);
    const float yr = sum(r0, s.dy0, r1, s.dy1, r2, s.dy2), yi = sum(i0, s.dy0, i1, s.dy1, i2, s.dy2);
    const float real = ((xr * xr - xi * xi) + yr * yr) - yi * yi, imag = 2 * (xr * xi + yr * yi);
    const float here = ix * ix + iy * iy, fast = real * real + imag * imag;
    lift = lift > here ? lift : here;
    speed = speed > fast ? speed : fast;
}

// Complex numbers are vectors here.
SUFFUSE_INLINE Vector times(Vector a, Vector b)
{
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}
SUFFUSE_INLINE Vector over(Vector a, Vector b)
{
    const double square = product(b, b);
    return {(a.x * b.x + a.y * b.y) / square, (a.y * b.x - a.x * b.y) / square};
}
SUFFUSE_INLINE Vector rootOf(Vector a)
{
    const double length = size(a);
    const double x = length + a.x > 0 ? std::sqrt(0.5 * (length + a.x)) : 0;
    const double y = length - a.x > 0 ? std::sqrt(0.5 * (length - a.x)) : 0;
    return {x, a.y < 0 ? -y : y};
}
/// Returns the size of the Bernstein ellipse through a point.
SUFFUSE_SHARED double ellipseThrough(Vector z)
{
    const Vector w{2 * z.x - 1, 2 * z.y}, square = times(w, w), q = rootOf({square.x - 1, square.y});
    const Vector sum = w + q, rest = w - q;
    const double a = product(sum, sum), b = product(rest, rest);
    return std::sqrt(a > b ? a : b);
}

/// Returns the size of the ellipse in which |g′| is analytic, which passes through the nearest root of g′·g′ =
/// (x′ + iy′)(x′ − iy′).
SUFFUSE_SHARED double analyticRadius(const Curve &g)
{
    const Vector d0 = g.b - g.a, d1 = g.c - g.b, d2 = g.d - g.c;
    const Vector a = d0, b = 2.0 * (d1 - d0), c = d0 - 2.0 * d1 + d2; // g′/3 = a + bz + cz²
    const double all = size(d0) + size(d1) + size(d2);
    if (size(c) > 1e-12 * all) {
        const Vector root = rootOf(times(b, b) - 4.0 * times(a, c)), minus{-b.x, -b.y};
        const double first = ellipseThrough(over(minus + root, 2.0 * c)),
                     second = ellipseThrough(over(minus - root, 2.0 * c));
        return first < second ? first : second;
    }
    return size(b) > 1e-12 * all ? ellipseThrough(over({-a.x, -a.y}, b)) : 1e9;
}

/// Returns what describes the curve if it is nearly straight and even, and in `speed` the constant coefficient of g′.
SUFFUSE_SHARED EvenCurve evenCurve(const Curve &whitened, const Curve &metric, float &speed)
{
    // A cubic about its middle is m1 u + m2 u² + m3 u³ and a constant, u = 2z − 1.
    const auto centred = [](const Curve &c, Vector &m1, Vector &m2, Vector &m3) {
        const Vector a1 = 3 * (c.b - c.a), a2 = 3 * ((c.c - c.b) - (c.b - c.a));
        const Vector a3 = (c.d - c.a) - 3 * (c.c - c.b);
        m1 = 0.5 * a1 + 0.5 * a2 + 0.375 * a3;
        m2 = 0.25 * a2 + 0.375 * a3;
        m3 = 0.125 * a3;
    };
    Vector c1{}, c2{}, c3{}, g1{}, g2{}, g3{};
    centred(whitened, c1, c2, c3);
    centred(metric, g1, g2, g3);
    const Vector first = c1 + 0.75 * c3, second = 0.5 * c2; // Chebyshev coefficients
    speed = 2 * float(size(g1 + 1.5 * g3));
    EvenCurve curve{};
    curve.first = float(size(first)), curve.second = float(size(second)), curve.third = 0.25f * float(size(c3));
    curve.crossed = float(std::fabs(product(first, second)));
    curve.rest1 = 4 * float(size(g2)), curve.rest2 = 3 * float(size(g3));
    curve.perSpeed = 1 / speed;
    return curve;
}

/// Returns ln(tolerance · √π · 15/32).
SUFFUSE_INLINE double allowedOf(double tolerance)
{
    return logarithm(tolerance * 1.7724538509055161 * 15 / 32);
}

/// Returns a number of nodes that is enough for a piece, 0 if it is more than mostNodes, or −1 if only samples can
/// tell. `even` finds the least of evenNodesOn over all ellipses.
template <class Even>
SUFFUSE_INLINE int quickNodes(const Curve &whitened, const Curve &metric, double tolerance, Even even)
{
    // The coarsest tolerance asks for twelve nodes on a straight line of eight spreads, and for more if it is no line.
    if (const Vector chord = metric.d - metric.a; product(chord, chord) > 64)
        return 0;
    const double allowed = allowedOf(tolerance);
    constexpr float hopeless = 14, rounding = 1e-3f;
    float speed = 0;
    const EvenCurve curve = evenCurve(whitened, metric, speed);
    if (!(speed > 1e-20f && speed < 1e20f))
        return -1;
    const float n = even(curve, float(logarithm(double(speed))) - float(allowed)) + rounding;
    if (n <= mostNodes)
        return n > 1 ? int(std::ceil(n)) : 1;
    return n > hopeless && n < 1e20f ? 0 : -1; // 1e30 says nothing.
}

/// Returns what is to be sampled of a piece.
SUFFUSE_INLINE Differences differencesOf(const Curve &whitened, const Curve &metric)
{
    // Relative to the first point, float differences keep their digits.
    const Vector p1 = whitened.b - whitened.a, p2 = whitened.c - whitened.a, p3 = whitened.d - whitened.a;
    const Vector d0 = metric.b - metric.a, d1 = metric.c - metric.b, d2 = metric.d - metric.c;
    return {float(p1.x), float(p1.y), float(p2.x), float(p2.y), float(p3.x), float(p3.y),
            float(d0.x), float(d0.y), float(d1.x), float(d1.y), float(d2.x), float(d2.y)};
}

/// Tells whether the maxima on an ellipse count. On larger ones than one where they do not, they only grow.
SUFFUSE_INLINE bool isWithin(const Tables &tables, int e, double radius, float lift)
{
    return tables.radius[e] < 0.97 * radius && lift < 1e4f;
}

/// Returns the number of nodes, not rounded, that the bound demands with the maxima of sampleAt on an ellipse. It needs
/// the maximum of a product; the maxima of |Im c|² and |g′·g′|², taken separately, bound it.
SUFFUSE_INLINE double sampledNodesOn(const Tables &tables, int e, float lift, float speed, double allowed)
{
    // The factor 1.1 covers what lies between the samples of the (symmetric) half ellipse.
    const double target = allowed - 0.09531017980432487;
    const double bound = double(lift) + 0.25 * logarithm(double(speed) + 1e-300) - tables.remainder[e];
    return (bound - target) / tables.perNode[e]; // n nodes are enough if bound − 2n ln ρ ≤ target.
}

/// Returns what quickNodes does, of the least of sampledNodesOn.
SUFFUSE_INLINE int roundedNodes(double best)
{
    if (!(best <= mostNodes))
        return 0;
    return best > 1 ? int(std::ceil(best)) : 1;
}

/// Returns a number n for which n nodes integrate e^(−|x − c(p)|²) |g′(p)| over [0, 1] to within tolerance · √π at
/// every x, by the Bernstein-ellipse bound, or 0 if more than mostNodes are needed. `whitened` is the curve in
/// coordinates in which the Gaussian is e^(−r²) (canvas / s if isotropic). `metric` is the curve whose speed |g′| is
/// the measure, in the same scale (equal to `whitened` if isotropic). `sample` finds the maxima of sampleAt on an
/// ellipse.
template <class Even, class Sample>
SUFFUSE_INLINE int nodesOf(const Curve &whitened, const Curve &metric, double tolerance, const Tables &tables,
                           Even even, Sample sample)
{
    if (const int quick = quickNodes(whitened, metric, tolerance, even); quick >= 0)
        return quick;
    const double allowed = allowedOf(tolerance);
    const Differences s = differencesOf(whitened, metric);
    const double radius = analyticRadius(metric);
    double best = 1e300;
    for (int e = 0; e < ellipses && isWithin(tables, e, radius, 0); ++e) {
        float lift = 0, fast = 0;
        sample(tables.basis[e], s, lift, fast);
        if (!isWithin(tables, e, radius, lift))
            break;
        const double n = sampledNodesOn(tables, e, lift, fast, allowed);
        best = n < best ? n : best;
    }
    return roundedNodes(best);
}

/// Says which piece of a segment is looked at: pieces are halves of halves.
struct Place {
    std::uint64_t path = 0; ///< which halves lead to it: its last `depth` bits, the first halving first
    int depth = 0;

    SUFFUSE_SHARED Curve piece(const Curve &segment) const
    {
        Curve out = segment;
        for (int d = depth; d-- > 0;)
            out = halfOf(out, (path >> d & 1) != 0);
        return out;
    }
    SUFFUSE_INLINE double tolerance(double whole) const
    {
        for (int d = 0; d < depth; ++d)
            whole = whole / 2;
        return whole;
    }
    /// Goes to the first half of the piece.
    SUFFUSE_INLINE void halve() { ++depth, path <<= 1; }
    /// Goes to what follows the piece. Returns false if nothing does.
    SUFFUSE_INLINE bool next()
    {
        while (depth > 0 && (path & 1))
            --depth, path >>= 1;
        if (depth == 0)
            return false;
        path |= 1;
        return true;
    }
};

/// Tells whether any rule is good enough for a piece (of a cusp), as it is so short that all its mass counts for less
/// than the tolerance. Such a piece gets `anyRule` nodes.
SUFFUSE_INLINE bool isTiny(const Curve &metric, double tolerance)
{
    return 2 * sumOfSides(metric) < tolerance * 1.7724538509055161;
}
inline constexpr int anyRule = 4;

} // namespace suffuse::panels
