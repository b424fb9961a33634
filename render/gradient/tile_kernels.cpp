// Compiled once per SIMD target by Highway's foreach_target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/gradient/tile_kernels.cpp"
#define SUFFUSE_HIGHWAY
// These sets differ too little from their neighbours to be worth time and size of the compilation.
#ifdef SUFFUSE_FEW_SIMD
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)
#else
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#endif
#include "hwy/foreach_target.h" // first: it includes this file again for each target

#include "hwy/highway.h"
#include "render/gradient/tile_kernels.h"
#include "render/math/lanes-inl.h"
// This has templates over the lanes, which must be declared before.
#include "render/gradient/tile_kernels-inl.h"
#include "render/simd_targets.h"

HWY_BEFORE_NAMESPACE();
namespace suffuse::HWY_NAMESPACE {

template <>
struct Pixels<Lanes> {
    using Number = float;
    static constexpr int mostCount = int(hn::MaxLanes(Tag()));
    static HWY_INLINE int count() { return int(hn::Lanes(Tag())); }
    static HWY_INLINE Lanes load(const float *from) { return Lanes(hn::Load(Tag(), from)); }
    static HWY_INLINE void store(Lanes v, float *to) { hn::Store(v.v, Tag(), to); }
    static HWY_INLINE Lanes ramp() { return Lanes(hn::Iota(Tag(), 0.0f)); }
    static std::size_t findNodes(const NodeSearch &search, std::uint32_t *found)
    {
        const hn::RebindToUnsigned<Tag> placeTag;
        constexpr double half = 0.5 * (tileSide - 1);
        const Lanes x(search.left + float(half)), y(search.top + float(half)), near2(search.near * search.near);
        const auto beyond = [](const float *places, Lanes middle, bool oneSide) {
            const Lanes across = Lanes(hn::LoadU(Tag(), places)) - middle;
            return max_((oneSide ? across : abs_(across)) - Lanes(half), Lanes(0));
        };
        std::size_t count = 0;
        for (std::uint32_t i = search.first; i < search.end; i += std::uint32_t(hn::Lanes(Tag()))) {
            const Lanes dx = beyond(search.x + i, x, search.leftwards), dy = beyond(search.y + i, y, false);
            const Mask there = hn::And(hn::FirstN(Tag(), search.end - i), hn::Le((dx * dx + dy * dy).v, near2.v));
            const auto places = hn::Iota(placeTag, i);
            hn::StoreU(hn::Compress(places, hn::RebindMask(placeTag, there)), placeTag, found + count);
            count += hn::CountTrue(Tag(), there);
        }
        return count;
    }
    static HWY_INLINE Lanes halfErfc(Lanes u, Lanes gaussian) { return HWY_NAMESPACE::halfErfc(u, gaussian); }
    static HWY_INLINE float total(Lanes v) { return hn::GetLane(hn::SumOfLanes(Tag(), v.v)); }
};

gradient::TileKernels<float> gradientKernels()
{
    return kernelsOf<Lanes>();
}

} // namespace suffuse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace suffuse {

HWY_EXPORT(gradientKernels);

template <>
const gradient::TileKernels<float> &gradient::tileKernels<float>()
{
    static const TileKernels<float> chosen = [] {
        useWantedSimd();
        return HWY_DYNAMIC_DISPATCH(gradientKernels)();
    }();
    return chosen;
}

} // namespace suffuse
#endif
