// Selected runs of segments, and values set along their arc length.
#pragma once

#include "app/widgets/numbers/quantity.h"
#include "model/document/document.h"

#include <functional>
#include <map>

namespace suffuse {

/// A segment of a run; `place` is where its middle lies along the run, [0, 1].
struct RunPlace {
    int segment = 0;
    double place = 0;
};

/// A stroke and the segments of it that are meant; the run goes from the first of them to the last, and those in
/// between that are not meant count for the length alone.
struct StrokeRun {
    StrokePtr stroke;
    std::vector<RunPlace> places;
};
using StrokeRuns = std::map<StrokeId, StrokeRun>;

/// The document's target segments (targetSegments); locked strokes are left out.
StrokeRuns runsOf(const Document &document);
/// With the segments split exactly until they are at most s/2 long, so that values which vary show no steps, as long as
/// that does not make the strokes unreasonably heavy.
StrokeRuns refined(const StrokeRuns &runs);

/// Puts in the runs' strokes, each segment with the values at its place. Selected segments stay selected: all the
/// pieces of those that are split.
Edit setAlong(const Document &document, const StrokeRuns &runs,
              const std::map<Quantity, std::function<double(double place)>> &values);

} // namespace suffuse
