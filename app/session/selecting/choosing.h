// Which strokes are selected after a click.
#pragma once

#include "model/painting/painting.h"
#include "model/painting/selection.h"

#include <set>
#include <vector>

namespace suffuse {

/// With the strokes, or without them where the clicked one of them is selected. They are selected whole, or not at all.
Selection toggled(Selection selection, StrokeId clicked, const std::set<StrokeId> &strokes);
/// Without the strokes and their segments.
Selection without(Selection selection, const std::set<StrokeId> &strokes);
/// Of hits from the top down, at least one: the one below the lowest that is selected; from the lowest, the topmost.
std::size_t nextBelow(const std::vector<SegmentRef> &hits, const Selection &selection);
/// How much of a group must be found for the group to be meant.
enum class GroupShare { All, Any };

/// What a band means that has found strokes at T: a stroke in no group, and the outermost group as a whole, as a click
/// does (`withGroup`), where all of its strokes that can be selected at T were found, or any of them. Of a group of
/// which only a part is selected, what stands in it is meant one by one, as is what stands in `outer`, where only what
/// is in that is reached.
std::set<StrokeId> withWholeGroups(const Painting &painting, Microseconds T, const std::set<StrokeId> &found,
                                   const std::set<StrokeId> &selected, GroupShare share, GroupId outer = 0);
/// The stroke that can be selected at T and follows those that are selected, upwards by 1 or downwards by -1, and round
/// the end. 0: there is none.
StrokeId nextStroke(const Painting &painting, Microseconds T, const Selection &selection, int step);

} // namespace suffuse
