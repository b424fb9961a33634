// How the picture of a layer is put on what lies below it: W3C Compositing and Blending Level 1, on sRGB-encoded values
// (docs/solver.md, "Groups that blend").
#if defined(SUFFUSE_RENDER_MATH_BLEND_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_MATH_BLEND_H
#undef SUFFUSE_RENDER_MATH_BLEND_H
#else
#define SUFFUSE_RENDER_MATH_BLEND_H
#endif

#include "render/math/colour.h"
#include "render/math/layer_put.h"

SUFFUSE_MATH_BEGIN
namespace suffuse::SUFFUSE_MATH {

/// The inverse of rgbFromRyb.
template <class V>
SUFFUSE_INLINE Triple<V> rybFromRgb(V red, V green, V blue)
{
    const V white = min_(red, min_(green, blue)), black = min_(V(1) - red, min_(V(1) - green, V(1) - blue));
    const V r = red - white, g = green - white, b = blue - white;
    const V m = min_(r, g);
    const V r1 = r - m, y1 = V(0.5) * (g + m), b1 = V(0.5) * (b + g - m);
    const V before = max_(r, max_(g, b)), after = max_(r1, max_(y1, b1));
    const V scale = select_(less_(V(0), after), before * reciprocal_(max_(after, V(1e-30))), V(1));
    const V zero(0), one(1);
    return {min_(one, max_(zero, r1 * scale + black)), min_(one, max_(zero, y1 * scale + black)),
            min_(one, max_(zero, b1 * scale + black))};
}

template <class V>
SUFFUSE_INLINE V hardLight(V below, V above)
{
    const V twice = V(2) * above, over = twice - V(1);
    return select_(less_(V(0.5), above), below + over - below * over, below * twice);
}

/// Dodging and burning divide by less than this nowhere. The recommendation divides by all but 0, where it jumps from 0
/// to 1: there rounding would decide between black and white. This is half a level of 8 bits.
constexpr double leastDivisor = 1.0 / 512;

/// The separable blend functions, of one channel.
template <class V>
SUFFUSE_INLINE V blendedChannel(BlendMode mode, V below, V above)
{
    const V one(1), least(leastDivisor);
    switch (mode) {
    case BlendMode::Multiply:
        return below * above;
    case BlendMode::Screen:
        return below + above - below * above;
    case BlendMode::Overlay:
        return hardLight(above, below);
    case BlendMode::Darken:
        return min_(below, above);
    case BlendMode::Lighten:
        return max_(below, above);
    case BlendMode::ColourDodge:
        return min_(one, below * reciprocal_(max_(one - above, least)));
    case BlendMode::ColourBurn:
        return one - min_(one, (one - below) * reciprocal_(max_(above, least)));
    case BlendMode::HardLight:
        return hardLight(below, above);
    case BlendMode::SoftLight: {
        const V quarter(0.25), dark = below * mulAdd_(below, mulAdd_(V(16), below, V(-12)), V(4));
        const V light = select_(less_(quarter, below), quickRoot_(max_(quarter, below)), dark);
        const V slope = mulAdd_(V(2), above, V(-1));
        return mulAdd_(slope, select_(less_(V(0), slope), light - below, below - below * below), below);
    }
    case BlendMode::Difference:
        return abs_(below - above);
    case BlendMode::Exclusion:
        return below + above - V(2) * below * above;
    default:
        return above;
    }
}

template <class V>
SUFFUSE_INLINE V luminosity(const Triple<V> &c)
{
    return mulAdd_(V(0.3), c.x, mulAdd_(V(0.59), c.y, V(0.11) * c.z));
}

template <class V>
SUFFUSE_INLINE V saturation(const Triple<V> &c)
{
    return max_(c.x, max_(c.y, c.z)) - min_(c.x, min_(c.y, c.z));
}

/// A colour moved to another luminosity, and brought into gamut towards grey.
template <class V>
SUFFUSE_INLINE Triple<V> withLuminosity(const Triple<V> &colour, V wanted)
{
    const V shift = wanted - luminosity(colour);
    const Triple<V> c{colour.x + shift, colour.y + shift, colour.z + shift};
    const V least = min_(c.x, min_(c.y, c.z)), most = max_(c.x, max_(c.y, c.z)), tiny(1e-30), one(1);
    // No colour is out of gamut on both sides, since its channels are at most 1 apart.
    const auto dark = less_(least, V(0)), bright = less_(one, most);
    const V room = select_(dark, wanted, one - wanted), reach = select_(dark, wanted - least, most - wanted);
    const V keep = select_(or_(dark, bright), min_(one, room * reciprocal_(max_(reach, tiny))), one);
    return {mulAdd_(c.x - wanted, keep, wanted), mulAdd_(c.y - wanted, keep, wanted),
            mulAdd_(c.z - wanted, keep, wanted)};
}

/// A colour of the same hue with another saturation. Grey stays black, since it has no hue.
template <class V>
SUFFUSE_INLINE Triple<V> withSaturation(const Triple<V> &c, V wanted)
{
    const V least = min_(c.x, min_(c.y, c.z)), range = saturation(c);
    const V scale = select_(less_(V(0), range), wanted * reciprocal_(max_(range, V(1e-30))), V(0));
    return {(c.x - least) * scale, (c.y - least) * scale, (c.z - least) * scale};
}

/// B(Cb, Cs) of the blend modes; for the operators it is Cs.
template <class V>
SUFFUSE_INLINE Triple<V> blendedColour(BlendMode mode, const Triple<V> &below, const Triple<V> &above)
{
    switch (mode) {
    case BlendMode::Hue:
        return withLuminosity(withSaturation(above, saturation(below)), luminosity(below));
    case BlendMode::Saturation:
        return withLuminosity(withSaturation(below, saturation(above)), luminosity(below));
    case BlendMode::Colour:
        return withLuminosity(above, luminosity(below));
    case BlendMode::Luminosity:
        return withLuminosity(below, luminosity(above));
    default:
        return {blendedChannel(mode, below.x, above.x), blendedChannel(mode, below.y, above.y),
                blendedChannel(mode, below.z, above.z)};
    }
}

/// A pixel while strokes are mixed into it: RYB over the canvas, or over white, and the coverage.
template <class V>
struct Pixel {
    V red, yellow, blue, coverage;
};

/// A straight channel from one over white.
template <class V>
SUFFUSE_INLINE V straight(V overWhite, V coverage, V inverse)
{
    return min_(V(1), max_(V(0), (overWhite - (V(1) - coverage)) * inverse));
}

/// What a layer and what lies below it cover together, by the layer's mode.
template <class V>
SUFFUSE_INLINE V coverageWith(BlendMode mode, V source, V below)
{
    switch (mode) {
    case BlendMode::DestinationIn:
        return source * below;
    case BlendMode::DestinationOut:
        return (V(1) - source) * below;
    case BlendMode::SourceAtop:
        return below;
    case BlendMode::Plus:
        return min_(V(1), source + below);
    default:
        return mulAdd_(V(1) - source, below, source);
    }
}

/// RGB over white as a pixel, where a layer shows something; otherwise what lies below keeps its bits.
template <class V>
SUFFUSE_INLINE Pixel<V> finished(const V (&rgb)[3], V coverage, V source, const Pixel<V> &below)
{
    const auto within = [](V c) { return min_(V(1), max_(V(0), c)); };
    const auto shows = less_(V(0), source);
    const Triple<V> ryb = rybFromRgb(within(rgb[0]), within(rgb[1]), within(rgb[2]));
    return {select_(shows, ryb.x, below.red), select_(shows, ryb.y, below.yellow), select_(shows, ryb.z, below.blue),
            select_(shows, coverage, below.coverage)};
}

/// A pixel as RGB over the canvas, or over white, and its coverage.
template <class V>
struct RgbPixel {
    V rgb[3];
    V coverage;
};

/// A layer of straight colour `cs` and coverage `source` put on what lies below. The result is not clamped.
template <class V>
SUFFUSE_INLINE RgbPixel<V> putStraight(const LayerPut &how, V source, const Triple<V> &cs, const RgbPixel<V> &below)
{
    const V one(1), tiny(1e-30), ground = below.coverage, s[3] = {cs.x, cs.y, cs.z};
    RgbPixel<V> out{{below.rgb[0], below.rgb[1], below.rgb[2]}, coverageWith(how.mode, source, ground)};
    if (how.mode == BlendMode::DestinationIn || how.mode == BlendMode::DestinationOut) {
        const V kept = how.mode == BlendMode::DestinationIn ? source : one - source;
        for (int c = 0; c < 3; ++c)
            out.rgb[c] = mulAdd_(kept, out.rgb[c] - V(how.bare[c]), V(how.bare[c]));
        return out;
    }
    if (how.mode == BlendMode::Normal) {
        for (int c = 0; c < 3; ++c)
            out.rgb[c] = mulAdd_(one - source, out.rgb[c], source * s[c]);
        return out;
    }
    if (how.mode == BlendMode::Plus) {
        // Over white both leave as much of it as is not covered, which is counted twice where they overlap.
        const V spare = how.opaque ? V(0) : source + ground - out.coverage - source;
        for (int c = 0; c < 3; ++c)
            out.rgb[c] = min_(one, mulAdd_(source, s[c], out.rgb[c]) + spare);
        return out;
    }
    Triple<V> cb{below.rgb[0], below.rgb[1], below.rgb[2]};
    if (!how.opaque) {
        const V inverse = reciprocal_(max_(ground, tiny));
        cb = {straight(cb.x, ground, inverse), straight(cb.y, ground, inverse), straight(cb.z, ground, inverse)};
    }
    if (how.mode == BlendMode::SourceAtop) {
        const V b[3] = {cb.x, cb.y, cb.z};
        for (int c = 0; c < 3; ++c)
            out.rgb[c] = mulAdd_(source * ground, s[c] - b[c], out.rgb[c]);
        return out;
    }
    const Triple<V> blended = blendedColour(how.mode, cb, cs);
    const V mixed[3] = {blended.x, blended.y, blended.z};
    for (int c = 0; c < 3; ++c) {
        const V target = how.opaque ? mixed[c] : mulAdd_(ground, mixed[c] - s[c], s[c]);
        out.rgb[c] = mulAdd_(source, target - out.rgb[c], out.rgb[c]);
    }
    return out;
}

/// The straight colour of a layer's pixel.
template <class V>
SUFFUSE_INLINE Triple<V> straightColour(const RgbPixel<V> &layer)
{
    const V inverse = reciprocal_(max_(layer.coverage, V(1e-30)));
    return {straight(layer.rgb[0], layer.coverage, inverse), straight(layer.rgb[1], layer.coverage, inverse),
            straight(layer.rgb[2], layer.coverage, inverse)};
}
template <class V>
SUFFUSE_INLINE Triple<V> straightColour(const Pixel<V> &layer)
{
    const Triple<V> over = rgbFromRyb(layer.red, layer.yellow, layer.blue);
    return straightColour(RgbPixel<V>{{over.x, over.y, over.z}, layer.coverage});
}

/// What a layer shows at a pixel, put on what lies below with an opacity: the layer's, times what its bounds let
/// through. Where it shows nothing, what lies below keeps its bits, unless the mode acts there, too.
template <class V>
SUFFUSE_INLINE Pixel<V> put(const LayerPut &how, V opacity, const Pixel<V> &layer, const Pixel<V> &below)
{
    const V one(1), source = layer.coverage * opacity;
    const Triple<V> rgb = rgbFromRyb(below.red, below.yellow, below.blue);
    const RgbPixel<V> ground{{rgb.x, rgb.y, rgb.z}, below.coverage};
    if (how.mode == BlendMode::DestinationIn || how.mode == BlendMode::DestinationOut) {
        const RgbPixel<V> out = putStraight(how, source, {one, one, one}, ground);
        const auto stays = not_(less_(how.mode == BlendMode::DestinationIn ? source : one - source, one));
        const Triple<V> ryb = rybFromRgb(out.rgb[0], out.rgb[1], out.rgb[2]);
        return {select_(stays, below.red, ryb.x), select_(stays, below.yellow, ryb.y),
                select_(stays, below.blue, ryb.z), select_(stays, below.coverage, out.coverage)};
    }
    if (how.mode == BlendMode::Normal) { // Without dividing: α_s·C_s is what the layer has over white, less the white.
        const Triple<V> over = rgbFromRyb(layer.red, layer.yellow, layer.blue);
        const V white = one - layer.coverage, s[3] = {over.x, over.y, over.z};
        V out[3] = {rgb.x, rgb.y, rgb.z};
        for (int c = 0; c < 3; ++c)
            out[c] = mulAdd_(one - source, out[c], opacity * min_(layer.coverage, max_(V(0), s[c] - white)));
        return finished(out, coverageWith(how.mode, source, below.coverage), source, below);
    }
    const RgbPixel<V> out = putStraight(how, source, straightColour(layer), ground);
    return finished(out.rgb, out.coverage, source, below);
}

} // namespace suffuse::SUFFUSE_MATH
SUFFUSE_MATH_END

#endif
