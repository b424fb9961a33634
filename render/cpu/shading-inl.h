// Turns sums at the samples of a block into what they show. It is included once for each Highway target.
#if defined(SUFFUSE_RENDER_CPU_SHADING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_CPU_SHADING_INL_H
#undef SUFFUSE_RENDER_CPU_SHADING_INL_H
#else
#define SUFFUSE_RENDER_CPU_SHADING_INL_H
#endif

#include "render/cpu/block-inl.h"
// It has templates over the lanes, which must be declared before.
#include "render/math/shade.h"

HWY_BEFORE_NAMESPACE();
namespace suffuse::HWY_NAMESPACE {

using namespace suffuse::cpu;

/// `use(at, paint)` stores or mixes what a vector of samples shows. Samples that show nothing may be left out.
template <class Use>
HWY_INLINE void shadeMixedStyles(const ShadeParams &params, const Sums &sums, const float *eta, float step, Use use,
                                 int count = blockSize)
{
    for (int at = 0; at < count; at += int(hn::Lanes(tag))) {
        const auto sum = [&](int i) { return load(sums.v[i] + at); };
        const auto channel = [&](int c) { return sum(fixedSums + c); };
        const auto m = modulate(params, sum(0), sum(1), sum(2), channel, eta ? load(eta + at) : Lanes(1), Lanes(step));
        const Lanes f = mixedStyles<Lanes>(params, channel, m);
        use(at, paintOf(params, m.inverse, channel, f));
    }
}

/// Computes a form of the mean for single samples of a block, wherever they lie, a vector at a time.
class PackedMeans {
public:
    HWY_INLINE void add(int from, Mask where, Lanes phi, Lanes h2)
    {
        const auto samples = hn::Iota(indexTag, from);
        hn::StoreU(hn::Compress(phi.v, where), tag, m_phi + m_count);
        hn::StoreU(hn::Compress(h2.v, where), tag, m_h2 + m_count);
        hn::StoreU(hn::Compress(samples, hn::RebindMask(indexTag, where)), indexTag, m_at + m_count);
        m_count += int(hn::CountTrue(tag, where));
    }
    /// `mean(φ, h)` goes to `f`, which has room for one more than a block.
    template <class Mean>
    HWY_INLINE void write(Mean mean, float *f)
    {
        // The padding stands beside the block.
        hn::StoreU(hn::Zero(tag), tag, m_phi + m_count);
        hn::StoreU(hn::Zero(tag), tag, m_h2 + m_count);
        hn::StoreU(hn::Set(indexTag, blockSize), indexTag, m_at + m_count);
        for (int i = 0; i < m_count; i += int(hn::Lanes(tag)))
            hn::ScatterIndex(mean(load(m_phi + i), sqrt_(load(m_h2 + i))).v, tag, f, hn::Load(indexTag, m_at + i));
    }

private:
    static constexpr hn::RebindToSigned<Tag> indexTag{};

    int m_count = 0;
    alignas(64) float m_phi[blockSize + boxRun];
    alignas(64) float m_h2[blockSize + boxRun];
    alignas(64) std::int32_t m_at[blockSize + boxRun];
};

/// Works in passes, so that nothing waits for a branch that depends on a sample, and only samples that need the long
/// form of the mean pay for it.
template <class Style, class Use>
HWY_INLINE void shadeOneStyle(const Style &style, const ShadeParams &params, const Sums &sums, const float *eta,
                              float step, Use use, int count = blockSize)
{
    alignas(64) float phi[blockSize], h2[blockSize], f[blockSize + 1];
    std::uint8_t seen[blockSize]; // the first samples of vectors that show something
    int vectors = 0;
    PackedMeans others;
    const auto sum = [&](int i, int at) { return load(sums.v[i] + at); };
    for (int at = 0; at < count; at += int(hn::Lanes(tag))) {
        const auto channel = [&](int c) { return sum(fixedSums + c, at); };
        const auto m =
            modulate(params, sum(0, at), sum(1, at), sum(2, at), channel, eta ? load(eta + at) : Lanes(1), Lanes(step));
        const Mask isSeen = style.seen(m.phi, m.h2), simple = style.simple(m.phi, m.h2);
        store(Lanes(hn::IfThenElseZero(isSeen, m.phi.v)), phi + at);
        store(Lanes(hn::IfThenElseZero(isSeen, m.h2.v)), h2 + at); // Where φ lies below 0, nothing is left, either.
        seen[vectors] = std::uint8_t(at);
        vectors += !hn::AllFalse(tag, isSeen);
        if (!hn::AllTrue(tag, simple))
            others.add(at, hn::Not(simple), m.phi, m.h2);
    }
    for (int i = 0; i < vectors; ++i)
        store(style.begin(load(phi + seen[i])), f + seen[i]);
    for (int i = 0; i < vectors; ++i)
        store(style.finish(load(f + seen[i]), load(phi + seen[i]), load(h2 + seen[i])), f + seen[i]);
    others.write([&style](Lanes p, Lanes h) { return style.longMean(p, h); }, f);
    for (int i = 0; i < vectors; ++i) {
        const int at = seen[i];
        const auto channel = [&](int c) { return sum(fixedSums + c, at); };
        Lanes inverse(0);
        if (usesChannels(params))
            inverse = inverseDensity(laidOf(params, sum(0, at), channel));
        use(at, paintOf(params, inverse, channel, load(f + at)));
    }
}

/// Whether paint is lifted at any sample.
HWY_INLINE bool anyLifted(const ShadeParams &params, const Sums &sums, int count)
{
    const float *laid = sums.v[fixedSums + params.laidChannel];
    Mask lifted = hn::FirstN(tag, 0);
    for (int at = 0; at < count; at += int(hn::Lanes(tag)))
        lifted = or_(lifted, less_(load(sums.v[0] + at), load(laid + at)));
    return !hn::AllFalse(tag, lifted);
}

/// Shades one style whose mean depends on how much paint is lifted, in passes, too. Where none is, it gives the same
/// bits as above.
template <class Use>
HWY_INLINE void shadeLifted(const Edge<Lanes> &style, const ShadeParams &params, const Sums &sums, const float *eta,
                            float step, Use use, int count = blockSize)
{
    alignas(64) float phi[blockSize], h2[blockSize], share[blockSize];
    alignas(64) float f[blockSize + 1], left[blockSize + 1]; // over ln φ, and over φ
    std::uint8_t seen[blockSize];                            // the first samples of vectors that show something
    int vectors = 0;
    PackedMeans others, lifted;
    const auto sum = [&](int i, int at) { return load(sums.v[i] + at); };
    for (int at = 0; at < count; at += int(hn::Lanes(tag))) {
        const auto channel = [&](int c) { return sum(fixedSums + c, at); };
        const auto m =
            modulate(params, sum(0, at), sum(1, at), sum(2, at), channel, eta ? load(eta + at) : Lanes(1), Lanes(step));
        const Lanes beyond = m.phi - style.phiE;
        const Mask isSeen = and_(style.seen(m.phi, m.h2), less_(m.lifted, Lanes(1)));
        const Mask isLeft =
            and_(or_(less_(Lanes(0), beyond), less_(beyond * beyond, m.h2)), less_(Lanes(0), m.lifted));
        const Mask isLong = and_(isSeen, not_(style.simple(m.phi, m.h2)));
        store(Lanes(hn::IfThenElseZero(isSeen, m.phi.v)), phi + at);
        store(Lanes(hn::IfThenElseZero(isSeen, m.h2.v)), h2 + at);
        store(m.lifted, share + at);
        store(Lanes(0), left + at);
        seen[vectors] = std::uint8_t(at);
        vectors += !hn::AllFalse(tag, or_(isSeen, isLeft));
        if (!hn::AllFalse(tag, isLong))
            others.add(at, isLong, m.phi, m.h2);
        if (!hn::AllFalse(tag, isLeft))
            lifted.add(at, isLeft, m.phi, m.h2);
    }
    for (int i = 0; i < vectors; ++i)
        store(style.begin(load(phi + seen[i])), f + seen[i]);
    for (int i = 0; i < vectors; ++i)
        store(style.finish(load(f + seen[i]), load(phi + seen[i]), load(h2 + seen[i])), f + seen[i]);
    others.write([&style](Lanes p, Lanes h) { return style.longMean(p, h); }, f);
    lifted.write([&style](Lanes p, Lanes h) { return style.meanOverDensity(p, h); }, left);
    for (int i = 0; i < vectors; ++i) {
        const int at = seen[i];
        const auto channel = [&](int c) { return sum(fixedSums + c, at); };
        const Lanes mean = blended(load(f + at), load(left + at), load(share + at));
        use(at, paintOf(params, inverseDensity(laidOf(params, sum(0, at), channel)), channel, mean));
    }
}

template <class Use>
HWY_INLINE void shadeBlock(const ShadeParams &params, const Sums &sums, const float *eta, float step, Use use,
                           int count = blockSize)
{
    if (!hasOneStyle(params))
        return shadeMixedStyles(params, sums, eta, step, use, count);
    const auto xi = [&](int i) { return Lanes(params.kind[0].xi[i]); };
    if (params.laidChannel >= 0 && params.kind[0].kind == StyleKind::Edge && anyLifted(params, sums, count))
        return shadeLifted(Edge<Lanes>(xi(0), xi(1), xi(2)), params, sums, eta, step, use, count);
    withStyle<Lanes>(params.kind[0].kind, xi,
                     [&](const auto &style) { shadeOneStyle(style, params, sums, eta, step, use, count); });
}

} // namespace suffuse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
