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
    float columnSlope[chunk][blockSide]; // its derivative
    float row[chunk][blockSide];         // weight · (e^(−c dy²) − cut)
    float rowSlope[chunk][blockSide];
    float scaledRow[chunk][blockSide];   // row · channel value
};

HWY_INLINE Lanes load(const float *p)
{
    return Lanes(hn::Load(tag, p));
}

HWY_INLINE void store(Lanes v, float *p)
{
    hn::Store(v.v, tag, p);
}

/// Distances from a node to the block's 16 sample columns (or rows), lanes from `first` on.
HWY_INLINE Lanes distances(float firstCell, float secondCell, const float *offsets, int first)
{
    const Lanes offset = load(offsets + first);
    if (hn::Lanes(tag) > cellSide) // both cells in one vector
        return offset - Lanes(hn::IfThenElse(hn::FirstN(tag, cellSide), Lanes(firstCell).v, Lanes(secondCell).v));
    return offset - Lanes(first < cellSide ? firstCell : secondCell);
}

/// Offsets of a block's samples from the centres of their cells.
HWY_INLINE void cellOffsets(double step, float *out)
{
    for (int i = 0; i < blockSide; ++i)
        out[i] = (float(i % cellSide) - 3.5f) * float(step);
}

/// Cut Gaussian along one axis and its slope, both times `weight`.
HWY_INLINE void axisTable(double node, double origin, double step, const float *offsets, float metric, float cut,
                          float weight, float *value, float *slope)
{
    const double toCell = step * (cellSide / 2);
    const float first = float(node - (origin + toCell)), second = float(node - (origin + 3 * toCell));
    const Lanes exponent(float(-log2e) * metric), w(weight), slopeFactor(-2 * metric * weight);
    for (int i = 0; i < blockSide; i += int(hn::Lanes(tag))) {
        const Lanes d = distances(first, second, offsets, i);
        const Lanes e = exp2_(exponent * d * d);
        const Lanes inside = e - Lanes(cut);
        const auto there = less_(Lanes(0), inside);
        store(Lanes(hn::IfThenElseZero(there, (inside * w).v)), value + i);
        store(Lanes(hn::IfThenElseZero(there, (slopeFactor * d * e).v)), slope + i);
    }
}

/// sums[row][column] += left[node][column] · right[node][row] over the nodes, for up to two products that share `left`.
HWY_INLINE void addOuter(const float (*left)[blockSide], const float (*right)[blockSide], int nodes, float *sums)
{
    const int lanes = int(hn::Lanes(tag));
    for (int x = 0; x < blockSide; x += lanes)
        for (int y = 0; y < blockSide; y += 4) {
            float *out = sums + y * blockSide + x;
            Vec s0 = hn::Load(tag, out), s1 = hn::Load(tag, out + blockSide), s2 = hn::Load(tag, out + 2 * blockSide),
                s3 = hn::Load(tag, out + 3 * blockSide);
            for (int n = 0; n < nodes; ++n) {
                const Vec l = hn::Load(tag, left[n] + x);
                const float *r = right[n] + y;
                s0 = hn::MulAdd(l, hn::Set(tag, r[0]), s0);
                s1 = hn::MulAdd(l, hn::Set(tag, r[1]), s1);
                s2 = hn::MulAdd(l, hn::Set(tag, r[2]), s2);
                s3 = hn::MulAdd(l, hn::Set(tag, r[3]), s3);
            }
            hn::Store(s0, tag, out);
            hn::Store(s1, tag, out + blockSide);
            hn::Store(s2, tag, out + 2 * blockSide);
            hn::Store(s3, tag, out + 3 * blockSide);
        }
}

void addSeparable(const Block &block, const ViewNode *const *nodes, int count, const float *values, int channels,
                  Sums &sums)
{
    Tables t;
    alignas(64) float offsets[blockSide];
    cellOffsets(block.step, offsets);
    for (int first = 0; first < count; first += chunk) {
        const int n = std::min(chunk, count - first);
        for (int i = 0; i < n; ++i) {
            const ViewNode &node = *nodes[first + i];
            axisTable(node.x, block.x, block.step, offsets, node.a, node.cut, 1, t.column[i], t.columnSlope[i]);
            axisTable(node.y, block.y, block.step, offsets, node.c, node.cut, node.weight, t.row[i], t.rowSlope[i]);
        }
        addOuter(t.column, t.row, n, sums.v[0]);
        addOuter(t.columnSlope, t.row, n, sums.v[1]);
        addOuter(t.column, t.rowSlope, n, sums.v[2]);
        for (int c = 0; c < channels; ++c) {
            for (int i = 0; i < n; ++i) {
                const Lanes value(values[std::size_t(nodes[first + i]->row) * channels + c]);
                for (int y = 0; y < blockSide; y += int(hn::Lanes(tag)))
                    store(load(t.row[i] + y) * value, t.scaledRow[i] + y);
            }
            addOuter(t.column, t.scaledRow, n, sums.v[fixedSums + c]);
        }
    }
}

/// Nodes whose axes lie askew: no product of two tables.
void addOblique(const Block &block, const ViewNode *const *nodes, int count, const float *values, int channels,
                Sums &sums)
{
    alignas(64) float dx[blockSide], dy[blockSide], offsets[blockSide];
    cellOffsets(block.step, offsets);
    const double toCell = block.step * (cellSide / 2);
    for (int n = 0; n < count; ++n) {
        const ViewNode &node = *nodes[n];
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
                const Lanes e = exp2_(Lanes(float(-log2e)) * (X * ax + Y * cy)), inside = e - Lanes(node.cut);
                const auto there = less_(Lanes(0), inside);
                const Lanes density = select_(there, inside * Lanes(node.weight), Lanes(0));
                const Lanes slope = select_(there, Lanes(-2 * node.weight) * e, Lanes(0));
                const int at = y * blockSide + x;
                store(load(sums.v[0] + at) + density, sums.v[0] + at);
                store(load(sums.v[1] + at) + slope * ax, sums.v[1] + at);
                store(load(sums.v[2] + at) + slope * cy, sums.v[2] + at);
                for (int c = 0; c < channels; ++c)
                    store(load(sums.v[fixedSums + c] + at) + density * Lanes(value[c]), sums.v[fixedSums + c] + at);
            }
    }
}

int select(const ViewNode *const *nodes, int count, const Area &area, const ViewNode **out, Bound *bound)
{
    alignas(64) float distance2[blockSide], weight[blockSide], steepness[blockSide];
    const Lanes margin(1.0001f);
    Lanes density(0), slope(0);
    int kept = 0, pending = 0;
    const auto flush = [&] {
        for (int i = pending; i < blockSide; ++i)
            distance2[i] = weight[i] = steepness[i] = 0;
        for (int i = 0; i < blockSide; i += int(hn::Lanes(tag))) {
            // Distance u in spreads to the nearest point: e^(−u²), and 2u e^(−u²), which is greatest at u² = ½.
            const Lanes u2 = load(distance2 + i), s2 = max_(u2, Lanes(0.5)), w = load(weight + i) * margin;
            density = density + w * exp2_(Lanes(-log2e) * u2);
            slope = slope + w * load(steepness + i) * Lanes(2) * sqrt_(s2) * exp2_(Lanes(-log2e) * s2);
        }
        pending = 0;
    };
    for (int i = 0; i < count; ++i) {
        const ViewNode &n = *nodes[i];
        const double dx = std::abs(n.x - area.x) - area.halfWidth, dy = std::abs(n.y - area.y) - area.halfHeight;
        // 1.0001: the box is rounded to float.
        if (dx > double(n.reachX) * 1.0001 || dy > double(n.reachY) * 1.0001)
            continue;
        out[kept++] = &n;
        if (!bound)
            continue;
        const float ox = float(std::max(dx, 0.0)), oy = float(std::max(dy, 0.0));
        distance2[pending] = (ox * ox + oy * oy) * n.slowest * 0.9999f;
        weight[pending] = n.weight;
        steepness[pending] = n.steepest;
        if (++pending == blockSide)
            flush();
    }
    if (bound) {
        flush();
        bound->density = hn::GetLane(hn::SumOfLanes(tag, density.v));
        bound->slope = hn::GetLane(hn::SumOfLanes(tag, slope.v));
    }
    return kept;
}

void accumulate(const Block &block, const ViewNode *const *nodes, int count, int separable, const float *values,
                int channels, Sums &sums)
{
    addSeparable(block, nodes, separable, values, channels, sums);
    addOblique(block, nodes + separable, count - separable, values, channels, sums);
}

/// Zero without evaluating anything where a whole vector is: the same bits, sooner.
template <class Style>
HWY_INLINE Lanes meanOrNothing(const Style &style, Lanes phi, Lanes h)
{
    return hn::AllFalse(tag, style.visible(phi, h)) ? Lanes(0) : style.mean(phi, h);
}

template <class MakeFactor>
HWY_INLINE void shadeBlock(const ShadeParams &params, const Sums &sums, const float *eta, float step, Shaded &out,
                           MakeFactor makeFactor)
{
    for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
        const auto channel = [&](int c) { return load(sums.v[fixedSums + c] + at); };
        const auto paint = shadeSample<Lanes>(params, load(sums.v[0] + at), load(sums.v[1] + at), load(sums.v[2] + at),
                                              channel, eta ? load(eta + at) : Lanes(1), Lanes(0.5f * step),
                                              makeFactor(channel));
        store(paint.w, out.w + at);
        store(paint.red, out.colour[0] + at);
        store(paint.yellow, out.colour[1] + at);
        store(paint.blue, out.colour[2] + at);
    }
}

void shade(const ShadeParams &params, const Sums &sums, const float *eta, float step, Shaded &out)
{
    if (hasOneStyle(params)) {
        const auto xi = [&](int i) { return Lanes(params.kind[0].xi[i]); };
        withStyle<Lanes>(params.kind[0].kind, xi, [&](const auto &style) {
            shadeBlock(params, sums, eta, step, out, [&](const auto &) {
                return [&](Lanes, Lanes phi, Lanes h) { return meanOrNothing(style, phi, h); };
            });
        });
        return;
    }
    shadeBlock(params, sums, eta, step, out, [&](const auto &channel) {
        return [&](Lanes inverse, Lanes phi, Lanes h) { return mixedStyles<Lanes>(params, channel, inverse, phi, h); };
    });
}

void mix(const Shaded &stroke, float keep, Backdrop &backdrop)
{
    for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
        const Lanes w = load(stroke.w + at), coverage = load(backdrop.coverage + at);
        for (int c = 0; c < 3; ++c)
            store(mixed(load(backdrop.ryb[c] + at), load(stroke.colour[c] + at), w, Lanes(keep)), backdrop.ryb[c] + at);
        store(w + (Lanes(1) - w) * coverage, backdrop.coverage + at);
    }
}

void compose(const Shaded &stroke, float keep, OverMap &map)
{
    for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
        const Lanes w = load(stroke.w + at), factor = Lanes(1) - w * Lanes(keep);
        for (int c = 0; c < 3; ++c) {
            const Lanes paint = w * load(stroke.colour[c] + at);
            store(factor * load(map.keep[c] + at), map.keep[c] + at);
            store(factor * load(map.add[c] + at) + paint, map.add[c] + at);
            store(min_(Lanes(1), factor * load(map.limit[c] + at) + paint), map.limit[c] + at);
        }
        store((Lanes(1) - w) * load(map.hold + at), map.hold + at);
        store((Lanes(1) - w) * load(map.gain + at) + w, map.gain + at);
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

void finish(const Backdrop &backdrop, bool transparent, float *rgba)
{
    alignas(64) float planes[4][blockSize];
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
        for (int i = 0; i < 3; ++i)
            store(c[i], planes[i] + at);
        store(alpha, planes[3] + at);
    }
    for (int at = 0; at < blockSize; ++at)
        for (int i = 0; i < 4; ++i)
            rgba[at * 4 + i] = planes[i][at];
}

Kernels table()
{
    return {hwy::TargetName(HWY_TARGET), select, accumulate, shade, mix, compose, apply, finish};
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
