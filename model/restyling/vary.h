// Random variation of what a selection is painted with.
#pragma once

#include "model/painting/stroke.h"

#include <cstdint>
#include <vector>

namespace suffuse {

/// How far values stray, each way. The same seed gives the same result.
struct VaryAmounts {
    enum Per {
        EachStroke,  ///< one random value for each stroke
        EachSegment, ///< one for each segment
        Along        ///< values that drift smoothly along each stroke
    };

    double diffusion = 0;   ///< D is multiplied or divided by up to 1 + this
    double density = 0;     ///< φˢ likewise
    double maxAge = 0;      ///< t_max likewise
    double granulation = 0; ///< ω strays by up to this
    double hue = 0;         ///< up to so many radians about the axis of greys
    double lightness = 0;   ///< red, yellow and blue all together stray by up to this
    double opacity = 0;
    Per per = EachStroke;
    double length = 60; ///< of Along: the length over which values become others, canvas units
    std::uint32_t seed = 1;
};

/// The stroke with its values varied; curves, times and styles stay. `chosen`: for each segment whether it is meant;
/// empty: all are. A fill strays, too, where all of the stroke is meant, or nothing but what bounds the fill.
Stroke varied(const Stroke &stroke, const VaryAmounts &amounts, const std::vector<bool> &chosen);

/// The colour turned about the axis of greys (red towards yellow towards blue), within its domain.
Colour withHueTurned(const Colour &colour, double radians);

} // namespace suffuse
