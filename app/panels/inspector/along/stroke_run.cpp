#include "app/panels/inspector/along/stroke_run.h"

#include "model/brush/stroke_fit.h"
#include "model/painting/editable.h"
#include "model/painting/validate.h"
#include "model/shaping/nodes/reshape.h"
#include "undo/edits.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr int mostPieces = 64;           ///< No segment is split into more pieces than these.
constexpr std::size_t mostCuts = 50'000; ///< All strokes together are not split in more places than these.

double lengthOf(const Stroke &stroke, int segment)
{
    return arcLength(stroke.cubicOf(stroke.segments[std::size_t(segment)]));
}

std::vector<RunPlace> placesOf(const Stroke &stroke, const std::vector<int> &segments)
{
    std::vector<RunPlace> places;
    double length = 0;
    auto next = segments.begin();
    for (int k = segments.front(); k <= segments.back(); ++k) {
        const double arc = lengthOf(stroke, k);
        if (k == *next) {
            places.push_back({k, length + 0.5 * arc});
            ++next;
        }
        length += arc;
    }
    for (RunPlace &p : places)
        p.place = length > 0 ? p.place / length : 0.5;
    return places;
}

std::vector<CurvePlace> cutsOf(const StrokeRun &run)
{
    std::vector<CurvePlace> cuts;
    for (const RunPlace &p : run.places) {
        const Segment &segment = run.stroke->segments[std::size_t(p.segment)];
        const double fine = 0.5 * segment.spread(segment.driesAt());
        const int pieces = int(std::clamp(std::ceil(lengthOf(*run.stroke, p.segment) / fine), 1.0, double(mostPieces)));
        for (int i = 1; i < pieces; ++i)
            cuts.push_back({p.segment, double(i) / pieces});
    }
    return cuts;
}

} // namespace

StrokeRuns runsOf(const Document &document)
{
    std::map<StrokeId, std::vector<int>> targets;
    for (const SegmentRef &ref : targetSegments(document))
        targets[ref.stroke].push_back(ref.segment);
    StrokeRuns runs;
    const Painting &painting = *document.painting();
    const Locks isLocked(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (const auto it = targets.find(stroke->id); it != targets.end() && !isLocked(*stroke))
            runs.emplace(stroke->id, StrokeRun{stroke, placesOf(*stroke, it->second)});
    return runs;
}

StrokeRuns refined(const StrokeRuns &runs)
{
    StrokeRuns result;
    std::size_t total = 0;
    for (const auto &[id, run] : runs) {
        const std::vector<CurvePlace> cuts = cutsOf(run);
        total += cuts.size();
        if (cuts.empty() || total > mostCuts) {
            result.emplace(id, run);
            continue;
        }
        std::vector<int> sources, segments;
        const auto stroke = std::make_shared<const Stroke>(withNodes(*run.stroke, cuts, &sources));
        auto next = run.places.begin();
        for (std::size_t k = 0; k < sources.size(); ++k) {
            while (next != run.places.end() && next->segment < sources[k])
                ++next;
            if (next != run.places.end() && next->segment == sources[k])
                segments.push_back(int(k));
        }
        result.emplace(id, StrokeRun{stroke, placesOf(*stroke, segments)});
    }
    return result;
}

Edit setAlong(const Document &document, const StrokeRuns &runs, const std::map<Quantity, ValueAlong> &values)
{
    Edit edit;
    Selection selection = document.selection();
    for (const auto &[id, run] : runs) {
        const StrokePtr now = document.painting()->find(id);
        auto stroke = std::make_shared<Stroke>(*run.stroke);
        for (const RunPlace &p : run.places)
            for (const auto &[quantity, valueAt] : values) {
                float &value = valueOf(stroke->segments[std::size_t(p.segment)], quantity);
                value = float(valueAt(p.place, double(value)));
            }
        if (!now || *now == *stroke || !problemOf(*stroke).isEmpty())
            continue;
        if (std::erase_if(selection.segments, [id = id](const SegmentRef &ref) { return ref.stroke == id; }) > 0)
            for (const RunPlace &p : run.places)
                selection.segments.insert({id, p.segment});
        edit.strokes.emplace(id, std::move(stroke));
    }
    if (!edit.strokes.empty() && selection != document.selection())
        edit.selection = std::move(selection);
    return edit;
}

} // namespace suffuse
