#include "app/panels/inspector/inspected.h"

#include "model/painting/wash_groups.h"
#include "model/shaping/curves/runs.h"

#include <algorithm>
#include <limits>

namespace suffuse {

namespace {

/// The selected strokes from bottom to top.
std::vector<const Stroke *> selectedStrokes(const Painting &painting, const std::set<StrokeId> &wanted)
{
    std::vector<const Stroke *> strokes;
    auto next = wanted.begin(); // Most often the order of strokes is that of their ids.
    for (const StrokePtr &stroke : painting.strokes) {
        if (strokes.size() == wanted.size())
            break;
        if (next == wanted.end() || *next != stroke->id)
            next = wanted.find(stroke->id);
        if (next == wanted.end())
            continue;
        strokes.push_back(stroke.get());
        ++next;
    }
    return strokes;
}

} // namespace

bool Inspected::isErasure() const
{
    return !segments.empty() &&
           std::ranges::all_of(segments, [](const InspectedSegment &s) { return s.segment->takesPaint(); });
}

bool areInWashes(const Inspected &inspected)
{
    const auto washes = washesOf(*inspected.painting);
    return !washes.empty() &&
           std::ranges::all_of(inspected.strokes, [&](const Stroke *stroke) { return washes.contains(stroke->group); });
}

Inspected inspect(const Document &document)
{
    Inspected result;
    result.painting = document.painting();
    const Selection &selection = document.selection();
    result.strokes = selectedStrokes(*result.painting, selection.strokes);
    std::vector<const Stroke *> byId = result.strokes;
    std::sort(byId.begin(), byId.end(), [](const Stroke *a, const Stroke *b) { return a->id < b->id; });
    std::size_t count = 0;
    for (const Stroke *stroke : byId)
        count += stroke->segments.size();
    result.refs.reserve(count);
    result.segments.reserve(count);
    for (const Stroke *stroke : byId) {
        const int size = int(stroke->segments.size());
        const auto add = [&](int segment) {
            if (segment < 0 || segment >= size)
                return;
            result.refs.push_back({stroke->id, segment});
            result.segments.push_back({stroke, &stroke->segments[std::size_t(segment)]});
        };
        auto chosen = selection.segments.lower_bound({stroke->id, std::numeric_limits<int>::min()});
        const bool inPart = chosen != selection.segments.end() && chosen->stroke == stroke->id;
        for (; chosen != selection.segments.end() && chosen->stroke == stroke->id; ++chosen)
            add(chosen->segment);
        const std::vector<bool> meant = inPart ? std::vector<bool>() : meantOfWhole(*stroke);
        for (int k = 0; k < size && !inPart; ++k)
            if (meant.empty() || meant[std::size_t(k)])
                add(k);
    }
    return result;
}

} // namespace suffuse
