// What of a painting is passed to an extension, and how what comes back is put into the whole.
#pragma once

#include "app/extensions/extension.h"
#include "model/painting/painting.h"
#include "model/result.h"

#include <set>

namespace suffuse {

/// The ids of the strokes that are passed: all, those that are selected, or those in a group (0: all). Of the selection
/// and of a layer only those that are visible and unlocked, as with any edit.
std::set<StrokeId> passedStrokes(const Painting &whole, Extension::Passes passes, const std::set<StrokeId> &selected,
                                 GroupId layer);
/// The painting with these strokes alone. Canvas, groups, swatches and underlay are there as well.
Painting partOf(const Painting &whole, const std::set<StrokeId> &strokes);

/// The whole with what became of a part: strokes that are missing go, others change, new ones come above the stroke
/// that they follow in the result; ids that strokes have which were not passed are replaced. Where the part is not all,
/// its canvas, palette and underlay must be as they were.
Result<Painting> withPart(const Painting &whole, const std::set<StrokeId> &passed, Painting result);

} // namespace suffuse
