// What differs between two paintings, as values.
#pragma once

#include "model/painting/painting.h"

#include <QString>

#include <vector>

namespace suffuse {

/// What differs between two paintings by the identities of their strokes. Cheap where they share strokes: of two
/// snapshots of one document it compares only what was touched.
struct PaintingDifference {
    std::vector<StrokeId> added;   ///< only in the second, in its order
    std::vector<StrokeId> removed; ///< only in the first, in its order
    std::vector<StrokeId> changed; ///< in both with other values, in the second's order
    std::vector<StrokeId> moved;   ///< of both: as few as can be, if the others keep their turn
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

/// One value that differs. Paths and values are those of the text form (docs/text-form.md): "segments[3].diffusion",
/// "12.5"; a value is empty where one side lacks it.
struct ValueDifference {
    QString path;
    QString before;
    QString after;
    friend bool operator==(const ValueDifference &, const ValueDifference &) = default;
};

/// What differs between two states of a stroke. Segments that are equal at its start and end stand aside; those between
/// are compared in turn, and the longer side's last ones are added or removed.
struct StrokeDifference {
    std::vector<std::size_t> added;      ///< places in the second
    std::vector<std::size_t> removed;    ///< places in the first
    std::vector<std::size_t> changed;    ///< places in the second
    std::vector<ValueDifference> values; ///< of the stroke, then of the changed segments, by their places in the second
};
StrokeDifference differenceOf(const Stroke &before, const Stroke &after);

/// Values of canvas, groups (numbered by their ids), swatches and underlay that differ; images by size and hash.
std::vector<ValueDifference> valuesThatDiffer(const Painting &before, const Painting &after);

} // namespace suffuse
