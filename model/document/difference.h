// What differs between two paintings, as values.
#pragma once

#include "model/painting/painting.h"

#include <QString>

#include <vector>

namespace suffuse {

/// What differs between two paintings, by the identities of their strokes. It takes little time where the paintings
/// share strokes: of two snapshots of one document it compares only what was touched.
struct PaintingDifference {
    std::vector<StrokeId> added;   ///< strokes that are only in the second, in its order
    std::vector<StrokeId> removed; ///< strokes that are only in the first, in its order
    std::vector<StrokeId> changed; ///< strokes that are in both with other values, in the second's order
    /// as few strokes as possible, of those in both, without which the others stand in the same order
    std::vector<StrokeId> moved;
    bool canvas = false;
    bool groups = false;
    bool swatches = false;
    bool underlay = false;

    bool isEmpty() const
    {
        return added.empty() && removed.empty() && changed.empty() && moved.empty() && !canvas && !groups &&
               !swatches && !underlay;
    }
};
PaintingDifference differenceOf(const Painting &before, const Painting &after);

/// One value that differs. Paths and values are those of the text form (docs/text-form.md): "segments[3].diffusion" and
/// "12.5". A value is empty where one side does not have it.
struct ValueDifference {
    QString path;
    QString before;
    QString after;
    friend bool operator==(const ValueDifference &, const ValueDifference &) = default;
};

/// What differs between two states of a stroke. Segments that are equal at its start and at its end are left out. Those
/// between are compared one by one, and the last ones of the longer side count as added or removed.
struct StrokeDifference {
    std::vector<std::size_t> added;   ///< places in the second state
    std::vector<std::size_t> removed; ///< places in the first state
    std::vector<std::size_t> changed; ///< places in the second state
    /// values of the stroke, then of the changed segments by their places in the second state
    std::vector<ValueDifference> values;
};
StrokeDifference differenceOf(const Stroke &before, const Stroke &after);

/// The values of canvas, groups (named by their ids), swatches and underlay that differ. Images are named by size and
/// hash.
std::vector<ValueDifference> valuesThatDiffer(const Painting &before, const Painting &after);

} // namespace suffuse
