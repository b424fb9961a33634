// A SIMD vector of floats as a number type of the shared mathematics. Included once per Highway target.
#if defined(SUFFUSE_RENDER_MATH_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_MATH_LANES_INL_H
#undef SUFFUSE_RENDER_MATH_LANES_INL_H
#else
#define SUFFUSE_RENDER_MATH_LANES_INL_H
#endif

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace suffuse::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// At most 16 lanes: a row of a block.
using Tag = hn::CappedTag<float, 16>;
using Vec = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;

struct Lanes {
    Vec v;

    HWY_INLINE Lanes() : v(hn::Zero(Tag())) {}
    HWY_INLINE explicit Lanes(Vec vec) : v(vec) {}
    HWY_INLINE explicit Lanes(float f) : v(hn::Set(Tag(), f)) {}
    HWY_INLINE explicit Lanes(double f) : v(hn::Set(Tag(), float(f))) {}
    HWY_INLINE explicit Lanes(int f) : v(hn::Set(Tag(), float(f))) {}

    friend HWY_INLINE Lanes operator+(Lanes a, Lanes b) { return Lanes(hn::Add(a.v, b.v)); }
    friend HWY_INLINE Lanes operator-(Lanes a, Lanes b) { return Lanes(hn::Sub(a.v, b.v)); }
    friend HWY_INLINE Lanes operator*(Lanes a, Lanes b) { return Lanes(hn::Mul(a.v, b.v)); }
    friend HWY_INLINE Lanes operator/(Lanes a, Lanes b) { return Lanes(hn::Div(a.v, b.v)); }
};

HWY_INLINE Lanes min_(Lanes a, Lanes b) { return Lanes(hn::Min(a.v, b.v)); }
HWY_INLINE Lanes max_(Lanes a, Lanes b) { return Lanes(hn::Max(a.v, b.v)); }
HWY_INLINE Lanes abs_(Lanes a) { return Lanes(hn::Abs(a.v)); }
HWY_INLINE Lanes sqrt_(Lanes a) { return Lanes(hn::Sqrt(a.v)); }
HWY_INLINE Mask less_(Lanes a, Lanes b) { return hn::Lt(a.v, b.v); }
HWY_INLINE Lanes select_(Mask m, Lanes a, Lanes b) { return Lanes(hn::IfThenElse(m, a.v, b.v)); }

/// 2^x for x in [−126, 127], relative error 2^−22.5 (minimax of degree 5 over [−½, ½]); 2^−126 below.
HWY_INLINE Lanes exp2_(Lanes a)
{
    const Tag d;
    const hn::RebindToSigned<Tag> di;
    const Vec x = hn::Min(hn::Max(a.v, hn::Set(d, -126.0f)), hn::Set(d, 127.0f));
    const Vec whole = hn::Round(x), f = hn::Sub(x, whole);
    Vec p = hn::Set(d, 1.32647425e-3f);
    p = hn::MulAdd(p, f, hn::Set(d, 9.671518e-3f));
    p = hn::MulAdd(p, f, hn::Set(d, 5.55073376e-2f));
    p = hn::MulAdd(p, f, hn::Set(d, 2.4022242e-1f));
    p = hn::MulAdd(p, f, hn::Set(d, 6.93146978e-1f));
    p = hn::MulAdd(p, f, hn::Set(d, 1.0f));
    const auto bits = hn::Add(hn::BitCast(di, p), hn::ShiftLeft<23>(hn::ConvertTo(di, whole)));
    return Lanes(hn::BitCast(d, bits));
}

/// log₂ x for normal x > 0, absolute error below 2^−22 near 1 and relative elsewhere.
HWY_INLINE Lanes log2_(Lanes a)
{
    const Tag d;
    const hn::RebindToSigned<Tag> di;
    // Exponent so that the mantissa lies in [√½, √2).
    const auto bits = hn::BitCast(di, a.v);
    const auto e = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(di, 0x3f3504f3)));
    const Vec m = hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<23>(e)));
    const Vec one = hn::Set(d, 1.0f);
    const Vec t = hn::Div(hn::Sub(m, one), hn::Add(m, one)), t2 = hn::Mul(t, t);
    Vec p = hn::Set(d, 2.8853901f / 9);
    p = hn::MulAdd(p, t2, hn::Set(d, 2.8853901f / 7));
    p = hn::MulAdd(p, t2, hn::Set(d, 2.8853901f / 5));
    p = hn::MulAdd(p, t2, hn::Set(d, 2.8853901f / 3));
    p = hn::MulAdd(p, t2, hn::Set(d, 2.8853901f));
    return Lanes(hn::MulAdd(p, t, hn::ConvertTo(d, e)));
}

} // namespace suffuse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
