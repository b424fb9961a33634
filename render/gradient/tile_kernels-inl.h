// The loops of tile_data.h over pixels: what strokes show, and the way back through that. V holds one or more pixels
// of a row. docs/solver.md, "The gradient of the picture".
#if defined(SUFFUSE_RENDER_GRADIENT_TILE_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_GRADIENT_TILE_KERNELS_INL_H
#undef SUFFUSE_RENDER_GRADIENT_TILE_KERNELS_INL_H
#else
#define SUFFUSE_RENDER_GRADIENT_TILE_KERNELS_INL_H
#endif

#include "render/gradient/node_kernels-inl.h"
#include "render/math/colour_slopes.h"
#include "render/math/style_slopes.h"

#include <algorithm>

SUFFUSE_MATH_BEGIN
namespace suffuse::SUFFUSE_MATH {

using namespace suffuse::gradient;

template <class V, class Number>
void addValues(Source source, const TileNode<Number> *nodes, int count, const double *value, ValueTile<Number> &to)
{
    using P = Pixels<V>;
    alignas(64) Number density[tileSize];
    densityOf<V>(source, nodes, count, density);
    for (int at = 0; at < tileSize; at += P::count()) {
        const V d = P::load(density + at);
        for (int i = 0; i < values; ++i)
            P::store(mulAdd_(d, V(Number(value[i])), P::load(to.sums[i] + at)), to.sums[i] + at);
        P::store(P::load(to.sums[values] + at) + d, to.sums[values] + at);
    }
}

template <class V, class Number>
void fade(const TileNode<Number> *nodes, int count, Number *left)
{
    using P = Pixels<V>;
    densityOf<V>(Source::Segment, nodes, count, left);
    for (int at = 0; at < tileSize; at += P::count())
        P::store(exp2_(V(-log2e) * P::load(left + at)), left + at);
}

/// Means of values lie in [0, 1] but for rounding, and outside of fills, where errors are all that is left of φ⁺.
inline constexpr double leastValue = -1e-3, mostValue = 1 + 1e-3;

/// What a stroke is made of at some pixels.
template <class V>
struct PixelPaint {
    V phi, square;   // φ′ and h²
    V gamma, plain;  // γ, and h² without it
    V laid, inverse; // φ⁺ and 1/φ⁺ where values vary
    V value[values]; // R, Y, B, opacity, ω
    V left;          // e^(−φ_f)

    SUFFUSE_INLINE PixelPaint() {} // It is compiled for the target, while the implicit one is not.
};

template <class V, class Number>
SUFFUSE_INLINE PixelPaint<V> paintAt(const Shading<Number> &how, const StrokeTile<Number> &stroke,
                                     const ValueTile<Number> *varying, const Number *eta, int at)
{
    using P = Pixels<V>;
    PixelPaint<V> p;
    p.phi = P::load(stroke.sums[0] + at);
    p.left = how.fades ? P::load(stroke.left + at) : V(1);
    const V gx = P::load(stroke.sums[1] + at), gy = P::load(stroke.sums[2] + at);
    p.plain = p.square = mulAdd_(gx, gx, gy * gy);
    p.laid = p.inverse = V(0);
    for (int i = 0; i < values; ++i)
        p.value[i] = V(how.constant[i]);
    if (varying) {
        p.laid = P::load(varying->sums[values] + at);
        p.inverse = reciprocal_(max_(p.laid, V(how.leastLaid)));
        for (int i = 0; i < values; ++i)
            p.value[i] = min_(max_(P::load(varying->sums[i] + at) * p.inverse, V(leastValue)), V(mostValue));
    }
    p.gamma = V(1);
    if (eta) {
        const V omega = p.value[values - 1];
        p.gamma = mulAdd_(V(1) - omega, P::load(eta + at), omega);
        p.phi = p.phi * p.gamma;
        p.square = p.square * p.gamma * p.gamma;
    }
    return p;
}

template <class V, class Number, class Use>
SUFFUSE_INLINE auto withSlopes(const Shading<Number> &how, Use use)
{
    const V x1(how.xi[0]), x2(how.xi[1]), x3(how.xi[2]);
    switch (how.kind) {
    case StyleKind::Uniform:
        return use(UniformSlopes<V>(x1, x2, x3));
    case StyleKind::Feathering:
        return use(FeatheringSlopes<V>(x1, x2, x3));
    case StyleKind::Edge:
        break;
    }
    return use(EdgeSlopes<V>(x1, x2, x3));
}

template <bool keep, class V, class Number>
SUFFUSE_INLINE void mixStrokeBy(const Shading<Number> &how, StrokeTile<Number> &stroke,
                                const ValueTile<Number> *varying, const Number *eta, ColourTile<Number> &ryb)
{
    using P = Pixels<V>;
    const V kept(how.keep);
    withSlopes<V>(how, [&](const auto &style) {
        for (int at = 0; at < tileSize; at += P::count()) {
            const PixelPaint<V> p = paintAt<V>(how, stroke, varying, eta, at);
            const auto seen = style.seen(p.phi, p.square);
            if (keep)
                stroke.shown[at] = Shown::Nothing;
            if (all_(not_(seen)))
                continue;
            const bool full = all_(style.full(p.phi, p.square));
            MeanSlopes<V> m{V(1), V(0), V(0), {V(0), V(0), V(0)}};
            if (!full)
                m = style.template slopes<false>(p.phi, p.square);
            const V mean = select_(seen, clamp01(m.mean), V(0)), w = mean * p.value[3] * p.left;
            for (int c = 0; c < 3; ++c) {
                const V below = P::load(ryb.v[c] + at);
                if (keep)
                    P::store(below, stroke.below[c] + at);
                P::store(mixed(below, p.value[c], w, kept), ryb.v[c] + at);
            }
            if (keep) {
                stroke.shown[at] = full ? Shown::FullPaint : Shown::Something;
                P::store(mean, stroke.mean + at);
                P::store(select_(seen, m.byDensity, V(0)), stroke.byDensity + at);
                P::store(select_(seen, m.bySquare, V(0)), stroke.bySquare + at);
            }
        }
    });
}

template <class V, class Number>
void mixStroke(const Shading<Number> &how, StrokeTile<Number> &stroke, const ValueTile<Number> *varying,
               const Number *eta, bool keep, ColourTile<Number> &ryb)
{
    if (keep)
        mixStrokeBy<true, V>(how, stroke, varying, eta, ryb);
    else
        mixStrokeBy<false, V>(how, stroke, varying, eta, ryb);
}

template <class V, class Number>
void toRgb(const ColourTile<Number> &ryb, ColourTile<Number> &rgb)
{
    using P = Pixels<V>;
    for (int at = 0; at < tileSize; at += P::count()) {
        const Triple<V> c = rgbFromRyb(P::load(ryb.v[0] + at), P::load(ryb.v[1] + at), P::load(ryb.v[2] + at));
        P::store(c.x, rgb.v[0] + at);
        P::store(c.y, rgb.v[1] + at);
        P::store(c.z, rgb.v[2] + at);
    }
}

template <class V, class Number>
void rgbBack(const ColourTile<Number> &ryb, ColourTile<Number> &by)
{
    using P = Pixels<V>;
    for (int at = 0; at < tileSize; at += P::count()) {
        const Triple<V> slopes{P::load(by.v[0] + at), P::load(by.v[1] + at), P::load(by.v[2] + at)};
        const Triple<V> c = rybSlopes(P::load(ryb.v[0] + at), P::load(ryb.v[1] + at), P::load(ryb.v[2] + at), slopes);
        P::store(c.x, by.v[0] + at);
        P::store(c.y, by.v[1] + at);
        P::store(c.z, by.v[2] + at);
    }
}

/// Sums over pixels.
template <class V>
struct ConstantSums {
    V xi[3], constant[values];

    SUFFUSE_INLINE ConstantSums()
    {
        for (V &v : xi)
            v = V(0);
        for (V &v : constant)
            v = V(0);
    }
};

/// Finds the derivatives by a stroke's numbers at one vector of pixels, from those by what is above it.
template <class V, class Number>
SUFFUSE_INLINE V pixelsBack(const Shading<Number> &how, const StrokeTile<Number> &stroke, const PixelPaint<V> &p,
                            const Number *eta, int at, ColourTile<Number> &by, SumSlopes<Number> &out,
                            ConstantSums<V> &constants)
{
    using P = Pixels<V>;
    const V mean = P::load(stroke.mean + at), w = mean * p.value[3] * p.left, keep(how.keep);
    V byValue[values], byW(0);
    for (int c = 0; c < 3; ++c) {
        const MixSlopes<V> slopes =
            mixSlopes(P::load(stroke.below[c] + at), p.value[c], w, keep, P::load(by.v[c] + at));
        P::store(slopes.byBackdrop, by.v[c] + at);
        byValue[c] = slopes.byColour;
        byW = byW + slopes.byOpacity;
    }
    const V byMean = byW * p.value[3] * p.left;
    V byPhi = byMean * P::load(stroke.byDensity + at), bySquare = byMean * P::load(stroke.bySquare + at);
    byValue[3] = byW * mean * p.left;
    if (how.fades)
        P::store(V(0) - byW * w, out.fading[0] + at);
    byValue[4] = V(0);
    if (eta) {
        const V byGamma = mulAdd_(byPhi, P::load(stroke.sums[0] + at), V(2) * bySquare * p.gamma * p.plain);
        byValue[4] = byGamma * (V(1) - P::load(eta + at));
        byPhi = byPhi * p.gamma;
        bySquare = bySquare * p.gamma * p.gamma;
    }
    if (how.varies) {
        V byLaid(0);
        for (int i = 0; i < values; ++i) {
            const auto inside = and_(less_(V(leastValue), p.value[i]), less_(p.value[i], V(mostValue)));
            const V slope = select_(inside, byValue[i] * p.inverse, V(0));
            P::store(slope, out.planes[i] + at);
            byLaid = negMulAdd_(slope, p.value[i], byLaid);
        }
        P::store(select_(less_(V(how.leastLaid), p.laid), byLaid, V(0)), out.planes[values] + at);
    } else
        for (int i = 0; i < values; ++i)
            constants.constant[i] = constants.constant[i] + byValue[i];
    P::store(byPhi, out.sums[0] + at);
    P::store(V(2) * bySquare * P::load(stroke.sums[1] + at), out.sums[1] + at);
    P::store(V(2) * bySquare * P::load(stroke.sums[2] + at), out.sums[2] + at);
    return byMean;
}

template <class V, class Number>
SUFFUSE_INLINE void clearSlopes(const Shading<Number> &how, int at, SumSlopes<Number> &out)
{
    using P = Pixels<V>;
    for (auto &plane : out.sums)
        P::store(V(0), plane + at);
    if (how.varies)
        for (auto &plane : out.planes)
            P::store(V(0), plane + at);
    if (how.fades)
        P::store(V(0), out.fading[0] + at);
}

template <class V, class Number>
SUFFUSE_INLINE void addXi(const Shading<Number> &how, const PixelPaint<V> &p, V byMean, ConstantSums<V> &sums)
{
    withSlopes<V>(how, [&](const auto &style) {
        const MeanSlopes<V> m = style.template slopes<true>(p.phi, p.square);
        const auto counts = and_(style.seen(p.phi, p.square), not_(style.full(p.phi, p.square)));
        for (int i = 0; i < 3; ++i)
            sums.xi[i] = sums.xi[i] + select_(counts, byMean * m.byXi[i], V(0));
    });
}

template <class V, class Number>
bool strokeBack(const Shading<Number> &how, const StrokeTile<Number> &stroke, const ValueTile<Number> *varying,
                const Number *eta, bool xi, ColourTile<Number> &by, SumSlopes<Number> &out,
                StrokeSlopes<Number> &constants)
{
    using P = Pixels<V>;
    ConstantSums<V> sums;
    out.firstRow = tileSide, out.endRow = 0;
    for (int row = 0; row < tileSide; ++row) {
        bool any = false;
        for (int at = row * tileSide; at < (row + 1) * tileSide; at += P::count()) {
            if (stroke.shown[at] == Shown::Nothing) {
                clearSlopes<V>(how, at, out);
                continue;
            }
            const PixelPaint<V> p = paintAt<V>(how, stroke, varying, eta, at);
            const V byMean = pixelsBack(how, stroke, p, eta, at, by, out, sums);
            if (stroke.shown[at] == Shown::Something && xi)
                addXi(how, p, byMean, sums);
            any |= how.varies || how.fades || stroke.shown[at] == Shown::Something;
        }
        if (any)
            out.firstRow = std::min(out.firstRow, row), out.endRow = row + 1;
    }
    for (int i = 0; i < 3; ++i)
        constants.xi[i] = P::total(sums.xi[i]);
    for (int i = 0; i < values; ++i)
        constants.constant[i] = P::total(sums.constant[i]);
    return out.firstRow < out.endRow;
}

template <class V, class Number>
void valuesBack(Source source, const TileNode<Number> *nodes, int count, const double *value,
                const SumSlopes<Number> &by, NodeSlopes<Number> *out, Number *byValue)
{
    using P = Pixels<V>;
    alignas(64) Number density[tileSize];
    alignas(64) Number own[3][tileSize];
    densityOf<V>(source, nodes, count, density);
    V totals[values] = {V(0), V(0), V(0), V(0), V(0)};
    for (int at = by.firstRow * tileSide; at < by.endRow * tileSide; at += P::count()) {
        const V d = P::load(density + at);
        V sum = P::load(by.sums[0] + at) + P::load(by.planes[values] + at);
        for (int i = 0; i < values; ++i) {
            const V slope = P::load(by.planes[i] + at);
            totals[i] = mulAdd_(d, slope, totals[i]);
            sum = mulAdd_(slope, V(Number(value[i])), sum);
        }
        P::store(sum, own[0] + at);
        P::store(P::load(by.sums[1] + at), own[1] + at);
        P::store(P::load(by.sums[2] + at), own[2] + at);
    }
    for (int i = 0; i < values; ++i)
        byValue[i] = P::total(totals[i]);
    nodesBack<V>(source, nodes, count, own, by.firstRow, by.endRow, out);
}

template <class V>
TileKernels<typename Pixels<V>::Number> kernelsOf()
{
    using Number = typename Pixels<V>::Number;
    return {Pixels<V>::findNodes, accumulate<V, Number>, addValues<V, Number>, fade<V, Number>,
            mixStroke<V, Number>, toRgb<V, Number>,      rgbBack<V, Number>,   strokeBack<V, Number>,
            nodesBack<V, Number>, valuesBack<V, Number>};
}

} // namespace suffuse::SUFFUSE_MATH
SUFFUSE_MATH_END

#endif
