// Draws pixels with four samples each that are told from sums at the centres (docs/solver.md, "Four samples from one").
// It is included once for each Highway target.
#if defined(SUFFUSE_RENDER_CPU_TOLD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_CPU_TOLD_INL_H
#undef SUFFUSE_RENDER_CPU_TOLD_INL_H
#else
#define SUFFUSE_RENDER_CPU_TOLD_INL_H
#endif

#include "render/cpu/shading-inl.h"
// It has templates over the lanes, which must be declared before.
#include "render/math/bends.h"

HWY_BEFORE_NAMESPACE();
namespace suffuse::HWY_NAMESPACE {

using namespace suffuse::cpu;

/// Pixels of a block that are shaded by four samples each: their places, their sums and how these bend, side by side.
struct Told {
    int count = 0;
    alignas(64) std::int32_t at[blockSize + boxRun];
    alignas(64) float sums[fixedSums + maxChannels][blockSize + boxRun];
    alignas(64) float bends[fixedBends + 2 * maxChannels][blockSize + boxRun];
    alignas(64) float eta[4][blockSize + boxRun];

    /// Adds pixels of the vector that begins at the `from`-th one.
    HWY_INLINE void add(Mask which, int from, int channels, const Sums &s, const Bends &b,
                        const float (*etaOfSamples)[blockSize])
    {
        const hn::RebindToSigned<Tag> intTag;
        const auto pack = [&](const float *of, float *to) {
            hn::StoreU(hn::Compress(load(of + from).v, which), tag, to + count);
        };
        hn::StoreU(hn::Compress(hn::Iota(intTag, from), hn::RebindMask(intTag, which)), intTag, at + count);
        for (int i = 0; i < fixedSums + channels; ++i)
            pack(s.v[i], sums[i]);
        for (int i = 0; i < fixedBends + 2 * channels; ++i)
            pack(b.v[i], bends[i]);
        for (int i = 0; i < 4 && etaOfSamples; ++i)
            pack(etaOfSamples[i], eta[i]);
        count += int(hn::CountTrue(tag, which));
    }
};

/// What γ is at the samples of pixels.
HWY_INLINE Range<Lanes> gammaOf(const ShadeParams &params, const float (*eta)[blockSize], int at)
{
    if (!eta)
        return {Lanes(1), Lanes(1)};
    const auto sample = [&](int i) { return load(eta[i] + at); };
    const Lanes low = min_(min_(sample(0), sample(1)), min_(sample(2), sample(3)));
    if (params.grainChannel >= 0)
        return {low, Lanes(1)};
    const Lanes high = max_(max_(sample(0), sample(1)), max_(sample(2), sample(3)));
    const Lanes grain(params.grain), rest = Lanes(1) - grain;
    return {mulAdd_(rest, low, grain), mulAdd_(rest, high, grain)};
}

/// Finds the pixels of level 1 that can be told from their centres, and sets their marks to 0. For those that one
/// sample does for it raises the density in `sums` as that needs, and the others go to `out`. Where the sums are not to
/// be shaded as they are then, the density becomes 0.
template <class Style>
HWY_INLINE void tell(const Style &style, const ShadeParams &params, int channels, Sums &sums, const Bends &bends,
                     const float (*eta)[blockSize], std::uint8_t *marks, Told &out)
{
    constexpr float most = 5e-4f, mostOfOne = 3e-4f; // of opacity; they are bounds, and most pixels lie far below
    // One sample does not tell how the paper changes, or a colour.
    const Lanes limitOfOne(eta || params.colourChannel >= 0 || params.lineChannel >= 0 ? -1.0f : mostOfOne);
    const hn::Rebind<std::uint8_t, Tag> byteTag;
    const hn::RebindToSigned<Tag> intTag;
    for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
        const Lanes mark(hn::ConvertTo(tag, hn::PromoteTo(intTag, hn::LoadU(byteTag, marks + at))));
        const Mask marked = less_(Lanes(0), mark);
        if (hn::AllFalse(tag, marked))
            continue;
        const Mask first = and_(less_(Lanes(levelQuarters - 0.5f), mark), less_(mark, Lanes(2 * levelQuarters - 0.5f)));
        const auto sum = [&](int i) { return load(sums.v[i] + at); };
        const auto bend = [&](int i) { return load(bends.v[i] + at); };
        const Bent<Lanes> bent{sum(0), sum(1), sum(2), bend(0), bend(1), bend(2)};
        // s ≥ 4·2^(−(quarter + 1)/4)
        const Lanes spread = exp2_(Lanes(3 - 1.0f / levelQuarters) - Lanes(1.0f / levelQuarters) * mark);
        const Doubt<Lanes> doubt = doubtAbout(style, bent, spread, gammaOf(params, eta, at));
        const Mask shows = less_(Lanes(style.level()), doubt.high);
        const Mask told = and_(first, or_(not_(shows), less_(doubt.four, Lanes(most))));
        const Mask one = and_(told, and_(shows, less_(doubt.one, limitOfOne)));
        const Mask four = and_(told, and_(shows, not_(one)));
        if (!hn::AllFalse(tag, four))
            out.add(four, at, channels, sums, bends, eta);
        Lanes lifted(0);
        if (params.laidChannel >= 0) {
            const Lanes laid = sum(fixedSums + params.laidChannel);
            lifted = min_(max_(Lanes(2) * (laid - bent.density) * inverseDensity(laid), Lanes(0)), Lanes(1));
        }
        const Lanes raised = select_(one, bent.density + riseOf(style, bent, lifted), Lanes(0));
        store(select_(marked, raised, bent.density), sums.v[0] + at);
        for (int i = 1; i < fixedSums; ++i)
            store(select_(or_(one, not_(marked)), sum(i), Lanes(0)), sums.v[i] + at);
        const auto kept = hn::DemoteTo(byteTag, hn::ConvertTo(intTag, hn::IfThenZeroElse(told, mark.v)));
        hn::StoreU(kept, byteTag, marks + at);
    }
}

/// Puts the sums at one of the four samples of each pixel into `out`.
HWY_INLINE void sampleOf(const Told &told, int channels, float right, float down, Sums &out)
{
    const Lanes x(right), y(down);
    for (int at = 0; at < told.count; at += int(hn::Lanes(tag))) {
        const auto sum = [&](int i) { return load(told.sums[i] + at); };
        const auto bend = [&](int i) { return load(told.bends[i] + at); };
        const Bent<Lanes> bent{sum(0), sum(1), sum(2), bend(0), bend(1), bend(2)};
        store(bent.densityAt(x, y), out.v[0] + at);
        store(bent.slopeXAt(x, y), out.v[1] + at);
        store(bent.slopeYAt(x, y), out.v[2] + at);
        for (int c = 0; c < channels; ++c) {
            const Lanes centre = sum(fixedSums + c);
            const Lanes slope = x * bend(fixedBends + 2 * c) + y * bend(fixedBends + 2 * c + 1);
            // A quarter of it is left at least, of all channels, where Gaussians are cut off.
            store(max_(mulAdd_(Lanes(-0.5), slope, centre), Lanes(0.25) * centre), out.v[fixedSums + c] + at);
        }
    }
}

/// Computes opacity and colour of the pixels as means over their samples.
HWY_INLINE void shadeTold(const ShadeParams &params, int channels, const Told &told, bool paper, Shaded &out)
{
    alignas(64) Sums sample;
    alignas(64) Shaded total;
    std::memset(&total, 0, sizeof total);
    for (int i = 0; i < 4; ++i) {
        sampleOf(told, channels, i % 2 ? 1.0f : -1.0f, i / 2 ? 1.0f : -1.0f, sample);
        shadeBlock(
            params, sample, paper ? told.eta[i] : nullptr, 0.5f,
            [&](int at, const Paint<Lanes> &paint) {
                const Lanes colour[3] = {paint.red, paint.yellow, paint.blue};
                store(load(total.w + at) + paint.w, total.w + at);
                for (int c = 0; c < 3; ++c)
                    store(mulAdd_(paint.w, colour[c], load(total.colour[c] + at)), total.colour[c] + at);
            },
            told.count);
    }
    for (int i = 0; i < told.count; ++i) {
        const float w = total.w[i], inverse = w > 0 ? 1 / w : 0;
        out.w[told.at[i]] = 0.25f * w;
        for (int c = 0; c < 3; ++c)
            out.colour[c][told.at[i]] = total.colour[c][i] * inverse;
    }
}

} // namespace suffuse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
