// How one stroke turns density sums into opacity and colour: plain data, shared by all backends.
#pragma once

#include "model/painting/style.h"
#include "render/math/compat.h"

namespace suffuse {

/// Sums at a sample: φ, −½∂φ/∂x, −½∂φ/∂y (per pixel), then Σφ_k·value for each channel. Where segments take paint away
/// φ is φ⁺ − φ⁻, which may lie below 0, and the channels are sums over the others.
inline constexpr int fixedSums = 3;
inline constexpr int maxChannels = 17; ///< colour 4, granulation 1, shares 3, ξ 7, φ⁺ 1, φ_f 1

/// Nodes that make paint paler stand among the others, but have only 2^−80 of their weight: that much counts for
/// nothing in sums of density. Their channel, φ_f, has it back. Both are exact, since they are powers of two.
inline constexpr float fadeUnit = 1208925819614629174706176.0f; ///< 2^80

/// A level of supersampling (docs/reference.md) is divided into so many parts by the spread.
inline constexpr int levelQuarters = 4;

/// How one kind of style of a stroke is evaluated: from constants, or from channels where segments differ.
struct KindParams {
    StyleKind kind = StyleKind::Uniform;
    /// What would be padding with any content. Records are compared by their bytes before they go to a device.
    unsigned char zeros[3] = {0, 0, 0};
    float xi[3] = {0, 0, 0};
    int xiChannel = -1;    ///< Σφξ1, Σφξ2 (, Σφξ3) from this channel on; −1: constant `xi`
    int shareChannel = -1; ///< Σφ over the segments of this kind; −1: it is the only kind
};

struct ShadeParams {
    int kinds = 1;
    KindParams kind[3];
    int colourChannel = -1; ///< four of them; −1: constant `colour`, or
    int lineChannel = -1;   ///< one: the place between `colour` and `colourEnd`
    Colour colour;
    Colour colourEnd;
    int grainChannel = -1; ///< −1: constant `grain`
    float grain = 1;
    int laidChannel = -1; ///< φ⁺, where segments take paint away and it is asked for; −1: φ stands for it
    int fadeChannel = -1; ///< φ_f, the last channel: e^−φ_f of the opacity is left; −1: nothing fades
};

/// True only if F is zero for all densities and h up to these. `level`: the style's.
SUFFUSE_INLINE bool vanishes(StyleKind kind, float level, float phi, float h)
{
    if (kind != StyleKind::Edge)
        return phi + h <= level;
    // φ e^min(h/φ, 2) is greatest at the ends of the range, or where h/φ = 2. e^q from above, as 1 + q + … + q⁴/12.
    const float q = h < 0.5f * phi ? h / phi : 2.0f;
    const float e = q < 0.5f ? 1 + q * (1 + q * (0.5f + q * (1.0f / 6 + q / 12))) : 7.3890561f;
    return phi * e <= level && 7.3890561f * (phi < 0.5f * h ? phi : 0.5f * h) <= level;
}

/// The same for one of a stroke's kinds; `phi` is a bound of φ⁺.
SUFFUSE_INLINE bool vanishes(const ShadeParams &params, int kind, float level, float phi, float h)
{
    // Where paint is lifted edge darkening takes its mean over φ ± h, too.
    return vanishes(params.kind[kind].kind, level, phi, h) && (params.laidChannel < 0 || phi + h <= level);
}

} // namespace suffuse
