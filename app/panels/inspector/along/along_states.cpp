#include "app/panels/inspector/along/along_states.h"

#include <algorithm>

namespace suffuse {

namespace {

bool haveSameSegments(const StrokeRuns &a, const StrokeRuns &b)
{
    return std::ranges::equal(a, b, [](const auto &one, const auto &other) {
        return one.first == other.first &&
               std::ranges::equal(one.second.places, other.second.places, {}, &RunPlace::segment, &RunPlace::segment);
    });
}

} // namespace

const StrokeRuns &AlongState::runsToSet()
{
    const bool varies = std::ranges::any_of(set, [](const auto &entry) { return entry.second.varies(); });
    if (!varies)
        return *runs;
    if (!refined)
        refined = std::make_shared<const StrokeRuns>(suffuse::refined(*runs));
    return *refined;
}

void AlongStates::note(const Painting &painting, const AlongState &state)
{
    const auto isGone = [](const auto &entry) { return entry.second.expired(); };
    std::erase_if(m_starts, [](const auto &entry) { return entry.first.expired(); });
    Known known{{}, state};
    for (const auto &[id, run] : *state.runs) {
        const StrokePtr shown = painting.find(id);
        if (!shown)
            continue;
        known.strokes.emplace(id, shown);
        if (shown == run.stroke)
            continue; // It was found like this, or it was left so.
        const auto earlier = m_starts.find(run.stroke);
        // A run that lives with the others of the state.
        const std::shared_ptr<const StrokeRun> start =
            earlier != m_starts.end() ? earlier->second : std::shared_ptr<const StrokeRun>(state.runs, &run);
        m_starts.try_emplace(shown, start);
    }
    const auto isSame = [&](const Known &other) {
        return std::ranges::equal(known.strokes, other.strokes, [](const auto &a, const auto &b) {
            return a.first == b.first && a.second.lock() == b.second.lock();
        });
    };
    std::erase_if(m_known,
                  [&](const Known &other) { return std::ranges::any_of(other.strokes, isGone) || isSame(other); });
    m_known.push_back(std::move(known));
}

const AlongState *AlongStates::find(const Painting &painting, const StrokeRuns &selected) const
{
    for (const Known &known : m_known) {
        AlongState state = known.state;
        const bool shows = std::ranges::all_of(
            known.strokes, [&](const auto &entry) { return painting.find(entry.first) == entry.second.lock(); });
        if (shows && haveSameSegments(state.runsToSet(), selected))
            return &known.state;
    }
    return nullptr;
}

StrokeRuns AlongStates::starts(const Painting &painting) const
{
    StrokeRuns starts;
    for (const StrokePtr &stroke : painting.strokes)
        if (const auto start = m_starts.find(stroke); start != m_starts.end())
            starts.emplace(stroke->id, *start->second);
    return starts;
}

} // namespace suffuse
