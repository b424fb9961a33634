// What the attribute brush does to the values of a segment. This unit knows nothing about windows.
#pragma once

#include "model/painting/fill.h"

#include <array>

namespace suffuse {

enum class Attribute { Diffusion, Density, Granulation, Colour, Opacity, MaxAge };
inline constexpr std::array allAttributes{Attribute::Diffusion, Attribute::Density, Attribute::Granulation,
                                          Attribute::Colour,    Attribute::Opacity, Attribute::MaxAge};

/// Whether a quantity's steps are ratios (D, φ, t_max): a relative change multiplies them. To other quantities it adds.
bool isRatio(Attribute attribute);

/// What the attribute brush paints: a quantity and where it is to go.
struct AttributeWish {
    Attribute attribute = Attribute::Density;
    bool relative = false;
    double value = 1; ///< the value to go to; if relative, the factor or the difference; unused for an absolute colour
    Colour colour;    ///< of Attribute::Colour: the colour to go to; if relative, `value` times this is added
};

/// The share of a wish that a place at `distance` from the middle of the brush gets: 1 in the middle, falling to 0 at
/// `radius` like a cosine.
double falloff(double distance, double radius);

/// Returns the segment with `share` (0 … 1) of the wish. Ratios change evenly in their logarithm. Values stay in their
/// domain, and share 0 returns the segment itself.
Segment withAttribute(const Segment &segment, const AttributeWish &wish, double share);
/// The same for a fill, all of it. A density in absolute numbers is that of a line, and changes nothing.
Fill withAttribute(const Fill &fill, const AttributeWish &wish, double share);

} // namespace suffuse
