// Compiled once per SIMD target by Highway's foreach_target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/kernels.cpp"
#define SUFFUSE_HIGHWAY
// Sets that differ too little from their neighbours to be worth the compile time and size.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include "hwy/foreach_target.h" // first: it includes this file again for each target

#include "hwy/highway.h"
#include "render/cpu/kernels.h"
#include "render/cpu/shading-inl.h"
#include "render/cpu/sums-inl.h"
// After the lanes: templates over them.
#include "render/math/colour.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace suffuse::HWY_NAMESPACE {

using namespace suffuse::cpu;

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
