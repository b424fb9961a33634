#include "app/panels/timeline/timeline_bars.h"

#include "model/area/outline.h"
#include "model/colour/colour_uses.h"
#include "model/document/document.h"

#include <algorithm>
#include <numeric>
#include <queue>

namespace suffuse {

TimelineBar barOf(const Stroke &stroke)
{
    TimelineBar bar;
    bar.stroke = stroke.id;
    std::vector<const Segment *> paint;
    for (const Segment &s : stroke.segments)
        if (!s.takesPaint())
            paint.push_back(&s);
    if (paint.empty())
        paint.push_back(&stroke.segments.front());
    bar.begin = bar.drawn = bar.dry = bar.end = paint.front()->born;
    for (const Segment *s : paint) {
        bar.begin = std::min(bar.begin, s->born);
        bar.drawn = std::max(bar.drawn, s->born);
        bar.dry = std::max(bar.dry, s->born + toMicroseconds(double(s->maxAge)));
        bar.end = std::max(bar.end, s->driesAt());
    }
    if (stroke.fill) {
        const bool alone = isFillAlone(stroke); // What only bounds it dries unseen.
        bar.begin = std::min(bar.begin, stroke.fill->born);
        bar.drawn = std::max(bar.drawn, stroke.fill->born);
        bar.dry = alone ? stroke.fill->driesAt() : std::max(bar.dry, stroke.fill->driesAt());
        bar.end = alone ? bar.dry : bar.end;
    }
    bar.end = std::max(bar.end, bar.dry);
    bar.done = std::max(bar.end, stroke.driesAt());
    bar.colour = shownColourOf(stroke);
    return bar;
}

std::vector<TimeSpan> erasuresOf(const Stroke &stroke)
{
    std::vector<TimeSpan> spans;
    for (const Segment &s : stroke.segments)
        if (s.takesPaint() && s.start)
            spans.push_back({s.born, s.born});
        else if (s.takesPaint() && !spans.empty())
            spans.back() = {std::min(spans.back().begin, s.born), std::max(spans.back().end, s.born)};
    std::ranges::sort(spans, {}, &TimeSpan::begin);
    return spans;
}

namespace {

bool sameBirths(const Stroke &a, const Stroke &b)
{
    return std::ranges::equal(a.segments, b.segments, {}, &Segment::born, &Segment::born);
}

} // namespace

bool TimelineBars::setPainting(const PaintingPtr &painting)
{
    if (painting == m_painting)
        return false;
    const std::optional<bool> updated = update(*painting);
    if (!updated) {
        m_bars.clear();
        m_bars.reserve(painting->strokes.size());
        for (const StrokePtr &stroke : painting->strokes)
            m_bars.push_back(barOf(*stroke));
        layOut();
    }
    m_painting = painting;
    return updated.value_or(true);
}

/// Changes the bars that differ, and returns whether anything looks different. Returns nothing if all bars must be laid
/// out anew.
std::optional<bool> TimelineBars::update(const Painting &painting)
{
    if (painting.strokes.size() != m_painting->strokes.size())
        return {};
    bool same = true, differs = painting.groups != m_painting->groups;
    std::vector<std::size_t> moved;
    m_painting->strokes.forEachDifference(painting.strokes, [&](std::size_t i) {
        TimelineBar bar = barOf(*painting.strokes[i]);
        same = same && bar.stroke == m_bars[i].stroke;
        bar.lane = m_bars[i].lane;
        if (bar.begin != m_bars[i].begin || bar.end != m_bars[i].end || bar.done != m_bars[i].done)
            moved.push_back(i);
        const Stroke &before = *m_painting->strokes[i], &now = *painting.strokes[i];
        differs = differs || bar != m_bars[i] || before.visible != now.visible || before.group != now.group ||
                  !sameBirths(before, now);
        m_bars[i] = bar;
    });
    if (!same)
        return {};
    constexpr std::size_t few = 64;
    if (moved.size() > few)
        layOut();
    else if (!moved.empty())
        place(moved);
    return differs;
}

bool TimelineBars::isFree(int lane, const TimelineBar &bar) const
{
    const std::vector<std::size_t> &row = m_lanes[std::size_t(lane)];
    const auto after = std::ranges::partition_point(row, [&](std::size_t i) { return m_bars[i].end < bar.begin; });
    return after == row.end() || m_bars[*after].begin > bar.end;
}

/// The lane for a bar that has moved; one more than there are if there is no room.
int TimelineBars::laneOf(std::size_t i) const
{
    const TimelineBar &bar = m_bars[i], &was = m_laidOut[i];
    const bool isBack = bar.begin == was.begin && bar.end == was.end;
    if (isBack && was.lane < laneCount() && isFree(was.lane, bar))
        return was.lane;
    if (bar.lane < laneCount() && isFree(bar.lane, bar))
        return bar.lane;
    int lane = 0; // the uppermost one that is free
    while (lane < laneCount() && !isFree(lane, bar))
        ++lane;
    return lane;
}

void TimelineBars::place(const std::vector<std::size_t> &moved)
{
    for (std::vector<std::size_t> &row : m_lanes)
        std::erase_if(row, [&](std::size_t i) { return std::ranges::binary_search(moved, i); });
    for (const std::size_t i : moved) {
        TimelineBar &bar = m_bars[i];
        bar.lane = laneOf(i);
        if (bar.lane == laneCount())
            m_lanes.emplace_back();
        std::vector<std::size_t> &row = m_lanes[std::size_t(bar.lane)];
        row.insert(std::ranges::upper_bound(row, bar.begin, {}, [this](std::size_t k) { return m_bars[k].begin; }), i);
    }
    while (!m_lanes.empty() && m_lanes.back().empty())
        m_lanes.pop_back();
    m_span = {m_bars.front().begin, m_bars.front().done};
    for (const TimelineBar &bar : m_bars)
        m_span = {std::min(m_span.begin, bar.begin), std::max(m_span.end, bar.done)};
}

int TimelineBars::laneFrom(Microseconds begin) const
{
    const auto isFree = [&](const std::vector<std::size_t> &row) {
        return row.empty() || m_bars[row.back()].end < begin;
    };
    return int(std::ranges::find_if(m_lanes, isFree) - m_lanes.begin());
}

void TimelineBars::layOut()
{
    std::vector<std::size_t> order(m_bars.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, {}, [this](std::size_t i) { return m_bars[i].begin; });
    m_lanes.clear();
    m_span = {};
    if (!order.empty())
        m_span = {m_bars[order.front()].begin, m_bars[order.front()].done};
    using Ending = std::pair<Microseconds, int>;
    // the lanes that are busy, by the end of their last bar
    std::priority_queue<Ending, std::vector<Ending>, std::greater<>> busy;
    std::priority_queue<int, std::vector<int>, std::greater<>> idle;
    for (const std::size_t i : order) {
        TimelineBar &bar = m_bars[i];
        m_span.end = std::max(m_span.end, bar.done);
        for (; !busy.empty() && busy.top().first < bar.begin; busy.pop())
            idle.push(busy.top().second);
        if (idle.empty()) {
            idle.push(laneCount());
            m_lanes.emplace_back();
        }
        bar.lane = idle.top(); // The uppermost free lane is taken.
        idle.pop();
        m_lanes[std::size_t(bar.lane)].push_back(i);
        busy.emplace(bar.end, bar.lane);
    }
    m_laidOut = m_bars;
}

std::optional<TimelineBar> draftBar(const TimelineBars &bars, const Document &document)
{
    const StrokePtr &draft = document.draft();
    if (!draft)
        return {};
    TimelineBar bar = barOf(*draft);
    bar.lane = bars.laneFrom(bar.begin);
    return bar;
}

} // namespace suffuse
