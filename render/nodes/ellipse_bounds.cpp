// Highway's foreach_target compiles this file once for each SIMD instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/nodes/ellipse_bounds.cpp"
// Vectors have at most eight floats here, so these instruction sets would bring nothing.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3 | HWY_AVX3_DL)
#include "hwy/foreach_target.h" // It comes first, since it includes this file again for each set.

#include "hwy/highway.h"
#include "render/nodes/ellipse_bounds.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

// The tables are the same for every instruction set.
#ifndef SUFFUSE_ELLIPSE_TABLES
#define SUFFUSE_ELLIPSE_TABLES
namespace suffuse::ellipse {

constexpr int points = 16;
constexpr int padded = 24; ///< ellipseCount rounded up to whole vectors

/// Holds the Bernstein basis at the points of one ellipse: imaginary parts for the curve, and both parts for its
/// derivative.
struct alignas(32) Basis {
    float curve[4][points];
    float real[3][points];
    float imag[3][points];
};

/// Holds bounds of the Chebyshev polynomials on all ellipses: |Im T_k| ≤ (ρ^k − ρ^−k)/2 and |T_k| ≤ (ρ^k + ρ^−k)/2.
struct alignas(32) Chebyshev {
    float imaginary[3][padded]; // k = 1 … 3
    float whole[2][padded];     // k = 1, 2
    float remainder[padded];    // −ln(1 − ρ⁻²)
    float perNode[padded];      // 1 / (2 ln ρ)
};

} // namespace suffuse::ellipse
#endif

HWY_BEFORE_NAMESPACE();
namespace suffuse::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<float, 8>;
using Vec = hn::Vec<Tag>;
constexpr Tag tag;
// Products and sums are rounded one by one. Where a machine fused them into one instruction, its nodes would differ
// from those of others.

HWY_INLINE Vec product(Vec a, Vec b, Vec c)
{
    return hn::Mul(hn::Mul(a, b), c);
}

/// Returns Σ w[i]·v[i] for i < 3, added in order.
HWY_INLINE Vec sum(const Vec *w, const Vec *v)
{
    return hn::Add(hn::Add(hn::Mul(w[0], v[0]), hn::Mul(w[1], v[1])), hn::Mul(w[2], v[2]));
}

float leastNodes(const ellipse::Chebyshev &bounds, const EvenCurve &curve, float logAllowed)
{
    const auto vec = [](float v) { return hn::Set(tag, v); };
    const Vec one = vec(1), none = vec(1e30f);
    Vec best = none;
    for (int e = 0; e < ellipseCount; e += int(hn::Lanes(tag))) {
        const Vec im1 = hn::Load(tag, bounds.imaginary[0] + e), im2 = hn::Load(tag, bounds.imaginary[1] + e);
        // On the ellipse Im c = Σ c_k (ρ^k − ρ^−k)/2 sin kθ, and |sin θ sin 2θ| ≤ 0.77.
        const Vec a = hn::Mul(vec(curve.first), im1), b = hn::Mul(vec(curve.second), im2);
        const Vec aa = hn::Mul(a, a), bb = product(vec(4), b, b), both = hn::Add(aa, bb);
        const Vec mixed = hn::Div(product(vec(0.25f), both, both), hn::Add(bb, vec(1e-30f)));
        const Vec apart = hn::IfThenElse(hn::Ge(aa, bb), aa, mixed);
        const Vec crossed = product(vec(1.54f * curve.crossed), im1, im2);
        const Vec lift = hn::Add(hn::Sqrt(hn::Add(apart, crossed)),
                                 hn::Mul(vec(curve.third), hn::Load(tag, bounds.imaginary[2] + e)));
        // g′·g′ is the product of x′ ± iy′. Neither has a root where the rest r is less than the constant coefficient
        // d, and there ln|g′| ≤ ln d + ln(1 + r/d).
        const Vec rest = hn::Add(hn::Mul(vec(curve.rest1), hn::Load(tag, bounds.whole[0] + e)),
                                 hn::Mul(vec(curve.rest2), hn::Load(tag, bounds.whole[1] + e)));
        const Vec r = hn::Mul(rest, vec(curve.perSpeed));
        const Vec gain = hn::Mul(r, hn::Sub(one, hn::Mul(r, hn::Sub(vec(0.5f), hn::Div(r, vec(3))))));
        const Vec remainder = hn::Load(tag, bounds.remainder + e);
        const Vec bound = hn::Add(hn::Add(hn::Add(hn::Mul(lift, lift), gain), remainder), vec(logAllowed));
        const Vec nodes = hn::Mul(bound, hn::Load(tag, bounds.perNode + e));
        best = hn::Min(best, hn::IfThenElse(hn::Lt(r, vec(0.97f)), nodes, none));
    }
    return hn::GetLane(hn::MinOfLanes(tag, best));
}

void sampleEllipse(const ellipse::Basis &basis, const CurveDifferences &curve, float &growth, float &speed)
{
    Vec x[3], y[3], dx[3], dy[3];
    for (int i = 0; i < 3; ++i) {
        x[i] = hn::Set(tag, curve.x[i + 1]), y[i] = hn::Set(tag, curve.y[i + 1]);
        dx[i] = hn::Set(tag, curve.dx[i]), dy[i] = hn::Set(tag, curve.dy[i]);
    }
    Vec greatestLift = hn::Zero(tag), greatestSpeed = hn::Zero(tag);
    for (int k = 0; k < ellipse::points; k += int(hn::Lanes(tag))) {
        Vec c[3], re[3], im[3];
        for (int i = 0; i < 3; ++i) {
            c[i] = hn::Load(tag, basis.curve[i + 1] + k);
            re[i] = hn::Load(tag, basis.real[i] + k), im[i] = hn::Load(tag, basis.imag[i] + k);
        }
        const Vec ix = sum(c, x), iy = sum(c, y);
        const Vec xr = sum(re, dx), xi = sum(im, dx), yr = sum(re, dy), yi = sum(im, dy);
        const Vec real = hn::Sub(hn::Add(hn::Sub(hn::Mul(xr, xr), hn::Mul(xi, xi)), hn::Mul(yr, yr)), hn::Mul(yi, yi));
        const Vec imag = hn::Mul(hn::Set(tag, 2), hn::Add(hn::Mul(xr, xi), hn::Mul(yr, yi)));
        greatestLift = hn::Max(greatestLift, hn::Add(hn::Mul(ix, ix), hn::Mul(iy, iy)));
        greatestSpeed = hn::Max(greatestSpeed, hn::Add(hn::Mul(real, real), hn::Mul(imag, imag)));
    }
    growth = hn::GetLane(hn::MaxOfLanes(tag, greatestLift));
    speed = hn::GetLane(hn::MaxOfLanes(tag, greatestSpeed));
}

} // namespace suffuse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace suffuse {

HWY_EXPORT(leastNodes);
HWY_EXPORT(sampleEllipse);

namespace {

using Complex = std::complex<double>;

std::array<ellipse::Basis, ellipseCount> makeBasis()
{
    std::array<ellipse::Basis, ellipseCount> all;
    for (std::size_t e = 0; e < all.size(); ++e)
        for (int k = 0; k < ellipse::points; ++k) {
            const double angle = std::numbers::pi * k / (ellipse::points - 1);
            const Complex w = 0.5 * (std::polar(ellipseRadii[e], angle) + std::polar(1 / ellipseRadii[e], -angle));
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

ellipse::Chebyshev makeChebyshev()
{
    ellipse::Chebyshev all;
    for (int e = 0; e < ellipse::padded; ++e) {
        const double rho = ellipseRadii[std::size_t(std::min(e, ellipseCount - 1))];
        for (int k = 1; k <= 3; ++k)
            all.imaginary[k - 1][e] = float(0.5 * (std::pow(rho, k) - std::pow(rho, -k)));
        for (int k = 1; k <= 2; ++k)
            all.whole[k - 1][e] = float(0.5 * (std::pow(rho, k) + std::pow(rho, -k)));
        all.remainder[e] = float(-std::log(1 - 1 / (rho * rho)));
        all.perNode[e] = float(0.5 / std::log(rho));
    }
    return all;
}

} // namespace

float nodesOfEvenCurve(const EvenCurve &curve, float logAllowed)
{
    static const ellipse::Chebyshev bounds = makeChebyshev();
    return HWY_DYNAMIC_DISPATCH(leastNodes)(bounds, curve, logAllowed);
}

int sampleEllipses(const CurveDifferences &curve, int count, float (&growth)[ellipseCount],
                   float (&speed)[ellipseCount])
{
    static const std::array<ellipse::Basis, ellipseCount> basis = makeBasis();
    const auto sample = HWY_DYNAMIC_DISPATCH(sampleEllipse);
    for (int e = 0; e < count; ++e) {
        sample(basis[std::size_t(e)], curve, growth[e], speed[e]);
        if (!(growth[e] < 1e4f)) // On larger ellipses it only grows. The test also ends the loop on overflow.
            return e;
    }
    return count;
}

} // namespace suffuse
#endif
