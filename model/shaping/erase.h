// Cutting strokes: the eraser and the knife.
#pragma once

#include "model/shaping/reshape.h"

#include <limits>

namespace suffuse {

/// What is left of a stroke where the curve comes nearer than `radius` to a path (one point: a disc): runs of segments,
/// cut by exact splits where the distance is the radius. All have the stroke's id, which the caller gives to one of
/// them. {stroke} where nothing is touched; empty where nothing is left. Segments that are not cut keep their bits.
/// `sources`: for the segments of all runs, one after the other, the index of that each came from. Segments that are
/// painted after document time T stay, and so do those that take paint away.
std::vector<Stroke> erased(const Stroke &stroke, const std::vector<Point> &path, double radius,
                           std::vector<int> *sources = nullptr,
                           Microseconds T = std::numeric_limits<Microseconds>::max());

/// The same as one stroke, whose chains are the runs: so what is left mixes as before, and the picture changes only
/// where the removed part reached. None where nothing is left that lays paint.
std::optional<Stroke> erasedInOne(const Stroke &stroke, const std::vector<Point> &path, double radius,
                                  std::vector<int> *sources = nullptr,
                                  Microseconds T = std::numeric_limits<Microseconds>::max());
/// The stroke without some segments, what follows a gap being another chain. None as above. `sources` as above.
std::optional<Stroke> withoutSegments(const Stroke &stroke, const std::vector<int> &gone,
                                      std::vector<int> *sources = nullptr);

/// False where the eraser surely leaves a stroke as it is, by boxes alone.
bool mayErase(const Stroke &stroke, const std::vector<Point> &path, double radius);

/// Where the line from a to b crosses the curve, in order along the stroke; the ends of its chains are left out, an
/// inner node comes as p = 0 of the segment after it.
std::vector<CurvePlace> crossings(const Stroke &stroke, Point a, Point b);

/// The stroke cut into strokes at places: exact splits; all have its id, which the caller gives to one of them.
std::vector<Stroke> cutAt(const Stroke &stroke, const std::vector<CurvePlace> &places);
/// The stroke cut into chains at places; the picture stays. `sources` as above.
Stroke cutInOne(const Stroke &stroke, const std::vector<CurvePlace> &places, std::vector<int> *sources = nullptr);

} // namespace suffuse
