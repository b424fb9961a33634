// Runs of selected segments, and values that are set along their arc length.
#pragma once

#include "app/widgets/numbers/quantity.h"
#include "model/document/document.h"

#include <functional>
#include <map>

namespace suffuse {

/// A segment of a run; `place` says where its middle lies along the run, [0, 1].
struct RunPlace {
    int segment = 0;
    double place = 0;
};

/// A stroke, and those of its segments that are to be set. The run goes from the first of them to the last. Segments in
/// between that are not to be set count only for its length.
struct StrokeRun {
    StrokePtr stroke;
    std::vector<RunPlace> places;
};
using StrokeRuns = std::map<StrokeId, StrokeRun>;

/// The runs of the document's target segments (see targetSegments), without locked strokes.
StrokeRuns runsOf(const Document &document);
/// The runs with their segments split exactly until they are at most s/2 long, so that values which vary show no steps.
/// Segments stay longer where strokes would get unreasonably heavy.
StrokeRuns refined(const StrokeRuns &runs);

/// The value at a place of a run where `old` was.
using ValueAlong = std::function<double(double place, double old)>;

/// Sets the values in the runs' strokes, each segment's at its place. Selected segments stay selected; of one that was
/// split, all the pieces.
Edit setAlong(const Document &document, const StrokeRuns &runs, const std::map<Quantity, ValueAlong> &values);

} // namespace suffuse
