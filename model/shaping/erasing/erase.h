// Cuts strokes, for the eraser and the knife.
#pragma once

#include "model/shaping/nodes/reshape.h"

#include <limits>

namespace suffuse {

/// What is left of a stroke without the parts whose curve is nearer than `radius` to a path (of one point: in a disc).
/// The result has a stroke for each run of segments, cut by exact splits where the distance is the radius. All have the
/// id of the stroke, which the caller gives to one of them. The result is {stroke} where nothing is touched, and empty
/// where nothing is left. Segments that are not cut keep their bits. `sources` gets, for the segments of all runs one
/// after the other, the index of the segment that each came from. Segments that are painted after document time T stay,
/// and so do those that take paint away.
std::vector<Stroke> erased(const Stroke &stroke, const std::vector<Point> &path, double radius,
                           std::vector<int> *sources = nullptr,
                           Microseconds T = std::numeric_limits<Microseconds>::max());

/// The same as one stroke whose chains are the runs. What is left then mixes as before, and the picture changes only
/// where the removed part reached. No value where nothing is left that lays paint. A fill is cut out, too, if it is
/// there at T (model/shaping/erasing/fill_cut.h); if it comes later, it keeps its outline, which loses its paint.
std::optional<Stroke> erasedInOne(const Stroke &stroke, const std::vector<Point> &path, double radius,
                                  std::vector<int> *sources = nullptr,
                                  Microseconds T = std::numeric_limits<Microseconds>::max());
/// The stroke without some of its segments; behind a gap a new chain begins, and a fill ends at a straight line. No
/// value where nothing is left that lays paint. `sources` is filled as by `erased`.
std::optional<Stroke> withoutSegments(const Stroke &stroke, const std::vector<int> &gone,
                                      std::vector<int> *sources = nullptr);

/// The stroke of some of its segments alone, each run of them a chain, without the fill unless these are all. What only
/// bounded the fill gets paint (`withoutFill`). No value where they lay no paint.
std::optional<Stroke> withSegmentsOnly(const Stroke &stroke, const std::vector<int> &kept);

/// Returns false where the boxes alone show that the eraser leaves a stroke as it is.
bool mayErase(const Stroke &stroke, const std::vector<Point> &path, double radius);

/// Where the line from a to b crosses the curve, in order along the stroke. The ends of its chains are left out; an
/// inner node is named as p = 0 of the segment behind it.
std::vector<CurvePlace> crossings(const Stroke &stroke, Point a, Point b);

/// Cuts the stroke into strokes at places, by exact splits. All have its id, which the caller gives to one of them.
std::vector<Stroke> cutAt(const Stroke &stroke, const std::vector<CurvePlace> &places);
/// Cuts the stroke into chains at places, which leaves the picture as it is. `sources` is filled as by `erased`, with
/// −1 for what bounds the parts of a fill anew.
Stroke cutInOne(const Stroke &stroke, const std::vector<CurvePlace> &places, std::vector<int> *sources = nullptr);

} // namespace suffuse
