// How wide the paint of a segment is seen at a moment, and other values for another width.
#pragma once

#include "model/painting/stroke.h"

#include <optional>

namespace suffuse {

/// The visible half-width of a long straight line like the segment, and what it follows from.
struct SeenWidth {
    double width = 0;  ///< half of it, units
    double across = 1; ///< D across the curve, of D
    double cut = 0;    ///< the density from which on paint is seen
    double age = 0;    ///< s; of paint that is not there yet, when it is dry
};

/// Nothing for a style whose paint is seen however thin it is.
std::optional<SeenWidth> seenWidth(const Stroke &stroke, int segment, Microseconds T);

/// Gives the segment, of which `seen` is, another visible half-width: by the density φ, and beyond twice the spread by
/// the diffusion D too; or by D alone.
void setSeenWidth(Segment &segment, const SeenWidth &seen, double halfWidth, bool diffusionAlone = false);

} // namespace suffuse
