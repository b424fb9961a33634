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

HWY_INLINE Lanes min_(Lanes a, Lanes b)
{
    return Lanes(hn::Min(a.v, b.v));
}
HWY_INLINE Lanes max_(Lanes a, Lanes b)
{
    return Lanes(hn::Max(a.v, b.v));
}
HWY_INLINE Lanes abs_(Lanes a)
{
    return Lanes(hn::Abs(a.v));
}
HWY_INLINE Lanes sqrt_(Lanes a)
{
    return Lanes(hn::Sqrt(a.v));
}
HWY_INLINE Mask less_(Lanes a, Lanes b)
{
    return hn::Lt(a.v, b.v);
}
HWY_INLINE Mask and_(Mask a, Mask b)
{
    return hn::And(a, b);
}
HWY_INLINE Mask or_(Mask a, Mask b)
{
    return hn::Or(a, b);
}
HWY_INLINE Mask not_(Mask m)
{
    return hn::Not(m);
}
HWY_INLINE bool all_(Mask m)
{
    return hn::AllTrue(Tag(), m);
}
HWY_INLINE Lanes negMulAdd_(Lanes a, Lanes b, Lanes c)
{
    return Lanes(hn::NegMulAdd(a.v, b.v, c.v));
}
HWY_INLINE Lanes mulAdd_(Lanes a, Lanes b, Lanes c)
{
    return Lanes(hn::MulAdd(a.v, b.v, c.v));
}
HWY_INLINE Lanes select_(Mask m, Lanes a, Lanes b)
{
    return Lanes(hn::IfThenElse(m, a.v, b.v));
}

/// 2^x for x in [−126, 126], relative error 2^−22.5 (minimax of degree 5 over [−½, ½]).
HWY_INLINE Vec exp2InRange(Vec x)
{
    const Tag d;
    const hn::RebindToSigned<Tag> di;
    // Adding 1.5 · 2²³ rounds to a whole number, which is then in the low bits.
    const Vec magic = hn::Set(d, 12582912.0f), shifted = hn::Add(x, magic), f = hn::Sub(x, hn::Sub(shifted, magic));
    Vec p = hn::Set(d, 1.32647425e-3f);
    p = hn::MulAdd(p, f, hn::Set(d, 9.671518e-3f));
    p = hn::MulAdd(p, f, hn::Set(d, 5.55073376e-2f));
    p = hn::MulAdd(p, f, hn::Set(d, 2.4022242e-1f));
    p = hn::MulAdd(p, f, hn::Set(d, 6.93146978e-1f));
    p = hn::MulAdd(p, f, hn::Set(d, 1.0f));
    return hn::BitCast(d, hn::Add(hn::BitCast(di, p), hn::ShiftLeft<23>(hn::BitCast(di, shifted))));
}

/// 2^x; below −126 and above 120 as there.
HWY_INLINE Lanes exp2_(Lanes a)
{
    return Lanes(exp2InRange(hn::Min(hn::Max(a.v, hn::Set(Tag(), -126.0f)), hn::Set(Tag(), 120.0f))));
}

/// The same for x ≤ 0.
HWY_INLINE Lanes exp2Down(Lanes a)
{
    return Lanes(exp2InRange(hn::Max(a.v, hn::Set(Tag(), -126.0f))));
}

/// log₂ x for normal x > 0, absolute error below 2^−23 near 1 and relative elsewhere (minimax of degree 8).
HWY_INLINE Lanes log2_(Lanes a)
{
    const Tag d;
    const hn::RebindToSigned<Tag> di;
    // Exponent so that the mantissa lies in [√½, √2).
    const auto bits = hn::BitCast(di, a.v);
    const auto e = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(di, 0x3f3504f3)));
    const Vec u = hn::Sub(hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<23>(e))), hn::Set(d, 1.0f));
    Vec p = hn::Set(d, -0.145744473f);
    for (const float c :
         {0.236890376f, -0.250069052f, 0.286707461f, -0.360087216f, 0.480939448f, -0.721357167f, 1.44269478f})
        p = hn::MulAdd(p, u, hn::Set(d, c));
    return Lanes(hn::MulAdd(p, u, hn::ConvertTo(d, e)));
}

/// 1/x for normal x in (0, 2^125), relative error below 2^−22: from a guess within 5 %, in fewer cycles than a division
/// and the same on every processor.
HWY_INLINE Lanes reciprocal_(Lanes a)
{
    const Tag d;
    const hn::RebindToSigned<Tag> di;
    const Vec one = hn::Set(d, 1.0f);
    Vec r = hn::BitCast(d, hn::Sub(hn::Set(di, 0x7ef31000), hn::BitCast(di, a.v)));
    const Vec e = hn::NegMulAdd(a.v, r, one);
    r = hn::MulAdd(r, hn::MulAdd(e, e, e), r);
    return Lanes(hn::MulAdd(r, hn::NegMulAdd(a.v, r, one), r));
}

/// √x for normal x, relative error below 2^−21, in a fourth of a root's cycles and the same on every processor.
HWY_INLINE Lanes quickRoot_(Lanes a)
{
    const Tag d;
    const hn::RebindToSigned<Tag> di;
    Vec r = hn::BitCast(d, hn::Sub(hn::Set(di, 0x5f375a86), hn::ShiftRight<1>(hn::BitCast(di, a.v)))); // of 1/√x, 4 %
    const Vec e = hn::NegMulAdd(hn::Mul(a.v, r), r, hn::Set(d, 1.0f));
    r = hn::MulAdd(hn::Mul(r, e), hn::MulAdd(e, hn::Set(d, 0.375f), hn::Set(d, 0.5f)), r);
    const Vec root = hn::Mul(a.v, r);
    return Lanes(hn::MulAdd(hn::NegMulAdd(root, root, a.v), hn::Mul(hn::Set(d, 0.5f), r), root));
}

/// ½erfc(−u) with a relative error of 4e-7 for u < 0, by a fit in powers of 1/(1 + 0.36 |u|). `gaussian` is e^(−u²).
HWY_INLINE Lanes halfErfc(Lanes u, Lanes gaussian)
{
    const Lanes t = reciprocal_(mulAdd_(Lanes(0.36), abs_(u), Lanes(1)));
    Lanes p(-0.083145597);
    for (const double c : {0.28835637, -0.18964859, 0.22575925, 0.047871786, 0.10986609, 0.10094082})
        p = mulAdd_(p, t, Lanes(c));
    const Lanes tail = p * t * gaussian;
    return select_(less_(u, Lanes(0)), tail, Lanes(1) - tail);
}

} // namespace suffuse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
