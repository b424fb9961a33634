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
};

/// Of the chosen segments; `chosen` empty: of all. What takes paint away is left out, unless there is nothing else.
Appearance appearanceOf(const Stroke &stroke, const std::vector<bool> &chosen = {});

/// What becomes of values that differ from segment to segment.
enum class Variation {
    Kept, ///< D, φ and t_max are multiplied, ω and the colour are added to, so that the means are those that are taken
    Levelled ///< every segment has the values that are taken
};

/// The stroke with the appearance. Style and mixing belong to the stroke: where not all of it is chosen, the chosen
/// segments get the style as their own, and the mixing stays.
Stroke withAppearance(const Stroke &stroke, const Appearance &appearance, Variation variation,
                      const std::vector<bool> &chosen = {});

} // namespace suffuse
