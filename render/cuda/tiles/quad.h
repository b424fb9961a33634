// Four numbers as a number type of the shared mathematics: a lane has the latencies of four samples at once.
#pragma once

#include "render/math/scalar.h"

namespace suffuse::math {

/// What a comparison says of four numbers.
struct QuadMask {
    bool m[4];
};

struct Quad {
    float v[4];

    SUFFUSE_INLINE Quad() : v{0, 0, 0, 0} {}
    SUFFUSE_INLINE explicit Quad(float f) : v{f, f, f, f} {}
    SUFFUSE_INLINE explicit Quad(double f) : Quad(float(f)) {}
    SUFFUSE_INLINE explicit Quad(int f) : Quad(float(f)) {}
};

/// Calls f(i) for each of the four numbers and gives what it returns.
template <class F>
SUFFUSE_INLINE Quad quadOf(F f)
{
    Quad out;
    out.v[0] = f(0), out.v[1] = f(1), out.v[2] = f(2), out.v[3] = f(3);
    return out;
}
template <class F>
SUFFUSE_INLINE QuadMask quadMaskOf(F f)
{
    return {{f(0), f(1), f(2), f(3)}};
}

SUFFUSE_INLINE Quad operator+(const Quad &a, const Quad &b)
{
    return quadOf([&](int i) { return a.v[i] + b.v[i]; });
}
SUFFUSE_INLINE Quad operator-(const Quad &a, const Quad &b)
{
    return quadOf([&](int i) { return a.v[i] - b.v[i]; });
}
SUFFUSE_INLINE Quad operator*(const Quad &a, const Quad &b)
{
    return quadOf([&](int i) { return a.v[i] * b.v[i]; });
}
SUFFUSE_INLINE Quad operator/(const Quad &a, const Quad &b)
{
    return quadOf([&](int i) { return a.v[i] / b.v[i]; });
}
SUFFUSE_INLINE Quad min_(const Quad &a, const Quad &b)
{
    return quadOf([&](int i) { return min_(a.v[i], b.v[i]); });
}
SUFFUSE_INLINE Quad max_(const Quad &a, const Quad &b)
{
    return quadOf([&](int i) { return max_(a.v[i], b.v[i]); });
}
SUFFUSE_INLINE Quad abs_(const Quad &a)
{
    return quadOf([&](int i) { return abs_(a.v[i]); });
}
SUFFUSE_INLINE Quad sqrt_(const Quad &a)
{
    return quadOf([&](int i) { return sqrt_(a.v[i]); });
}
SUFFUSE_INLINE Quad reciprocal_(const Quad &a)
{
    return quadOf([&](int i) { return reciprocal_(a.v[i]); });
}
SUFFUSE_INLINE Quad mulAdd_(const Quad &a, const Quad &b, const Quad &c)
{
    return quadOf([&](int i) { return mulAdd_(a.v[i], b.v[i], c.v[i]); });
}
SUFFUSE_INLINE QuadMask less_(const Quad &a, const Quad &b)
{
    return quadMaskOf([&](int i) { return a.v[i] < b.v[i]; });
}
SUFFUSE_INLINE QuadMask not_(const QuadMask &m)
{
    return quadMaskOf([&](int i) { return !m.m[i]; });
}
SUFFUSE_INLINE Quad select_(const QuadMask &m, const Quad &a, const Quad &b)
{
    return quadOf([&](int i) { return m.m[i] ? a.v[i] : b.v[i]; });
}

} // namespace suffuse::math
