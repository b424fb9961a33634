// From density sums at a sample to opacity w = F·C̄_opacity (eq 15-21) and colour C̄.
#if defined(SUFFUSE_RENDER_MATH_SHADE_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_MATH_SHADE_H
#undef SUFFUSE_RENDER_MATH_SHADE_H
#else
#define SUFFUSE_RENDER_MATH_SHADE_H
#endif

#include "render/math/shade_params.h"
#include "render/math/style.h"

SUFFUSE_MATH_BEGIN
namespace suffuse::SUFFUSE_MATH {

template <class V>
struct Paint {
    V w, red, yellow, blue;
};

/// Calls `use` with the style of a kind; `xi(i)` gives ξ(i+1).
template <class V, class Xi, class Use>
SUFFUSE_INLINE auto withStyle(StyleKind kind, Xi xi, Use use)
{
    switch (kind) {
    case StyleKind::Uniform:
        return use(Uniform<V>(xi(0), xi(1)));
    case StyleKind::Feathering:
        return use(Feathering<V>(xi(0), xi(1)));
    case StyleKind::Edge:
        break;
    }
    return use(Edge<V>(xi(0), xi(1), xi(2)));
}

/// F = Σ_kind share·F_kind(φ′; ξ̄_kind) where segments of a stroke have different styles. `channel(i)`: its sum.
template <class V, class Channel>
SUFFUSE_INLINE V mixedStyles(const ShadeParams &params, Channel channel, V inversePhi, V phi, V h)
{
    V total(0);
    for (int k = 0; k < params.kinds; ++k) {
        const KindParams &kind = params.kind[k];
        const bool only = kind.shareChannel < 0;
        const V share = only ? V(1) : channel(kind.shareChannel) * inversePhi;
        const V weight = only ? inversePhi : V(1) / max_(channel(kind.shareChannel), V(1e-36));
        const auto xi = [&](int i) {
            return kind.xiChannel < 0 ? V(kind.xi[i]) : max_(channel(kind.xiChannel + i) * weight, V(1e-30));
        };
        const V f = withStyle<V>(kind.kind, xi, [&](const auto &style) { return style.mean(phi, h); });
        total = total + select_(less_(V(0), share), share * f, V(0));
    }
    return total;
}

/// `gx`, `gy`: gradient per pixel; `halfStep`: half the sample's size in pixels; `eta`: paper (1: none);
/// `factor(1/φ, φ′, h)`: the coverage mean of F.
template <class V, class Channel, class Factor>
SUFFUSE_INLINE Paint<V> shadeSample(const ShadeParams &params, V density, V gx, V gy, Channel channel, V eta, V halfStep,
                                    Factor factor)
{
    const V phi = min_(density, V(1e30)), inverse = V(1) / max_(phi, V(1e-36));
    const V grain =
        params.grainChannel < 0 ? V(params.grain) : min_(channel(params.grainChannel) * inverse, V(1));
    const V gamma = (V(1) - grain) * eta + grain;
    const V h = min_(halfStep * gamma * sqrt_(gx * gx + gy * gy), V(1e30));
    const V f = factor(inverse, gamma * phi, h);
    const int c = params.colourChannel;
    const auto mean = [&](int i, float constant) {
        return c < 0 ? V(constant) : min_(channel(c + i) * inverse, V(1));
    };
    const V w = f * mean(3, params.colour.opacity);
    return {select_(less_(V(0), phi), w, V(0)), mean(0, params.colour.red), mean(1, params.colour.yellow),
            mean(2, params.colour.blue)};
}

/// One style for the whole stroke: made once, used for all samples.
inline bool hasOneStyle(const ShadeParams &params)
{
    return params.kinds == 1 && params.kind[0].xiChannel < 0;
}

} // namespace suffuse::SUFFUSE_MATH
SUFFUSE_MATH_END

#endif
