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

/// What styles act on at a sample.
template <class V>
struct Modulated {
    V phi;     ///< φ′ = γφ; below 0 where more paint is lifted than lies there
    V h2;      ///< square of h = ½γ|∇φ|px
    V inverse; ///< 1/φ⁺ where something varies along the stroke or φ⁺ has its channel, else 0
    V lifted;  ///< 2φ⁻/φ⁺, at most 1, where φ⁺ has its channel, else 0
};

/// F = Σ_kind share·F_kind(φ′; ξ̄_kind) where segments of a stroke have different styles. `channel(i)`: its sum.
template <class V, class Channel>
SUFFUSE_INLINE V mixedStyles(const ShadeParams &params, Channel channel, const Modulated<V> &m)
{
    V total(0);
    for (int k = 0; k < params.kinds; ++k) {
        const KindParams &kind = params.kind[k];
        const bool only = kind.shareChannel < 0;
        // Without paint ξ̄ is nothing, and would show what is lifted.
        const V share = !only                ? channel(kind.shareChannel) * m.inverse
                        : kind.xiChannel < 0 ? V(1)
                                             : select_(less_(V(0), channel(kind.xiChannel)), V(1), V(0));
        const V weight = only ? m.inverse : V(1) / max_(channel(kind.shareChannel), V(1e-36));
        const auto xi = [&](int i) {
            return kind.xiChannel < 0 ? V(kind.xi[i])
                                      : min_(max_(channel(kind.xiChannel + i) * weight, V(1e-30)), V(1e18));
        };
        const V f =
            withStyle<V>(kind.kind, xi, [&](const auto &style) { return meanWhere(style, m.phi, m.h2, m.lifted); });
        total = total + select_(less_(V(0), share), share * f, V(0));
    }
    return total;
}

/// Whether anything varies along the stroke, or φ⁺ has its channel.
SUFFUSE_INLINE bool usesChannels(const ShadeParams &params)
{
    return params.colourChannel >= 0 || params.lineChannel >= 0 || params.grainChannel >= 0 || params.kinds > 1 ||
           params.kind[0].xiChannel >= 0 || params.laidChannel >= 0;
}

template <class V>
SUFFUSE_INLINE V inverseDensity(V density)
{
    return reciprocal_(min_(max_(density, V(1e-36)), V(1e18)));
}

/// φ⁺.
template <class V, class Channel>
SUFFUSE_INLINE V laidOf(const ShadeParams &params, V density, Channel channel)
{
    return params.laidChannel < 0 ? density : channel(params.laidChannel);
}

/// `gx`, `gy`: −½ of the gradient per pixel; `step`: the sample's size in pixels; `eta`: paper (1: none).
template <class V, class Channel>
SUFFUSE_INLINE Modulated<V> modulate(const ShadeParams &params, V density, V gx, V gy, Channel channel, V eta, V step)
{
    const V phi = min_(density, V(1e18));
    V inverse(0), lifted(0);
    if (usesChannels(params))
        inverse = inverseDensity(laidOf(params, density, channel));
    if (params.laidChannel >= 0) {
        const V laid = channel(params.laidChannel);
        lifted = min_(max_(V(2) * (laid - density) * inverse, V(0)), V(1));
    }
    if (params.grainChannel < 0 && params.grain == 1) // γ = 1
        return {phi, min_(step * step * mulAdd_(gx, gx, gy * gy), V(1e36)), inverse, lifted};
    const V grain = params.grainChannel < 0 ? V(params.grain) : min_(channel(params.grainChannel) * inverse, V(1));
    const V gamma = mulAdd_(V(1) - grain, eta, grain), width = step * gamma;
    return {gamma * phi, min_(width * width * mulAdd_(gx, gx, gy * gy), V(1e36)), inverse, lifted};
}

/// `f`: the coverage mean of F.
template <class V, class Channel>
SUFFUSE_INLINE Paint<V> paintOf(const ShadeParams &params, V inverse, Channel channel, V f)
{
    const int c = params.colourChannel, line = params.lineChannel;
    V place(0);
    if (line >= 0)
        place = min_(channel(line) * inverse, V(1));
    const auto mean = [&](int i, float from, float to) {
        if (c >= 0)
            return min_(channel(c + i) * inverse, V(1));
        return line < 0 ? V(from) : mulAdd_(place, V(to - from), V(from));
    };
    const Colour &from = params.colour, &to = params.colourEnd;
    V w = f * mean(3, from.opacity, to.opacity);
    if (params.fadeChannel >= 0) // Where nothing fades it is times 1, to the bit.
        w = w * exp2_(V(-log2e) * channel(params.fadeChannel));
    return {w, mean(0, from.red, to.red), mean(1, from.yellow, to.yellow), mean(2, from.blue, to.blue)};
}

/// One style for the whole stroke: made once, used for all samples.
SUFFUSE_INLINE bool hasOneStyle(const ShadeParams &params)
{
    return params.kinds == 1 && params.kind[0].xiChannel < 0;
}

} // namespace suffuse::SUFFUSE_MATH
SUFFUSE_MATH_END

#endif
