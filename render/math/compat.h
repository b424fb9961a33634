// What the shared mathematics is compiled as: plain C++ (float or double) or a Highway target's lanes.
//
// The headers of render/math hold templates over a number type V: float, double, or Lanes (a SIMD vector, lanes-inl.h).
// V needs + − * / and the functions of scalar.h: min_, max_, abs_, sqrt_, exp2_, log2_, reciprocal_ and quickRoot_ (of
// normal x > 0), mulAdd_, negMulAdd_, less_, and_, or_, not_, select_, all_ (true for every sample that V holds: what only the others need may be
// left out). The kernels include them once per SIMD target through Highway's foreach_target; everybody else once.
#if defined(SUFFUSE_RENDER_MATH_COMPAT_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_MATH_COMPAT_H
#undef SUFFUSE_RENDER_MATH_COMPAT_H
#else
#define SUFFUSE_RENDER_MATH_COMPAT_H
#endif

#undef SUFFUSE_MATH
#undef SUFFUSE_MATH_BEGIN
#undef SUFFUSE_MATH_END
#undef SUFFUSE_INLINE
#ifdef SUFFUSE_HIGHWAY
#define SUFFUSE_MATH HWY_NAMESPACE
#define SUFFUSE_MATH_BEGIN HWY_BEFORE_NAMESPACE();
#define SUFFUSE_MATH_END HWY_AFTER_NAMESPACE();
#define SUFFUSE_INLINE HWY_INLINE
#else
#define SUFFUSE_MATH math
#define SUFFUSE_MATH_BEGIN
#define SUFFUSE_MATH_END
#ifdef __CUDACC__
#define SUFFUSE_INLINE __host__ __device__ __forceinline__
#else
#define SUFFUSE_INLINE inline
#endif
#endif

#endif
