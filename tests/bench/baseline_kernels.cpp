// Compiled once per SIMD target by Highway's foreach_target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/baseline_kernels.cpp"
#define SUFFUSE_HIGHWAY
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include "hwy/foreach_target.h" // first: it includes this file again for each target

#include "hwy/highway.h"
#include "render/math/lanes-inl.h"
#include "tests/bench/baseline_kernels.h"
// After the lanes: templates over them.
#include "render/math/colour.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace suffuse::baseline::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using suffuse::HWY_NAMESPACE::exp2_;
using suffuse::HWY_NAMESPACE::Lanes;
using suffuse::HWY_NAMESPACE::log2_;
using suffuse::HWY_NAMESPACE::Tag;
using suffuse::HWY_NAMESPACE::Vec;

HWY_INLINE Lanes load(const float *p)
{
    return Lanes(hn::LoadU(Tag(), p));
}

HWY_INLINE void store(Lanes v, float *p)
{
    hn::StoreU(v.v, Tag(), p);
}

/// 2^x for x ≤ 127: the whole part from the low bits of x + 1.5·2²³, the rest a polynomial of degree 5.
HWY_INLINE Vec quickExp2(Vec x)
{
    const Tag d;
    const hn::RebindToSigned<Tag> di;
    x = hn::Max(x, hn::Set(d, -126.0f));
    const Vec magic = hn::Set(d, 12582912.0f);
    const Vec shifted = hn::Add(x, magic), f = hn::Sub(x, hn::Sub(shifted, magic));
    Vec p = hn::Set(d, 1.32647425e-3f);
    p = hn::MulAdd(p, f, hn::Set(d, 9.671518e-3f));
    p = hn::MulAdd(p, f, hn::Set(d, 5.55073376e-2f));
    p = hn::MulAdd(p, f, hn::Set(d, 2.4022242e-1f));
    p = hn::MulAdd(p, f, hn::Set(d, 6.93146978e-1f));
    p = hn::MulAdd(p, f, hn::Set(d, 1.0f));
    return hn::BitCast(d, hn::Add(hn::BitCast(di, p), hn::ShiftLeft<23>(hn::BitCast(di, shifted))));
}

template <int nodes>
HWY_INLINE void addNodes(const RowQuadrature &row, const float *colour, float *const *sums)
{
    const Tag d;
    const int lanes = int(hn::Lanes(d));
    const Vec scale = hn::Set(d, row.scale), last = hn::Set(d, float(row.last));
    Vec offset[nodes], exponent[nodes];
    for (int i = 0; i < nodes; ++i) {
        offset[i] = hn::Set(d, row.offset[i]);
        exponent[i] = hn::Set(d, row.exponent[i]);
    }
    const Vec iota = hn::Iota(d, 0.5f);
    for (int x = row.first; x < row.last; x += lanes) {
        const Vec centre = hn::Add(hn::Set(d, float(x)), iota);
        Vec sum = hn::Zero(d);
        for (int i = 0; i < nodes; ++i) {
            const Vec t = hn::MulAdd(centre, scale, offset[i]);
            sum = hn::Add(sum, quickExp2(hn::NegMulAdd(t, t, exponent[i])));
        }
        sum = hn::IfThenElseZero(hn::Lt(centre, last), sum);
        hn::StoreU(hn::Add(hn::LoadU(d, sums[0] + x), sum), d, sums[0] + x);
        if (colour)
            for (int c = 0; c < 4; ++c)
                hn::StoreU(hn::MulAdd(sum, hn::Set(d, colour[c]), hn::LoadU(d, sums[c + 1] + x)), d, sums[c + 1] + x);
    }
}

void addSegment(const RowQuadrature &row, const float *colour, float *const *sums)
{
    if (row.nodes == 5)
        addNodes<5>(row, colour, sums);
    else
        addNodes<8>(row, colour, sums);
}

/// Eq 17 to 19 with the edges that the renderer gives them, at the pixel's centre.
struct DensityFunction {
    StyleKind kind;
    Lanes xi1, xi2, xi3, steep, f0, gain, cut;

    explicit DensityFunction(const Style &s)
        : kind(s.kind), xi1(s.xi[0]), xi2(s.xi[1]), xi3(s.xi[2]), steep(1.44269504f / s.xi[1])
    {
        const float phi0 = std::max(0.0f, s.xi[0] - 8 * s.xi[1]), zero = 1 / (1 + std::exp((s.xi[0] - phi0) / s.xi[1]));
        f0 = Lanes(zero);
        gain = Lanes(1 / (1 - zero));
        if (kind == StyleKind::Edge) {
            const double r = std::pow(double(s.xi[1]) / s.xi[0], 3);
            const double q = (r + std::sqrt(r * r + 4 * (1 / double(s.xi[2]) - 1))) / 2;
            cut = Lanes(s.xi[0] * std::pow(q, -1.0 / 3));
        }
    }
    HWY_INLINE Lanes operator()(Lanes phi) const
    {
        const Lanes zero(0), one(1);
        if (kind == StyleKind::Uniform) {
            const Lanes f = one / (one + exp2_((xi1 - phi) * steep));
            return max_(zero, (f - f0) * gain);
        }
        const Lanes safe = max_(phi, Lanes(1e-10f));
        if (kind == StyleKind::Feathering)
            return min_(one, exp2_(xi2 * log2_(safe / xi1)));
        const Lanes u = xi1 / safe, v = xi2 / safe, u3 = u * u * u;
        const Lanes f = xi3 * (u3 * u3 - v * v * v + one);
        return select_(less_(phi, cut), zero, min_(one, max_(zero, f)));
    }
};

void mixStroke(const StrokeShade &shade, const float *const *sums, int first, int last, float *const *backdrop)
{
    const int lanes = int(hn::Lanes(Tag()));
    const DensityFunction densityFunction(shade.style);
    const Lanes keep(shade.keep);
    const float *constant[] = {&shade.colour.red, &shade.colour.yellow, &shade.colour.blue, &shade.colour.opacity};
    for (int x = first; x < last; x += lanes) {
        const Lanes phi = load(sums[0] + x), inverse = Lanes(1) / max_(phi, Lanes(1e-36f));
        Lanes colour[4];
        for (int c = 0; c < 4; ++c)
            colour[c] = shade.varies ? min_(Lanes(1), load(sums[c + 1] + x) * inverse) : Lanes(*constant[c]);
        const Lanes w = select_(less_(Lanes(0), phi), densityFunction(phi) * colour[3], Lanes(0));
        for (int c = 0; c < 3; ++c)
            store(suffuse::HWY_NAMESPACE::mixed(load(backdrop[c] + x), colour[c], w, keep), backdrop[c] + x);
    }
}

void finishRow(const float *const *backdrop, int width, float *rgba)
{
    const int lanes = int(hn::Lanes(Tag()));
    HWY_ALIGN float rgb[3][16];
    for (int x = 0; x < width; x += lanes) {
        const auto c =
            suffuse::HWY_NAMESPACE::rgbFromRyb(load(backdrop[0] + x), load(backdrop[1] + x), load(backdrop[2] + x));
        store(c.x, rgb[0]);
        store(c.y, rgb[1]);
        store(c.z, rgb[2]);
        for (int i = 0; i < std::min(lanes, width - x); ++i) {
            float *out = rgba + (x + i) * 4;
            out[0] = rgb[0][i], out[1] = rgb[1][i], out[2] = rgb[2][i], out[3] = 1;
        }
    }
}

/// One step down four vectors of columns: Thomas' algorithm with its factors known.
HWY_INLINE void stepColumns(float *grid, int stride, int vectors, int rows, const float *inverse, const float *upper)
{
    const Tag d;
    const int lanes = int(hn::Lanes(d));
    Vec before[4] = {hn::Zero(d), hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    for (int y = 0; y < rows; ++y) {
        float *line = grid + std::ptrdiff_t(y) * stride;
        const Vec scale = hn::Set(d, inverse[y]), down = hn::Set(d, upper[y]);
        for (int v = 0; v < vectors; ++v) {
            before[v] = hn::MulAdd(before[v], down, hn::Mul(hn::LoadU(d, line + v * lanes), scale));
            hn::StoreU(before[v], d, line + v * lanes);
        }
    }
    for (int y = rows - 2; y >= 0; --y) { // `before` holds the last row
        float *line = grid + std::ptrdiff_t(y) * stride;
        const Vec down = hn::Set(d, upper[y]);
        for (int v = 0; v < vectors; ++v) {
            before[v] = hn::MulAdd(before[v], down, hn::LoadU(d, line + v * lanes));
            hn::StoreU(before[v], d, line + v * lanes);
        }
    }
}

void diffuseColumns(float *grid, int stride, int columns, int rows, float r, int steps, float *factors)
{
    // (1 + 2r)u_y − r(u_(y−1) + u_(y+1)) = rhs.
    float *inverse = factors, *upper = factors + rows;
    float before = 0;
    for (int y = 0; y < rows; ++y) {
        inverse[y] = 1 / (1 + 2 * r - r * before);
        before = upper[y] = r * inverse[y];
    }
    const int lanes = int(hn::Lanes(Tag()));
    for (int x = 0; x < columns; x += 4 * lanes) {
        const int vectors = std::min(4, (columns - x + lanes - 1) / lanes);
        for (int step = 0; step < steps; ++step)
            stepColumns(grid + x, stride, vectors, rows, inverse, upper);
    }
}

long long multiplyAdds(long long rounds, float *sink)
{
    const Tag d;
    constexpr int chains = 12;
    Vec sum[chains];
    for (int i = 0; i < chains; ++i)
        sum[i] = hn::Set(d, float(i));
    const Vec a = hn::Set(d, 0.999f + *sink), b = hn::Set(d, 1e-3f);
    for (long long round = 0; round < rounds; ++round)
        for (int i = 0; i < chains; ++i)
            sum[i] = hn::MulAdd(sum[i], a, b);
    for (int i = 1; i < chains; ++i)
        sum[0] = hn::Add(sum[0], sum[i]);
    *sink = hn::GetLane(sum[0]);
    return rounds * chains * (long long)hn::Lanes(d);
}

BaselineKernels table()
{
    return {hwy::TargetName(HWY_TARGET), addSegment, mixStroke, finishRow, diffuseColumns, multiplyAdds};
}

} // namespace suffuse::baseline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace suffuse::baseline {
HWY_EXPORT(table);

const BaselineKernels &baselineKernels()
{
    static const BaselineKernels kernels = HWY_DYNAMIC_DISPATCH(table)();
    return kernels;
}

} // namespace suffuse::baseline

#endif
