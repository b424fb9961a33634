#include "model/document/timelapse.h"

#include <algorithm>

namespace suffuse {

std::vector<TimeSpan> activeSpans(const Painting &painting)
{
    std::vector<TimeSpan> spans;
    const Visibility isVisible(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        if (!isVisible(*stroke))
            continue;
        if (const SharedFill &fill = stroke->fill)
            spans.push_back({fill->born, fill->driesAt()});
        for (const Segment &s : stroke->segments) {
            spans.push_back({s.born, std::max(s.born, s.born + toMicroseconds(double(s.maxAge)))});
            for (const Rewet &r : s.rewet)
                spans.push_back({r.time, r.time + r.extra});
        }
    }
    std::ranges::sort(spans, {}, &TimeSpan::begin);
    std::vector<TimeSpan> apart;
    for (const TimeSpan &s : spans)
        if (apart.empty() || s.begin > apart.back().end)
            apart.push_back(s);
        else
            apart.back().end = std::max(apart.back().end, s.end);
    return apart;
}

FilmClock::FilmClock(const Painting &painting, Microseconds idle)
{
    const std::vector<TimeSpan> active = activeSpans(painting);
    m_shown = active; // each but the last with the part of the pause behind it that is kept
    for (std::size_t k = 0; k < m_shown.size(); ++k) {
        if (k + 1 < m_shown.size())
            m_shown[k].end = std::min(active[k].end + idle, active[k + 1].begin);
        m_before.push_back(m_length);
        m_length += m_shown[k].end - m_shown[k].begin;
    }
}

Microseconds FilmClock::documentTime(Microseconds film) const
{
    if (m_shown.empty())
        return 0;
    // The last span that begins before is taken: where two spans meet, the moment is the first one's end.
    const auto after = std::lower_bound(m_before.begin() + 1, m_before.end(), film);
    const auto k = std::size_t(after - m_before.begin()) - 1;
    return m_shown[k].begin + film - m_before[k];
}

Microseconds FilmClock::filmTime(Microseconds document) const
{
    const auto after = std::ranges::upper_bound(m_shown, document, {}, &TimeSpan::begin);
    if (after == m_shown.begin())
        return 0;
    const auto k = std::size_t(after - m_shown.begin()) - 1;
    return m_before[k] + std::min(document, m_shown[k].end) - m_shown[k].begin;
}

std::vector<Microseconds> timelapseMoments(const Painting &painting, const TimelapseOptions &options)
{
    const auto count = std::size_t(std::max(options.frames, 1));
    const FilmClock clock(painting, toMicroseconds(options.idle));
    if (clock.length() == 0)
        return std::vector<Microseconds>(count, painting.end());
    std::vector<Microseconds> moments;
    for (std::size_t i = 1; i < count; ++i)
        moments.push_back(clock.documentTime(Microseconds(double(clock.length()) * double(i) / double(count))));
    moments.push_back(painting.end());
    return moments;
}

} // namespace suffuse
