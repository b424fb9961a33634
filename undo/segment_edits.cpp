#include "model/painting/editable.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/runs.h"
#include "model/shaping/erasing/erase.h"
#include "undo/edits.h"

#include <unordered_map>

namespace suffuse {

namespace {

using SegmentsOfStrokes = std::unordered_map<StrokeId, std::vector<int>>; ///< in ascending order, each once

SegmentsOfStrokes segmentsByStroke(const std::vector<SegmentRef> &targets)
{
    const std::set<SegmentRef> sorted(targets.begin(), targets.end());
    SegmentsOfStrokes result;
    for (const SegmentRef &ref : sorted)
        result[ref.stroke].push_back(ref.segment);
    return result;
}

/// The stroke with `change` applied to the segments that allow it; null if none does.
StrokePtr withChanged(const Stroke &stroke, const std::vector<int> &segments,
                      const std::function<void(Segment &)> &change)
{
    auto result = std::make_shared<Stroke>(stroke);
    for (int index : segments) {
        if (index < 0 || std::size_t(index) >= stroke.segments.size())
            continue;
        Segment segment = stroke.segments[std::size_t(index)];
        change(segment);
        if (problemOf(segment).isEmpty())
            result->segments[std::size_t(index)] = std::move(segment);
    }
    // A segment that no longer meets its neighbours makes the whole stroke invalid.
    if (result->segments == stroke.segments || !problemOf(*result).isEmpty())
        return nullptr;
    return result;
}

/// What is left of a stroke without some segments (in ascending order).
std::vector<StrokePtr> remainingRuns(const Stroke &stroke, const std::vector<int> &deleted, Leaves leaves,
                                     Document &document)
{
    if (leaves == Leaves::Chains) {
        std::optional<Stroke> left = withoutSegments(stroke, deleted);
        return left ? std::vector<StrokePtr>{std::make_shared<const Stroke>(std::move(*left))}
                    : std::vector<StrokePtr>();
    }
    std::vector<StrokePtr> runs;
    auto next = deleted.begin();
    std::shared_ptr<Stroke> run;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        if (next != deleted.end() && std::size_t(*next) == k) {
            ++next;
            run.reset();
            continue;
        }
        if (!run) {
            run = std::make_shared<Stroke>(stroke);
            run->segments.clear();
            if (!runs.empty())
                run->id = document.takeStrokeId();
            runs.push_back(run);
            run->segments.push_back(stroke.segments[k]);
            run->segments.back().start = false;
            continue;
        }
        run->segments.push_back(stroke.segments[k]);
    }
    return runs;
}

} // namespace

std::vector<SegmentRef> targetSegments(const Document &document)
{
    const Selection &selection = document.selection();
    std::set<StrokeId> inPart;
    for (const SegmentRef &ref : selection.segments)
        inPart.insert(ref.stroke);
    std::vector<SegmentRef> result(selection.segments.begin(), selection.segments.end());
    if (inPart.size() < selection.strokes.size())
        for (const StrokePtr &stroke : document.painting()->strokes)
            if (selection.strokes.contains(stroke->id) && !inPart.contains(stroke->id)) {
                const std::vector<bool> meant = meantOfWhole(*stroke);
                for (std::size_t k = 0; k < stroke->segments.size(); ++k)
                    if (meant.empty() || meant[k])
                        result.push_back({stroke->id, int(k)});
            }
    std::sort(result.begin(), result.end());
    return result;
}

Edit changeSegments(const Document &document, const std::vector<SegmentRef> &targets,
                    const std::function<void(Segment &)> &change)
{
    Edit edit;
    const SegmentsOfStrokes wanted = segmentsByStroke(targets);
    if (wanted.empty())
        return edit;
    const Painting &painting = *document.painting();
    const Locks isLocked(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        const auto it = wanted.find(stroke->id);
        if (it == wanted.end() || isLocked(*stroke))
            continue;
        if (StrokePtr changed = withChanged(*stroke, it->second, change))
            edit.strokes.emplace(stroke->id, std::move(changed));
    }
    return edit;
}

Edit changeSegmentsSince(const Document &document, const Painting &before, const std::vector<SegmentRef> &targets,
                         const std::function<void(Segment &now, const Segment &then)> &change)
{
    Edit edit;
    const SegmentsOfStrokes wanted = segmentsByStroke(targets);
    std::unordered_map<StrokeId, const Stroke *> earlier;
    for (const StrokePtr &stroke : before.strokes)
        if (wanted.contains(stroke->id))
            earlier.emplace(stroke->id, stroke.get());
    const Painting &painting = *document.painting();
    const Locks isLocked(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        const auto it = wanted.find(stroke->id);
        const auto then = earlier.find(stroke->id);
        if (it == wanted.end() || then == earlier.end() || isLocked(*stroke) ||
            then->second->segments.size() != stroke->segments.size())
            continue;
        auto changed = std::make_shared<Stroke>(*stroke);
        for (const int index : it->second) {
            if (index < 0 || std::size_t(index) >= stroke->segments.size())
                continue;
            Segment segment = stroke->segments[std::size_t(index)];
            change(segment, then->second->segments[std::size_t(index)]);
            if (problemOf(segment).isEmpty())
                changed->segments[std::size_t(index)] = std::move(segment);
        }
        if (changed->segments != stroke->segments && problemOf(*changed).isEmpty())
            edit.strokes.emplace(stroke->id, std::move(changed));
    }
    return edit;
}

Edit deleteSelection(Document &document, Leaves leaves)
{
    const PaintingPtr painting = document.painting();
    const Selection &selection = document.selection();
    const SegmentsOfStrokes parts = segmentsByStroke({selection.segments.begin(), selection.segments.end()});
    Edit edit;
    Selection left;
    std::vector<StrokeId> order;
    const Locks isLocked(painting->groups);
    for (const StrokePtr &stroke : painting->strokes) {
        if (!selection.strokes.contains(stroke->id) || isLocked(*stroke)) {
            order.push_back(stroke->id);
            continue;
        }
        const auto it = parts.find(stroke->id);
        const std::vector<StrokePtr> runs =
            it == parts.end() ? std::vector<StrokePtr>() : remainingRuns(*stroke, it->second, leaves, document);
        edit.strokes[stroke->id] = nullptr;
        for (const StrokePtr &run : runs) {
            edit.strokes[run->id] = run;
            order.push_back(run->id);
            if (leaves == Leaves::Chains)
                left.strokes.insert(run->id);
        }
    }
    if (edit.strokes.empty())
        return {};
    edit.order = std::move(order);
    edit.selection = std::move(left);
    return edit;
}

} // namespace suffuse
