// Whether strokes keep how their values vary.
#pragma once

#include "model/painting/stroke.h"

#include <cmath>

namespace suffuse {

/// Whether all ratios between the values of two states of a stroke are this one, up to the rounding of float32.
inline bool areScaled(const Stroke &before, const Stroke &after, float Segment::*member, double factor)
{
    for (std::size_t k = 0; k < before.segments.size(); ++k)
        if (std::abs(double(after.segments[k].*member) / double(before.segments[k].*member) / factor - 1) > 1e-6)
            return false;
    return before.segments.size() == after.segments.size();
}

} // namespace suffuse
