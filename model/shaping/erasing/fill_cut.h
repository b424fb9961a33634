// Cuts strokes that are filled, so that the area falls into pieces along the cut and is whole but for that.
#pragma once

#include "model/shaping/nodes/reshape.h"

namespace suffuse {

// A fill lies within the closed chains of its stroke. Where its outline is cut, the chains of the result are those of
// the pieces: each follows the outline up to the cut, then the cut, and so on until it comes back to its start. What is
// new in an outline has density 0 and is a segment only where no straight line closes a chain by itself. It does not
// matter where a chain began. Chains that are not cut keep their bits, segments that take paint away stay. `sources`
// gets for each segment of the result the segment that it came from, −1 where it is new.

/// Cuts along the line from a to b, which leaves area and paint as they are. The outline is cut where the line goes
/// into the area and comes out of it, both within its length.
Stroke filledCut(const Stroke &stroke, Point a, Point b, std::vector<int> *sources = nullptr);
/// The places of the outline that this cuts, in order; those of straight lines that close chains are left out.
std::vector<CurvePlace> filledCutPlaces(const Stroke &stroke, Point a, Point b);

/// Takes out what is nearer than `radius` to a path: of the outline, and of the area. No value where nothing is left.
/// A stroke that is not touched is the same to the last bit.
std::optional<Stroke> filledErased(const Stroke &stroke, const std::vector<Point> &path, double radius,
                                   std::vector<int> *sources = nullptr);

/// Cuts the outline at places, which leaves area and paint as they are.
Stroke filledCutAt(const Stroke &stroke, const std::vector<CurvePlace> &places, std::vector<int> *sources = nullptr);

/// Takes segments out of the outline; straight lines bound the area instead. No value where nothing is left that lays
/// paint or bounds the area.
std::optional<Stroke> filledWithout(const Stroke &stroke, const std::vector<int> &gone,
                                    std::vector<int> *sources = nullptr);

} // namespace suffuse
