// Compiled once per SIMD target by Highway's foreach_target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/kernels.cpp"
#define SUFFUSE_HIGHWAY
// These sets differ too little from their neighbours to be worth time and size of the compilation.
#ifdef SUFFUSE_FEW_SIMD
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)
#else
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#endif
#include "hwy/foreach_target.h" // first: it includes this file again for each target

#include "hwy/highway.h"
#include "render/cpu/kernels.h"
#include "render/cpu/paper-inl.h"
#include "render/cpu/shading-inl.h"
#include "render/cpu/sums-inl.h"
#include "render/cpu/told-inl.h"
#include "render/cpu/fill-inl.h"
// These have templates over the lanes, which must be declared before.
#include "render/math/colour.h"
#include "render/math/blend.h"
#include "render/simd_targets.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace suffuse::HWY_NAMESPACE {

using namespace suffuse::cpu;

/// Boxes and an area, along one axis.
struct Approach {
    Mask meets;
    Lanes u2; // squared distance to the nearest point, in spreads

    HWY_INLINE Approach() {}
    HWY_INLINE Approach(Lanes at, Lanes reach, Lanes slowest, double centre, double half)
    {
        const Lanes d = abs_(at - Lanes(centre)) - Lanes(half + boxMargin), beyond = max_(d, Lanes(0));
        meets = hn::Le(d.v, reach.v);
        u2 = beyond * beyond * slowest;
    }
    /// e^(−u²), but at least 2^−63, so that products of two are normal numbers.
    HWY_INLINE Lanes e() const { return Lanes(exp2InRange(hn::Max((Lanes(-log2e) * u2).v, hn::Set(tag, -63.0f)))); }
};

/// Bounds that are summed over boxes.
struct Bounds {
    Lanes density, slope;
    int count = 0;

    HWY_INLINE Bounds() {} // It is compiled for the target, while the implicit one is not.
    HWY_INLINE void add(Mask there, Lanes u2, Lanes e, Lanes weight, Lanes steepest)
    {
        // 2u e^(−u²) is greatest at u² = ½, where it is √2 e^−½ = 0.85776. Beyond that it is at most (1 + u²) e^(−u²).
        const Lanes rise = select_(less_(u2, Lanes(0.5)), Lanes(0.8578), mulAdd_(u2, e, e));
        density = density + Lanes(hn::IfThenElseZero(there, (weight * e).v));
        slope = slope + Lanes(hn::IfThenElseZero(there, (steepest * rise).v));
        count += int(hn::CountTrue(tag, there));
    }
    HWY_INLINE Meeting meeting() const
    {
        constexpr float rounding = 1.0001f;
        return {count, hn::GetLane(hn::SumOfLanes(tag, density.v)) * rounding,
                hn::GetLane(hn::SumOfLanes(tag, slope.v)) * rounding};
    }
};

int findRuns(const NodeBoxes &in, int count, const Area &area, std::uint32_t *runs, Meeting &meeting)
{
    Bounds bounds;
    int found = 0;
    for (int i = 0; i < count; i += int(boxRun)) {
        const int before = bounds.count;
        for (int j = i; j < std::min(count, i + int(boxRun)); j += int(hn::Lanes(tag))) {
            const auto plane = [j](const float *p) { return Lanes(hn::LoadU(tag, p + j)); };
            const Lanes slowest = plane(in.slowest);
            const Approach x(plane(in.x), plane(in.reachX), slowest, area.x, area.halfWidth);
            const Approach y(plane(in.y), plane(in.reachY), slowest, area.y, area.halfHeight);
            const Mask there = hn::And(hn::FirstN(tag, std::size_t(count - j)), hn::And(x.meets, y.meets));
            if (!hn::AllFalse(tag, there))
                bounds.add(there, x.u2 + y.u2, exp2Down(Lanes(-log2e) * (x.u2 + y.u2)), plane(in.weight),
                           plane(in.steepest));
        }
        runs[found] = std::uint32_t(i);
        found += bounds.count > before;
    }
    meeting = bounds.meeting();
    return found;
}

void listNodes(const NodeBoxes &in, int count, const std::uint32_t *runs, int runCount, const Grid &grid,
               std::uint32_t *nodes, Meeting *cells)
{
    const hn::RebindToUnsigned<Tag> indexTag;
    const int room = runCount * int(boxRun);
    Bounds bounds[gridSide * gridSide];
    for (int k = 0; k < room; k += int(hn::Lanes(tag))) {
        const int at = int(runs[k / int(boxRun)]) + k % int(boxRun);
        const auto plane = [at](const float *p) { return Lanes(hn::LoadU(tag, p + at)); };
        const Lanes slowest = plane(in.slowest), weight = plane(in.weight), steepest = plane(in.steepest);
        const double half = 0.5 * grid.side;
        Approach across[gridSide];
        Lanes acrossE[gridSide];
        for (int i = 0; i < grid.columns; ++i) {
            across[i] = Approach(plane(in.x), plane(in.reachX), slowest, grid.x + (2 * i + 1) * half, half);
            acrossE[i] = across[i].e();
        }
        const Mask within = hn::FirstN(tag, std::size_t(std::max(0, count - at)));
        const auto node = hn::LoadU(indexTag, in.node + at);
        for (int row = 0, i = 0; row < grid.rows; ++row) {
            const Approach down(plane(in.y), plane(in.reachY), slowest, grid.y + (2 * row + 1) * half, half);
            const Lanes downE = down.e();
            const Mask inRow = hn::And(within, down.meets);
            for (int column = 0; column < grid.columns; ++column, ++i) {
                const Mask there = hn::And(inRow, across[column].meets);
                // It is compressed in a register, since storing a whole vector is faster, and there is room.
                hn::StoreU(hn::Compress(node, hn::RebindMask(indexTag, there)), indexTag,
                           nodes + i * room + bounds[i].count);
                bounds[i].add(there, across[column].u2 + down.u2, acrossE[column] * downE, weight, steepest);
            }
        }
    }
    for (int i = 0; i < grid.columns * grid.rows; ++i)
        cells[i] = bounds[i].meeting();
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
    if (backdrop.hasCoverage)
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
    const ShadeParams own = params; // A copy cannot alias what is stored.
    shadeBlock(own, sums, eta, step, [&](int at, const Paint<Lanes> &paint) {
        const Lanes colour[3] = {paint.red, paint.yellow, paint.blue};
        mixSample(at, paint.w, colour, keep, backdrop);
        if (map)
            composeSample(at, paint.w, colour, keep, *map);
    });
}

/// What all samples of a block show that have the sums of the first ones.
HWY_INLINE Paint<Lanes> levelPaint(const ShadeParams &params, const Sums &sums, float step)
{
    Paint<Lanes> level{Lanes(0), Lanes(0), Lanes(0), Lanes(0)};
    shadeBlock(
        params, sums, nullptr, step, [&](int, const Paint<Lanes> &paint) { level = paint; }, int(hn::Lanes(tag)));
    return level;
}

void shadeLevelInto(const ShadeParams &params, const Sums &sums, float step, float keep, Backdrop &backdrop,
                    OverMap *map)
{
    const Paint<Lanes> paint = levelPaint(params, sums, step);
    const Lanes colour[3] = {paint.red, paint.yellow, paint.blue};
    for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
        mixSample(at, paint.w, colour, keep, backdrop);
        if (map)
            composeSample(at, paint.w, colour, keep, *map);
    }
}

void shadeLevel(const ShadeParams &params, const Sums &sums, float step, Shaded &out)
{
    const Paint<Lanes> paint = levelPaint(params, sums, step);
    for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
        store(paint.w, out.w + at);
        store(paint.red, out.colour[0] + at);
        store(paint.yellow, out.colour[1] + at);
        store(paint.blue, out.colour[2] + at);
    }
}

ToldBlock shadeBent(const ShadeParams &params, int channels, Sums &sums, const float *eta,
                    const float (*etaOfSamples)[blockSize], std::uint8_t *marks, float keep, Backdrop &backdrop,
                    OverMap *map, Shaded &out)
{
    Told told;
    // Nothing fades where a pixel is told.
    const int painting = params.fadeChannel >= 0 ? params.fadeChannel : channels;
    ShadeParams unfaded = params;
    unfaded.fadeChannel = -1;
    const bool left = withStyle<Lanes>(
        params.kind[0].kind, [&](int i) { return Lanes(params.kind[0].xi[i]); },
        [&](const auto &style) { return tell(style, params, painting, sums, etaOfSamples, marks, told); });
    if (!left && told.count == 0) {
        shadeInto(params, sums, eta, 1, keep, backdrop, map);
        return ToldBlock::Mixed;
    }
    shade(params, sums, eta, 1, out);
    if (told.count > 0)
        shadeTold(unfaded, painting, told, etaOfSamples, out);
    return left ? ToldBlock::SomeLeft : ToldBlock::Shaded;
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

/// Calls act with the mode as a type, so that the compiler makes a loop without branches of each.
template <class Act>
HWY_INLINE void withMode(BlendMode mode, Act act)
{
    switch (mode) {
    case BlendMode::Normal: return act(std::integral_constant<BlendMode, BlendMode::Normal>());
    case BlendMode::Multiply: return act(std::integral_constant<BlendMode, BlendMode::Multiply>());
    case BlendMode::Screen: return act(std::integral_constant<BlendMode, BlendMode::Screen>());
    case BlendMode::Overlay: return act(std::integral_constant<BlendMode, BlendMode::Overlay>());
    case BlendMode::Darken: return act(std::integral_constant<BlendMode, BlendMode::Darken>());
    case BlendMode::Lighten: return act(std::integral_constant<BlendMode, BlendMode::Lighten>());
    case BlendMode::ColourDodge: return act(std::integral_constant<BlendMode, BlendMode::ColourDodge>());
    case BlendMode::ColourBurn: return act(std::integral_constant<BlendMode, BlendMode::ColourBurn>());
    case BlendMode::HardLight: return act(std::integral_constant<BlendMode, BlendMode::HardLight>());
    case BlendMode::SoftLight: return act(std::integral_constant<BlendMode, BlendMode::SoftLight>());
    case BlendMode::Difference: return act(std::integral_constant<BlendMode, BlendMode::Difference>());
    case BlendMode::Exclusion: return act(std::integral_constant<BlendMode, BlendMode::Exclusion>());
    case BlendMode::Hue: return act(std::integral_constant<BlendMode, BlendMode::Hue>());
    case BlendMode::Saturation: return act(std::integral_constant<BlendMode, BlendMode::Saturation>());
    case BlendMode::Colour: return act(std::integral_constant<BlendMode, BlendMode::Colour>());
    case BlendMode::Luminosity: return act(std::integral_constant<BlendMode, BlendMode::Luminosity>());
    case BlendMode::Plus: return act(std::integral_constant<BlendMode, BlendMode::Plus>());
    case BlendMode::DestinationIn: return act(std::integral_constant<BlendMode, BlendMode::DestinationIn>());
    case BlendMode::DestinationOut: return act(std::integral_constant<BlendMode, BlendMode::DestinationOut>());
    case BlendMode::SourceAtop: return act(std::integral_constant<BlendMode, BlendMode::SourceAtop>());
    }
}

HWY_INLINE Pixel<Lanes> pixelAt(const Backdrop &from, int at)
{
    return {load(from.ryb[0] + at), load(from.ryb[1] + at), load(from.ryb[2] + at), load(from.coverage + at)};
}

void putLayer(const LayerPut &how, const float *share, const Backdrop &layer, Backdrop &below)
{
    withMode(how.mode, [&](auto mode) {
        LayerPut own = how; // A copy cannot alias what is stored.
        own.mode = mode;
        const bool everywhere = own.mode == BlendMode::DestinationIn;
        for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
            if (!everywhere && hn::AllFalse(tag, less_(Lanes(0), load(layer.coverage + at))))
                continue; // Nothing is there to be put.
            const Lanes all(own.opacity), opacity = share ? all * load(share + at) : all;
            const Pixel<Lanes> out = put(own, opacity, pixelAt(layer, at), pixelAt(below, at));
            store(out.red, below.ryb[0] + at);
            store(out.yellow, below.ryb[1] + at);
            store(out.blue, below.ryb[2] + at);
            store(out.coverage, below.coverage + at);
        }
    });
}

constexpr float keptSteps = 65535;

/// Reads and writes a share of 1 in 16 bits.
HWY_INLINE Lanes loadKept(const std::uint16_t *from)
{
    const hn::Rebind<std::uint16_t, Tag> keptTag;
    const hn::RebindToSigned<Tag> intTag;
    return Lanes(hn::ConvertTo(tag, hn::PromoteTo(intTag, hn::Load(keptTag, from)))) * Lanes(1 / keptSteps);
}

HWY_INLINE void storeKept(Lanes value, std::uint16_t *to)
{
    const hn::Rebind<std::uint16_t, Tag> keptTag;
    const hn::RebindToSigned<Tag> intTag;
    const Lanes steps = mulAdd_(value, Lanes(keptSteps), Lanes(0.5));
    hn::Store(hn::DemoteTo(keptTag, hn::ConvertTo(intTag, steps.v)), keptTag, to);
}

bool keepLayer(const Backdrop &layer, LayerPicture &out)
{
    out.shown = 0;
    for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
        const Pixel<Lanes> pixel = pixelAt(layer, at);
        const Triple<Lanes> rgb = straightColour(pixel);
        storeKept(rgb.x, out.at(0, at));
        storeKept(rgb.y, out.at(1, at));
        storeKept(rgb.z, out.at(2, at));
        storeKept(pixel.coverage, out.at(3, at));
        out.shown |= std::uint32_t(!hn::AllFalse(tag, less_(Lanes(0), pixel.coverage))) << (at / blockSide);
    }
    return out.shown != 0;
}

void toRgb(Backdrop &backdrop)
{
    for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
        const Triple<Lanes> rgb =
            rgbFromRyb(load(backdrop.ryb[0] + at), load(backdrop.ryb[1] + at), load(backdrop.ryb[2] + at));
        store(rgb.x, backdrop.ryb[0] + at);
        store(rgb.y, backdrop.ryb[1] + at);
        store(rgb.z, backdrop.ryb[2] + at);
    }
}

/// A channel within 0 and 1, from which it may differ by rounding.
HWY_INLINE Lanes loadWithin(const float *from)
{
    return min_(Lanes(1), max_(Lanes(0), load(from)));
}

void toRyb(Backdrop &backdrop)
{
    for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
        const Triple<Lanes> ryb = rybFromRgb(loadWithin(backdrop.ryb[0] + at), loadWithin(backdrop.ryb[1] + at),
                                             loadWithin(backdrop.ryb[2] + at));
        store(ryb.x, backdrop.ryb[0] + at);
        store(ryb.y, backdrop.ryb[1] + at);
        store(ryb.z, backdrop.ryb[2] + at);
    }
}

/// Puts a straight colour on pixels of a block that is RGB.
HWY_INLINE void putStraightAt(int at, const LayerPut &how, Lanes source, const Triple<Lanes> &colour,
                              const RgbPixel<Lanes> &ground, Backdrop &below)
{
    const RgbPixel<Lanes> out = putStraight(how, source, colour, ground);
    for (int c = 0; c < 3; ++c)
        store(out.rgb[c], below.ryb[c] + at);
    store(out.coverage, below.coverage + at);
}

HWY_INLINE RgbPixel<Lanes> rgbAt(const Backdrop &from, int at)
{
    return {{load(from.ryb[0] + at), load(from.ryb[1] + at), load(from.ryb[2] + at)}, load(from.coverage + at)};
}

void putKept(const KeptLayer *layers, int count, Backdrop &below)
{
    for (const KeptLayer *layer = layers; layer != layers + count; ++layer)
        withMode(layer->how.mode, [&](auto mode) {
            LayerPut own = layer->how;
            own.mode = mode;
            const LayerPicture &picture = *layer->picture;
            const std::uint32_t rows = own.mode == BlendMode::DestinationIn ? ~std::uint32_t(0) : picture.shown;
            for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
                if (!(rows >> (at / blockSide) & 1))
                    continue;
                const Triple<Lanes> colour{loadKept(picture.at(0, at)), loadKept(picture.at(1, at)),
                                           loadKept(picture.at(2, at))};
                putStraightAt(at, own, loadKept(picture.at(3, at)) * Lanes(own.opacity), colour, rgbAt(below, at),
                              below);
            }
        });
}

void putEnded(const LayerPut &how, const float *share, const Backdrop &layer, Backdrop &below)
{
    withMode(how.mode, [&](auto mode) {
        LayerPut own = how;
        own.mode = mode;
        for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
            const RgbPixel<Lanes> shown = rgbAt(layer, at);
            const Lanes all = shown.coverage * Lanes(own.opacity), source = share ? all * load(share + at) : all;
            putStraightAt(at, own, source, straightColour(shown), rgbAt(below, at), below);
        }
    });
}

void finish(const Backdrop &backdrop, bool isRgb, bool transparent, float *rgba, int stride)
{
    for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
        Triple<Lanes> rgb{loadWithin(backdrop.ryb[0] + at), loadWithin(backdrop.ryb[1] + at),
                          loadWithin(backdrop.ryb[2] + at)};
        if (!isRgb)
            rgb = rgbFromRyb(load(backdrop.ryb[0] + at), load(backdrop.ryb[1] + at), load(backdrop.ryb[2] + at));
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
        // Not fused: files of whole pictures are rounded so (render/image_io/module/formats.h), and tiles are crops of them.
        return hn::BitCast(argbTag, hn::ConvertTo(intTag, hn::Add(hn::Mul(v, hn::Set(tag, 255.0f)), hn::Set(tag, 0.5f))));
    };
    const int lanes = int(hn::Lanes(tag));
    int i = 0;
    for (; i + lanes <= count; i += lanes) {
        Vec r, g, b, a;
        hn::LoadInterleaved4(tag, rgba + 4 * i, r, g, b, a);
        const auto high = hn::Or(hn::ShiftLeft<24>(level(a)), hn::ShiftLeft<16>(level(r)));
        hn::StoreU(hn::Or(high, hn::Or(hn::ShiftLeft<8>(level(g)), level(b))), argbTag, argb + i);
    }
    if (i < count) { // The rest goes through a padded copy.
        alignas(64) float rest[4 * boxRun] = {};
        alignas(64) std::uint32_t out[boxRun];
        std::copy_n(rgba + 4 * i, 4 * (count - i), rest);
        toArgb(rest, lanes, out);
        std::copy_n(out, count - i, argb + i);
    }
}

Kernels table()
{
    return {hwy::TargetName(HWY_TARGET),
            findRuns,
            listNodes,
            accumulate,
            fillCell,
            shadeBent,
            shade,
            shadeInto,
            shadeLevelInto,
            shadeLevel,
            mix,
            compose,
            apply,
            putLayer,
            keepLayer,
            toRgb,
            toRyb,
            putKept,
            putEnded,
            finish,
            toArgb,
            paper};
}

} // namespace suffuse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace suffuse {

HWY_EXPORT(table);

const cpu::Kernels &cpu::kernels()
{
    static const Kernels chosen = [] {
        useWantedSimd();
        return HWY_DYNAMIC_DISPATCH(table)();
    }();
    return chosen;
}

} // namespace suffuse
#endif
