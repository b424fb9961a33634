// What the attribute brush does to a segment's values; nothing here knows about a window.
#pragma once

#include "model/painting/segment.h"

#include <array>

namespace suffuse {

enum class Attribute { Diffusion, Density, Granulation, Colour, Opacity, MaxAge };
inline constexpr std::array allAttributes{Attribute::Diffusion, Attribute::Density, Attribute::Granulation,
                                          Attribute::Colour,    Attribute::Opacity, Attribute::MaxAge};

/// Quantities whose steps are ratios (D, φ, t_max): relative means times. The others: relative means plus.
bool isRatio(Attribute attribute);

/// What is painted.
struct AttributeWish {
    Attribute attribute = Attribute::Density;
    bool relative = false;
    double value = 1; ///< what it goes to; relative: the factor, or what is added; unused for an absolute colour
    Colour colour;    ///< for Attribute::Colour: what it goes to; relative: `value` times this is added
};

/// How much of a wish a place at `distance` from the middle of the brush gets: 1 there, falling to 0 at `radius` as a
/// cosine does.
double falloff(double distance, double radius);

/// The segment with `share` (0 … 1) of the wish: ratios are gone through evenly in their logarithm. Stays in the
/// domain; what share 0 gives is the segment itself.
Segment withAttribute(const Segment &segment, const AttributeWish &wish, double share);

} // namespace suffuse
