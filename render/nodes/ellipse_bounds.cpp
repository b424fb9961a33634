// Highway's foreach_target compiles this file once for each SIMD instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/nodes/ellipse_bounds.cpp"
// Vectors have at most eight floats here, so these instruction sets would bring nothing.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3 | HWY_AVX3_DL)
#include "hwy/foreach_target.h" // It comes first, since it includes this file again for each set.

#include "hwy/highway.h"
#include "render/nodes/ellipse_bounds.h"
#include "render/nodes/level0.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

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

float leastNodes(const panels::ChebyshevBounds &bounds, const panels::EvenCurve &curve, float logAllowed)
{
    const auto vec = [](float v) { return hn::Set(tag, v); };
    const Vec one = vec(1), none = vec(1e30f);
    Vec best = none;
    for (int e = 0; e < panels::ellipses; e += int(hn::Lanes(tag))) {
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

void greatestOn(const panels::EllipseBasis &basis, const panels::Differences &curve, float &growth, float &speed)
{
    const auto all = [](float v) { return hn::Set(tag, v); };
    const Vec x[3] = {all(curve.x1), all(curve.x2), all(curve.x3)},
              y[3] = {all(curve.y1), all(curve.y2), all(curve.y3)};
    const Vec dx[3] = {all(curve.dx0), all(curve.dx1), all(curve.dx2)};
    const Vec dy[3] = {all(curve.dy0), all(curve.dy1), all(curve.dy2)};
    Vec greatestLift = hn::Zero(tag), greatestSpeed = hn::Zero(tag);
    for (int k = 0; k < panels::ellipsePoints; k += int(hn::Lanes(tag))) {
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
HWY_EXPORT(greatestOn);

namespace {

using Complex = std::complex<double>;

constexpr std::array<double, panels::ellipses> radii{1.15, 1.3, 1.5, 1.75, 2,  2.4, 2.9, 3.5, 4.2,
                                                     5,    6,   7.5, 9.5,  12, 16,  22,  30};

void fillBasis(double radius, panels::EllipseBasis &basis)
{
    for (int k = 0; k < panels::ellipsePoints; ++k) {
        const double angle = std::numbers::pi * k / (panels::ellipsePoints - 1);
        const Complex w = 0.5 * (std::polar(radius, angle) + std::polar(1 / radius, -angle));
        const Complex z = 0.5 * (w + 1.0), u = 1.0 - z;
        const Complex c[4] = {u * u * u, 3.0 * u * u * z, 3.0 * u * z * z, z * z * z};
        const Complex d[3] = {3.0 * u * u, 6.0 * u * z, 3.0 * z * z};
        for (int i = 0; i < 4; ++i)
            basis.curve[i][k] = float(c[i].imag());
        for (int i = 0; i < 3; ++i) {
            basis.real[i][k] = float(d[i].real());
            basis.imag[i][k] = float(d[i].imag());
        }
    }
}

void fillBounds(panels::ChebyshevBounds &all)
{
    for (int e = 0; e < panels::paddedEllipses; ++e) {
        const double rho = radii[std::size_t(std::min(e, panels::ellipses - 1))];
        for (int k = 1; k <= 3; ++k)
            all.imaginary[k - 1][e] = float(0.5 * (std::pow(rho, k) - std::pow(rho, -k)));
        for (int k = 1; k <= 2; ++k)
            all.whole[k - 1][e] = float(0.5 * (std::pow(rho, k) + std::pow(rho, -k)));
        all.remainder[e] = float(-std::log(1 - 1 / (rho * rho)));
        all.perNode[e] = float(0.5 / std::log(rho));
    }
}

panels::Tables makeTables()
{
    panels::Tables tables{};
    fillBounds(tables.bounds);
    for (int e = 0; e < panels::ellipses; ++e) {
        const double rho = radii[std::size_t(e)];
        fillBasis(rho, tables.basis[e]);
        tables.radius[e] = rho;
        tables.remainder[e] = std::log(1 - 1 / (rho * rho));
        tables.perNode[e] = 2 * std::log(rho);
    }
    for (int n = 1; n <= panels::mostNodes; ++n) {
        const QuadratureRule &rule = gaussLegendre(n);
        std::ranges::copy(rule.x, tables.x[n]);
        std::ranges::copy(rule.weight, tables.weight[n]);
    }
    return tables;
}

} // namespace

const panels::Tables &panelTables()
{
    static const panels::Tables tables = makeTables();
    return tables;
}

float nodesOfEvenCurve(const panels::EvenCurve &curve, float logAllowed)
{
    return HWY_DYNAMIC_DISPATCH(leastNodes)(panelTables().bounds, curve, logAllowed);
}

void sampleEllipse(const panels::EllipseBasis &basis, const panels::Differences &curve, float &lift, float &speed)
{
    HWY_DYNAMIC_DISPATCH(greatestOn)(basis, curve, lift, speed);
}

} // namespace suffuse
#endif
