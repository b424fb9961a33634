// Vectors of samples in memory. Included once per Highway target.
#if defined(SUFFUSE_RENDER_CPU_BLOCK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_CPU_BLOCK_INL_H
#undef SUFFUSE_RENDER_CPU_BLOCK_INL_H
#else
#define SUFFUSE_RENDER_CPU_BLOCK_INL_H
#endif

#include "render/cpu/blocks.h"
#include "render/math/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace suffuse::HWY_NAMESPACE {

using namespace suffuse::cpu;

inline constexpr Tag tag;

HWY_INLINE Lanes load(const float *p)
{
    return Lanes(hn::Load(tag, p));
}

HWY_INLINE void store(Lanes v, float *p)
{
    hn::Store(v.v, tag, p);
}

} // namespace suffuse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
