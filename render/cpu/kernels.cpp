// Compiled once per SIMD target by Highway's foreach_target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/kernels.cpp"
#define SUFFUSE_HIGHWAY
// Sets that differ too little from their neighbours to be worth the compile time and size.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include "hwy/foreach_target.h" // first: it includes this file again for each target

#include "hwy/highway.h"
#include "render/cpu/kernels.h"
#include "render/math/lanes-inl.h"
// After the lanes: templates over them.
#include "render/math/colour.h"
#include "render/math/shade.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace suffuse::HWY_NAMESPACE {

using namespace suffuse::cpu;

constexpr Tag tag;
inline constexpr int chunk = 32; // nodes whose tables are in cache at once

struct alignas(64) Tables {
    float column[chunk][blockSide];      // e^(−a dx²) − cut
    float columnSlope[chunk][blockSide]; // −½ of its derivative: a dx e^(−a dx²)
    float row[chunk][blockSide];         // weight · (e^(−c dy²) − cut)
    float rowSlope[chunk][blockSide];
    float scaledRow[chunk][blockSide]; // row · channel value
    float place[chunk][4];             // of the node from the centres of the first cell (x, y) and of the last
};

HWY_INLINE Lanes load(const float *p)
{
    return Lanes(hn::Load(tag, p));
}

HWY_INLINE void store(Lanes v, float *p)
{
    hn::Store(v.v, tag, p);
}

/// Distances from a node to the block's 16 sample columns (or rows), lanes from `from` on. `first`, `last`: the node
/// from the centres of the block's cells.
HWY_INLINE Lanes distances(float first, float last, const float *offsets, int from)
{
    const Lanes offset = load(offsets + from);
    if (hn::Lanes(tag) > cellSide) // both cells in one vector
        return offset - Lanes(hn::IfThenElse(hn::FirstN(tag, cellSide), Lanes(first).v, Lanes(last).v));
    return offset - Lanes(from < cellSide ? first : last);
}

/// Offsets of a block's samples from the centres of their cells.
HWY_INLINE void cellOffsets(double step, float *out)
{
    for (int i = 0; i < blockSide; ++i)
        out[i] = (float(i % cellSide) - 3.5f) * float(step);
}

/// Cut Gaussian along one axis and −½ of its slope, times `weight` where there is one.
template <bool weighted>
HWY_INLINE void axisTable(float first, float last, const float *offsets, float metric, float cut, float weight,
                          float *value, float *slope)
{
    for (int i = 0; i < blockSide; i += int(hn::Lanes(tag))) {
        const Lanes d = distances(first, last, offsets, i), rise = Lanes(metric) * d;
        const Lanes e = exp2Down(Lanes(-log2e) * (rise * d));
        Lanes inside = e - Lanes(cut), fall = rise * e;
        if (weighted) {
            inside = inside * Lanes(weight);
            fall = fall * Lanes(weight);
        }
        const Mask there = less_(Lanes(cut), e);
        store(Lanes(hn::IfThenElseZero(there, inside.v)), value + i);
        store(Lanes(hn::IfThenElseZero(there, fall.v)), slope + i);
    }
}

/// Rows of a block whose sums are in registers at once: of one product, of two.
inline constexpr int tallRows = hn::MaxLanes(tag) >= blockSide ? 16 : 8, pairRows = tallRows / 2;

/// Sums of `rows` rows of one vector of columns.
template <int rows>
struct Accumulators {
    Vec v[rows];

    HWY_INLINE void load(const float *sums, bool add)
    {
        for (int r = 0; r < rows; ++r)
            v[r] = add ? hn::Load(tag, sums + r * blockSide) : hn::Zero(tag);
    }
    HWY_INLINE void store(float *sums) const
    {
        for (int r = 0; r < rows; ++r)
            hn::Store(v[r], tag, sums + r * blockSide);
    }
};

/// sums[row][column] (+)= Σ left[node][column] · right[node][row].
HWY_INLINE void addOuter(const float (*left)[blockSide], const float (*right)[blockSide], int nodes, bool add,
                         float *sums)
{
    for (int x = 0; x < blockSide; x += int(hn::Lanes(tag)))
        for (int y = 0; y < blockSide; y += tallRows) {
            Accumulators<tallRows> s;
            s.load(sums + y * blockSide + x, add);
            for (int n = 0; n < nodes; ++n) {
                const Vec l = hn::Load(tag, left[n] + x);
                for (int r = 0; r < tallRows; ++r)
                    s.v[r] = hn::MulAdd(l, hn::Set(tag, right[n][y + r]), s.v[r]);
            }
            s.store(sums + y * blockSide + x);
        }
}

/// Two products that share `right`.
HWY_INLINE void addOuterPair(const float (*left0)[blockSide], const float (*left1)[blockSide],
                             const float (*right)[blockSide], int nodes, bool add, float *sums0, float *sums1)
{
    for (int x = 0; x < blockSide; x += int(hn::Lanes(tag)))
        for (int y = 0; y < blockSide; y += pairRows) {
            Accumulators<pairRows> s0, s1;
            s0.load(sums0 + y * blockSide + x, add);
            s1.load(sums1 + y * blockSide + x, add);
            for (int n = 0; n < nodes; ++n) {
                const Vec l0 = hn::Load(tag, left0[n] + x), l1 = hn::Load(tag, left1[n] + x);
                for (int r = 0; r < pairRows; ++r) {
                    const Vec value = hn::Set(tag, right[n][y + r]);
                    s0.v[r] = hn::MulAdd(l0, value, s0.v[r]);
                    s1.v[r] = hn::MulAdd(l1, value, s1.v[r]);
                }
            }
            s0.store(sums0 + y * blockSide + x);
            s1.store(sums1 + y * blockSide + x);
        }
}

void addSeparable(const Block &block, const ViewNode *nodes, const std::uint32_t *listed, int count,
                  const float *values, int channels, Sums &sums)
{
    Tables t;
    alignas(64) float offsets[blockSide];
    cellOffsets(block.step, offsets);
    const double toCell = block.step * (cellSide / 2);
    const double firstCell[2] = {block.x + toCell, block.y + toCell};
    const double lastCell[2] = {block.x + 3 * toCell, block.y + 3 * toCell};
    const hn::CappedTag<double, 2> pairTag;
    const hn::Rebind<float, decltype(pairTag)> pairOut;
    for (int first = 0; first == 0 || first < count; first += chunk) {
        const int n = std::min(chunk, count - first);
        for (int i = 0; i < n; ++i) {
            const ViewNode &node = nodes[listed[first + i]];
            for (int axis = 0; axis < 2; axis += int(hn::Lanes(pairTag))) {
                const auto at = hn::LoadU(pairTag, &node.x + axis);
                hn::StoreU(hn::DemoteTo(pairOut, hn::Sub(at, hn::LoadU(pairTag, firstCell + axis))), pairOut,
                           t.place[i] + axis);
                hn::StoreU(hn::DemoteTo(pairOut, hn::Sub(at, hn::LoadU(pairTag, lastCell + axis))), pairOut,
                           t.place[i] + 2 + axis);
            }
        }
        for (int i = 0; i < n; ++i) {
            const ViewNode &node = nodes[listed[first + i]];
            const float *place = t.place[i];
            axisTable<false>(place[0], place[2], offsets, node.a, node.cut, 1, t.column[i], t.columnSlope[i]);
            axisTable<true>(place[1], place[3], offsets, node.c, node.cut, node.weight, t.row[i], t.rowSlope[i]);
        }
        const bool add = first > 0;
        addOuterPair(t.column, t.columnSlope, t.row, n, add, sums.v[0], sums.v[1]);
        addOuter(t.column, t.rowSlope, n, add, sums.v[2]);
        for (int c = 0; c < channels; ++c) {
            for (int i = 0; i < n; ++i) {
                const Lanes value(values[std::size_t(nodes[listed[first + i]].row) * channels + c]);
                for (int y = 0; y < blockSide; y += int(hn::Lanes(tag)))
                    store(load(t.row[i] + y) * value, t.scaledRow[i] + y);
            }
            addOuter(t.column, t.scaledRow, n, add, sums.v[fixedSums + c]);
        }
    }
}

/// Nodes whose axes lie askew: no product of two tables.
void addOblique(const Block &block, const ViewNode *nodes, const std::uint32_t *listed, int count, const float *values,
                int channels, Sums &sums)
{
    alignas(64) float dx[blockSide], dy[blockSide], offsets[blockSide];
    cellOffsets(block.step, offsets);
    const double toCell = block.step * (cellSide / 2);
    for (int n = 0; n < count; ++n) {
        const ViewNode &node = nodes[listed[n]];
        const double x = node.x - block.x - toCell, y = node.y - block.y - toCell;
        for (int i = 0; i < blockSide; i += int(hn::Lanes(tag))) {
            store(distances(float(x), float(x - 2 * toCell), offsets, i), dx + i);
            store(distances(float(y), float(y - 2 * toCell), offsets, i), dy + i);
        }
        const float *value = values + std::size_t(node.row) * channels;
        for (int y = 0; y < blockSide; ++y)
            for (int x = 0; x < blockSide; x += int(hn::Lanes(tag))) {
                const Lanes X = load(dx + x), Y(dy[y]);
                const Lanes ax = Lanes(node.a) * X + Lanes(node.b) * Y, cy = Lanes(node.b) * X + Lanes(node.c) * Y;
                const Lanes e = exp2Down(Lanes(-log2e) * (X * ax + Y * cy)), inside = e - Lanes(node.cut);
                const auto there = less_(Lanes(0), inside);
                const Lanes density = select_(there, inside * Lanes(node.weight), Lanes(0));
                const Lanes slope = select_(there, Lanes(node.weight) * e, Lanes(0)); // −½ of it, as above
                const int at = y * blockSide + x;
                store(load(sums.v[0] + at) + density, sums.v[0] + at);
                store(load(sums.v[1] + at) + slope * ax, sums.v[1] + at);
                store(load(sums.v[2] + at) + slope * cy, sums.v[2] + at);
                for (int c = 0; c < channels; ++c)
                    store(load(sums.v[fixedSums + c] + at) + density * Lanes(value[c]), sums.v[fixedSums + c] + at);
            }
    }
}

int select(const NodeBoxes &in, int count, const Area &area, float level, const NodeBoxSink &out, Bound &bound)
{
    const hn::RebindToUnsigned<Tag> indexTag;
    const Lanes centreX(area.x), centreY(area.y);
    const Lanes halfWidth(area.halfWidth + boxMargin), halfHeight(area.halfHeight + boxMargin);
    Lanes density(0), slope(0);
    int kept = 0;
    for (int i = 0; i < count; i += int(hn::Lanes(tag))) {
        const auto plane = [i](const float *p) { return Lanes(hn::LoadU(tag, p + i)); };
        const Lanes x = plane(in.x), y = plane(in.y), reachX = plane(in.reachX), reachY = plane(in.reachY);
        const Lanes dx = abs_(x - centreX) - halfWidth, dy = abs_(y - centreY) - halfHeight;
        const Mask meets = hn::And(hn::Le(dx.v, reachX.v), hn::Le(dy.v, reachY.v));
        const Mask there = hn::And(hn::FirstN(tag, std::size_t(count - i)), meets);
        if (hn::AllFalse(tag, there))
            continue;
        // Distance u in spreads to the nearest point: e^(−u²), and 2u e^(−u²), which is greatest at u² = ½ and then at
        // most (1 + u²) e^(−u²).
        const Lanes ox = max_(dx, Lanes(0)), oy = max_(dy, Lanes(0));
        const Lanes weight = plane(in.weight), slowest = plane(in.slowest), steepest = plane(in.steepest);
        const Lanes u2 = mulAdd_(ox, ox, oy * oy) * slowest;
        const Lanes e = exp2Down(Lanes(-log2e) * u2);
        const Lanes rise = select_(less_(u2, Lanes(0.5)), Lanes(0.8578), mulAdd_(u2, e, e)); // √2 e^−½ = 0.85776
        density = density + Lanes(hn::IfThenElseZero(there, (weight * e).v));
        slope = slope + Lanes(hn::IfThenElseZero(there, (steepest * rise).v));
        // Compressed in a register: storing a whole vector is faster, and there is room.
        const auto keep = [&](Lanes v, float *plane) { hn::StoreU(hn::Compress(v.v, there), tag, plane + kept); };
        if (out.x) {
            keep(x, out.x);
            keep(y, out.y);
            keep(reachX, out.reachX);
            keep(reachY, out.reachY);
            keep(weight, out.weight);
            keep(slowest, out.slowest);
            keep(steepest, out.steepest);
        }
        const auto node = hn::LoadU(indexTag, in.node + i);
        hn::StoreU(hn::Compress(node, hn::RebindMask(indexTag, there)), indexTag, out.node + kept);
        kept += int(hn::CountTrue(tag, there));
    }
    constexpr float rounding = 1.0001f;
    bound.density = hn::GetLane(hn::SumOfLanes(tag, density.v)) * rounding;
    bound.slope = bound.density > level ? 0 : hn::GetLane(hn::SumOfLanes(tag, slope.v)) * rounding;
    return kept;
}

void accumulate(const Block &block, const ViewNode *nodes, const std::uint32_t *listed, int count, int separable,
                const float *values, int channels, Sums &sums)
{
    addSeparable(block, nodes, listed, separable, values, channels, sums);
    addOblique(block, nodes, listed + separable, count - separable, values, channels, sums);
}

/// Where what a vector of samples shows is stored or mixed: `use(at, paint)`. Samples that show nothing may be left
/// out.
template <class Use>
HWY_INLINE void shadeMixedStyles(const ShadeParams &params, const Sums &sums, const float *eta, float step, Use use)
{
    for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
        const auto sum = [&](int i) { return load(sums.v[i] + at); };
        const auto channel = [&](int c) { return sum(fixedSums + c); };
        const auto m = modulate(params, sum(0), sum(1), sum(2), channel, eta ? load(eta + at) : Lanes(1), Lanes(step));
        const Lanes f = mixedStyles<Lanes>(params, channel, m.inverse, m.phi, m.h2);
        use(at, paintOf(params, m.inverse, channel, f));
    }
}

/// The long form of the mean for single samples of a block, wherever they lie, a vector at a time.
class LongMeans {
public:
    HWY_INLINE void add(hn::Vec<hn::RebindToSigned<Tag>> samples, Mask where, Lanes phi, Lanes h2)
    {
        hn::StoreU(hn::Compress(phi.v, where), tag, m_phi + m_count);
        hn::StoreU(hn::Compress(h2.v, where), tag, m_h2 + m_count);
        hn::StoreU(hn::Compress(samples, hn::RebindMask(indexTag, where)), indexTag, m_at + m_count);
        m_count += int(hn::CountTrue(tag, where));
    }
    template <class Style>
    HWY_INLINE void write(const Style &style, float *f)
    {
        // Pad: beside the block.
        hn::StoreU(hn::Zero(tag), tag, m_phi + m_count);
        hn::StoreU(hn::Zero(tag), tag, m_h2 + m_count);
        hn::StoreU(hn::Set(indexTag, blockSize), indexTag, m_at + m_count);
        for (int i = 0; i < m_count; i += int(hn::Lanes(tag))) {
            const Lanes mean = style.longMean(load(m_phi + i), sqrt_(load(m_h2 + i)));
            hn::ScatterIndex(mean.v, tag, f, hn::Load(indexTag, m_at + i));
        }
    }

private:
    static constexpr hn::RebindToSigned<Tag> indexTag{};

    int m_count = 0;
    alignas(64) float m_phi[blockSize + boxRun];
    alignas(64) float m_h2[blockSize + boxRun];
    alignas(64) std::int32_t m_at[blockSize + boxRun];
};

/// In passes, so that nothing waits for a branch that depends on a sample, and only samples that need the long form of
/// the mean pay for it.
template <class Style, class Use>
HWY_INLINE void shadeOneStyle(const Style &style, const ShadeParams &params, const Sums &sums, const float *eta,
                              float step, Use use)
{
    alignas(64) float phi[blockSize], h2[blockSize], f[blockSize + 1];
    std::uint8_t seen[blockSize]; // first samples of vectors that show something
    int vectors = 0;
    LongMeans others;
    const hn::RebindToSigned<Tag> indexTag;
    const auto iota = hn::Iota(indexTag, 0);
    const auto sum = [&](int i, int at) { return load(sums.v[i] + at); };
    for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
        const auto channel = [&](int c) { return sum(fixedSums + c, at); };
        const auto m =
            modulate(params, sum(0, at), sum(1, at), sum(2, at), channel, eta ? load(eta + at) : Lanes(1), Lanes(step));
        const Mask isSeen = style.seen(m.phi, m.h2), simple = style.simple(m.phi, m.h2);
        store(Lanes(hn::IfThenElseZero(isSeen, m.phi.v)), phi + at);
        store(m.h2, h2 + at);
        seen[vectors] = std::uint8_t(at);
        vectors += !hn::AllFalse(tag, isSeen);
        if (!hn::AllTrue(tag, simple))
            others.add(hn::Add(iota, hn::Set(indexTag, at)), hn::Not(simple), m.phi, m.h2);
    }
    for (int i = 0; i < vectors; ++i)
        store(style.simpleMean(load(phi + seen[i]), load(h2 + seen[i])), f + seen[i]);
    others.write(style, f);
    for (int i = 0; i < vectors; ++i) {
        const int at = seen[i];
        const auto channel = [&](int c) { return sum(fixedSums + c, at); };
        Lanes inverse(0);
        if (usesChannels(params))
            inverse = inverseDensity(sum(0, at));
        use(at, paintOf(params, inverse, channel, load(f + at)));
    }
}

template <class Use>
HWY_INLINE void shadeBlock(const ShadeParams &params, const Sums &sums, const float *eta, float step, Use use)
{
    if (!hasOneStyle(params))
        return shadeMixedStyles(params, sums, eta, step, use);
    const auto xi = [&](int i) { return Lanes(params.kind[0].xi[i]); };
    withStyle<Lanes>(params.kind[0].kind, xi,
                     [&](const auto &style) { shadeOneStyle(style, params, sums, eta, step, use); });
}

void shade(const ShadeParams &params, const Sums &sums, const float *eta, float step, Shaded &out)
{
    std::memset(&out, 0, sizeof out);
    shadeBlock(params, sums, eta, step, [&](int at, const Paint<Lanes> &paint) {
        store(paint.w, out.w + at);
        store(paint.red, out.colour[0] + at);
        store(paint.yellow, out.colour[1] + at);
        store(paint.blue, out.colour[2] + at);
    });
}

HWY_INLINE void mixSample(int at, Lanes w, const Lanes (&colour)[3], float keep, Backdrop &backdrop)
{
    for (int c = 0; c < 3; ++c)
        store(mixed(load(backdrop.ryb[c] + at), colour[c], w, Lanes(keep)), backdrop.ryb[c] + at);
    if (backdrop.transparent)
        store(mulAdd_(Lanes(1) - w, load(backdrop.coverage + at), w), backdrop.coverage + at);
}

HWY_INLINE void composeSample(int at, Lanes w, const Lanes (&colour)[3], float keep, OverMap &map)
{
    const Lanes factor = negMulAdd_(w, Lanes(keep), Lanes(1));
    for (int c = 0; c < 3; ++c) {
        const Lanes paint = w * colour[c];
        store(factor * load(map.keep[c] + at), map.keep[c] + at);
        store(mulAdd_(factor, load(map.add[c] + at), paint), map.add[c] + at);
        store(min_(Lanes(1), mulAdd_(factor, load(map.limit[c] + at), paint)), map.limit[c] + at);
    }
    store((Lanes(1) - w) * load(map.hold + at), map.hold + at);
    store(mulAdd_(Lanes(1) - w, load(map.gain + at), w), map.gain + at);
}

void shadeInto(const ShadeParams &params, const Sums &sums, const float *eta, float step, float keep,
               Backdrop &backdrop, OverMap *map)
{
    const ShadeParams own = params; // cannot alias what is stored
    shadeBlock(own, sums, eta, step, [&](int at, const Paint<Lanes> &paint) {
        const Lanes colour[3] = {paint.red, paint.yellow, paint.blue};
        mixSample(at, paint.w, colour, keep, backdrop);
        if (map)
            composeSample(at, paint.w, colour, keep, *map);
    });
}

void mix(const Shaded &stroke, float keep, Backdrop &backdrop)
{
    for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
        const Lanes colour[3] = {load(stroke.colour[0] + at), load(stroke.colour[1] + at), load(stroke.colour[2] + at)};
        mixSample(at, load(stroke.w + at), colour, keep, backdrop);
    }
}

void compose(const Shaded &stroke, float keep, OverMap &map)
{
    for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
        const Lanes colour[3] = {load(stroke.colour[0] + at), load(stroke.colour[1] + at), load(stroke.colour[2] + at)};
        composeSample(at, load(stroke.w + at), colour, keep, map);
    }
}

void apply(const OverMap &map, Backdrop &backdrop)
{
    for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
        for (int c = 0; c < 3; ++c)
            store(min_(load(map.limit[c] + at),
                       load(map.keep[c] + at) * load(backdrop.ryb[c] + at) + load(map.add[c] + at)),
                  backdrop.ryb[c] + at);
        store(load(map.hold + at) * load(backdrop.coverage + at) + load(map.gain + at), backdrop.coverage + at);
    }
}

void finish(const Backdrop &backdrop, bool transparent, float *rgba, int stride)
{
    for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
        const auto rgb = rgbFromRyb(load(backdrop.ryb[0] + at), load(backdrop.ryb[1] + at), load(backdrop.ryb[2] + at));
        Lanes c[3] = {rgb.x, rgb.y, rgb.z}, alpha(1);
        if (transparent) {
            alpha = load(backdrop.coverage + at);
            const auto covered = less_(Lanes(0), alpha);
            for (Lanes &v : c)
                v = select_(covered,
                            min_(Lanes(1), max_(Lanes(0), (v - (Lanes(1) - alpha)) / max_(alpha, Lanes(1e-30)))),
                            Lanes(0));
        }
        hn::StoreInterleaved4(c[0].v, c[1].v, c[2].v, alpha.v, tag,
                              rgba + 4 * (at / blockSide * stride + at % blockSide));
    }
}

void toArgb(const float *rgba, int count, std::uint32_t *argb)
{
    const hn::RebindToSigned<Tag> intTag;
    const hn::RebindToUnsigned<Tag> argbTag;
    const auto level = [&](Vec v) {
        return hn::BitCast(argbTag, hn::ConvertTo(intTag, hn::MulAdd(v, hn::Set(tag, 255.0f), hn::Set(tag, 0.5f))));
    };
    const int lanes = int(hn::Lanes(tag));
    int i = 0;
    for (; i + lanes <= count; i += lanes) {
        Vec r, g, b, a;
        hn::LoadInterleaved4(tag, rgba + 4 * i, r, g, b, a);
        const auto high = hn::Or(hn::ShiftLeft<24>(level(a)), hn::ShiftLeft<16>(level(r)));
        hn::StoreU(hn::Or(high, hn::Or(hn::ShiftLeft<8>(level(g)), level(b))), argbTag, argb + i);
    }
    if (i < count) { // the rest through a padded copy
        alignas(64) float rest[4 * boxRun] = {};
        alignas(64) std::uint32_t out[boxRun];
        std::copy_n(rgba + 4 * i, 4 * (count - i), rest);
        toArgb(rest, lanes, out);
        std::copy_n(out, count - i, argb + i);
    }
}

Kernels table()
{
    return {hwy::TargetName(HWY_TARGET), select, accumulate, shade, shadeInto, mix, compose, apply, finish, toArgb};
}

} // namespace suffuse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace suffuse {

HWY_EXPORT(table);

const cpu::Kernels &cpu::kernels()
{
    static const Kernels chosen = [] {
        if (const char *wanted = std::getenv("SUFFUSE_SIMD"))
            for (std::int64_t bit = 1; bit > 0; bit <<= 1)
                if ((hwy::SupportedTargets() & bit) && std::strcmp(hwy::TargetName(bit), wanted) == 0)
                    hwy::SetSupportedTargetsForTest(bit);
        return HWY_DYNAMIC_DISPATCH(table)();
    }();
    return chosen;
}

} // namespace suffuse
#endif
