// How a stroke looks, apart from where it runs: copied from one stroke and put on others.
#pragma once

#include "model/painting/stroke.h"

#include <vector>

namespace suffuse {

/// Values that stand for a stroke whose segments differ: geometric means of D, φ and t_max, arithmetic means of ω and
/// the colour, weighted by length.
struct Appearance {
    Style style;
    Mix mix;
    double diffusion = 0;           ///< D
    double density = 0;             ///< φˢ
    double granulation = 0;         ///< ω
    double maxAge = 0;              ///< t_max
    std::array<double, 4> colour{}; ///< red, yellow, blue, opacity
    SharedFill fill;                ///< if all of the stroke is meant, or what only bounds its fill
    bool isFillAlone = false;       ///< the values are those of the fill; the density is 0
    Rect outline;                   ///< the box of what the fill lies in, in which its gradient has its place
};

/// Of the chosen segments; `chosen` empty: of all. What takes paint away is left out, unless there is nothing else.
Appearance appearanceOf(const Stroke &stroke, const std::vector<bool> &chosen = {});

/// What becomes of values that differ from segment to segment.
enum class Variation {
    Kept, ///< D, φ and t_max are multiplied, ω and the colour are added to, so that the means are those that are taken
    Levelled ///< every segment has the values that are taken
};

/// The stroke with the appearance. A fill takes that of the other fill or, where there is none, the colour and the values
/// of the paint, and what only bounds it goes on laying none. A stroke that has paint alone is filled if the other one
/// has both. Style and mixing belong to the stroke: where not all of it is chosen, the chosen
/// segments get the style as their own, and the mixing stays.
Stroke withAppearance(const Stroke &stroke, const Appearance &appearance, Variation variation,
                      const std::vector<bool> &chosen = {});

} // namespace suffuse
