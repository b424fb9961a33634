#include "app/panels/timeline_bars.h"

#include <algorithm>
#include <numeric>
#include <queue>

namespace suffuse {

TimelineBar barOf(const Stroke &stroke)
{
    TimelineBar bar;
    bar.stroke = stroke.id;
    bar.begin = bar.drawn = stroke.born();
    bar.end = stroke.driesAt();
    bar.dry = bar.begin;
    for (const Segment &s : stroke.segments) {
        bar.drawn = std::max(bar.drawn, s.born);
        bar.dry = std::max(bar.dry, s.born + toMicroseconds(double(s.maxAge)));
    }
    bar.end = std::max(bar.end, bar.dry);
    bar.colour = stroke.segments[stroke.segments.size() / 2].colour;
    return bar;
}

void TimelineBars::setPainting(const PaintingPtr &painting)
{
    if (painting == m_painting)
        return;
    if (!update(*painting)) {
        m_bars.clear();
        m_bars.reserve(painting->strokes.size());
        for (const StrokePtr &stroke : painting->strokes)
            m_bars.push_back(barOf(*stroke));
        layOut();
    }
    m_painting = painting;
}

/// True if the bars could be brought up to date without another pass over all.
bool TimelineBars::update(const Painting &painting)
{
    if (painting.strokes.size() != m_painting->strokes.size())
        return false;
    bool same = true, moved = false;
    m_painting->strokes.forEachDifference(painting.strokes, [&](std::size_t i) {
        TimelineBar bar = barOf(*painting.strokes[i]);
        same = same && bar.stroke == m_bars[i].stroke;
        bar.lane = m_bars[i].lane;
        moved = moved || bar.begin != m_bars[i].begin || bar.end != m_bars[i].end;
        m_bars[i] = bar;
    });
    if (moved && same)
        layOut();
    return same;
}

void TimelineBars::layOut()
{
    std::vector<std::size_t> order(m_bars.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, {}, [this](std::size_t i) { return m_bars[i].begin; });
    m_lanes.clear();
    m_span = {};
    if (!order.empty())
        m_span = {m_bars[order.front()].begin, m_bars[order.front()].end};
    using Ending = std::pair<Microseconds, int>;
    std::priority_queue<Ending, std::vector<Ending>, std::greater<>> busy; // lanes by the end of their last bar
    std::priority_queue<int, std::vector<int>, std::greater<>> idle;
    for (const std::size_t i : order) {
        TimelineBar &bar = m_bars[i];
        m_span.end = std::max(m_span.end, bar.end);
        for (; !busy.empty() && busy.top().first < bar.begin; busy.pop())
            idle.push(busy.top().second);
        if (idle.empty()) {
            idle.push(laneCount());
            m_lanes.emplace_back();
        }
        bar.lane = idle.top(); // the uppermost that is free
        idle.pop();
        m_lanes[std::size_t(bar.lane)].push_back(i);
        busy.emplace(bar.end, bar.lane);
    }
}

} // namespace suffuse
