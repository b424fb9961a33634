// The number functions of the shared mathematics for float and double.
#pragma once

#include "render/math/compat.h"

#include <cmath>

namespace suffuse::math {

#ifdef __CUDA_ARCH__
// The device's own approximations: exp2_, log2_ and the others within 2 units in the last place near 1.
SUFFUSE_INLINE float exp2_(float a)
{
    float r;
    asm("ex2.approx.ftz.f32 %0, %1;" : "=f"(r) : "f"(a));
    return r;
}
SUFFUSE_INLINE float log2_(float a)
{
    float r;
    asm("lg2.approx.ftz.f32 %0, %1;" : "=f"(r) : "f"(a));
    return r;
}
SUFFUSE_INLINE float sqrt_(float a)
{
    float r;
    asm("sqrt.approx.ftz.f32 %0, %1;" : "=f"(r) : "f"(a));
    return r;
}
SUFFUSE_INLINE float reciprocal_(float a)
{
    float r;
    asm("rcp.approx.ftz.f32 %0, %1;" : "=f"(r) : "f"(a));
    return r;
}
SUFFUSE_INLINE float min_(float a, float b) { return fminf(a, b); }
SUFFUSE_INLINE float max_(float a, float b) { return fmaxf(a, b); }
SUFFUSE_INLINE float mulAdd_(float a, float b, float c) { return __fmaf_rn(a, b, c); }
SUFFUSE_INLINE float negMulAdd_(float a, float b, float c) { return __fmaf_rn(-a, b, c); }
#else
SUFFUSE_INLINE float exp2_(float a) { return std::exp2(a); }
SUFFUSE_INLINE float log2_(float a) { return std::log2(a); }
SUFFUSE_INLINE float sqrt_(float a) { return std::sqrt(a); }
SUFFUSE_INLINE float reciprocal_(float a) { return 1 / a; }
SUFFUSE_INLINE float min_(float a, float b) { return a < b ? a : b; }
SUFFUSE_INLINE float max_(float a, float b) { return a > b ? a : b; }
SUFFUSE_INLINE float mulAdd_(float a, float b, float c) { return a * b + c; }
SUFFUSE_INLINE float negMulAdd_(float a, float b, float c) { return c - a * b; }
#endif
SUFFUSE_INLINE float abs_(float a) { return std::fabs(a); }
SUFFUSE_INLINE float quickRoot_(float a) { return sqrt_(a); }
SUFFUSE_INLINE double min_(double a, double b) { return a < b ? a : b; }
SUFFUSE_INLINE double max_(double a, double b) { return a > b ? a : b; }
SUFFUSE_INLINE double abs_(double a) { return std::fabs(a); }
SUFFUSE_INLINE double sqrt_(double a) { return std::sqrt(a); }
SUFFUSE_INLINE double quickRoot_(double a) { return std::sqrt(a); }
SUFFUSE_INLINE double exp2_(double a) { return std::exp2(a); }
SUFFUSE_INLINE double log2_(double a) { return std::log2(a); }
SUFFUSE_INLINE double reciprocal_(double a) { return 1 / a; }
SUFFUSE_INLINE bool less_(float a, float b) { return a < b; }
SUFFUSE_INLINE bool less_(double a, double b) { return a < b; }
SUFFUSE_INLINE bool and_(bool a, bool b) { return a && b; }
SUFFUSE_INLINE bool or_(bool a, bool b) { return a || b; }
SUFFUSE_INLINE bool not_(bool m) { return !m; }
SUFFUSE_INLINE bool all_(bool m) { return m; }
SUFFUSE_INLINE double mulAdd_(double a, double b, double c) { return a * b + c; }
SUFFUSE_INLINE double negMulAdd_(double a, double b, double c) { return c - a * b; }
SUFFUSE_INLINE float select_(bool m, float a, float b) { return m ? a : b; }
SUFFUSE_INLINE double select_(bool m, double a, double b) { return m ? a : b; }

} // namespace suffuse::math
