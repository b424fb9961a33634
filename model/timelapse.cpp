#include "model/timelapse.h"

#include <algorithm>

namespace suffuse {

namespace {

/// When something is drawn or spreads.
struct Span {
    Microseconds begin = 0;
    Microseconds end = 0;
};

/// Of all visible segments, ascending and apart.
std::vector<Span> activeSpans(const Painting &painting)
{
    std::vector<Span> spans;
    for (const StrokePtr &stroke : painting.strokes) {
        if (!painting.isVisible(*stroke))
            continue;
        for (const Segment &s : stroke->segments) {
            spans.push_back({s.born, std::max(s.born, s.born + toMicroseconds(double(s.maxAge)))});
            for (const Rewet &r : s.rewet)
                spans.push_back({r.time, r.time + r.extra});
        }
    }
    std::ranges::sort(spans, {}, &Span::begin);
    std::vector<Span> apart;
    for (const Span &s : spans)
        if (apart.empty() || s.begin > apart.back().end)
            apart.push_back(s);
        else
            apart.back().end = std::max(apart.back().end, s.end);
    return apart;
}

} // namespace

std::vector<Microseconds> timelapseMoments(const Painting &painting, const TimelapseOptions &options)
{
    const auto count = std::size_t(std::max(options.frames, 1));
    const std::vector<Span> active = activeSpans(painting);
    if (active.empty())
        return std::vector<Microseconds>(count, painting.end());
    // What is shown: the active spans, each but the last with what is kept of the pause behind it.
    std::vector<Span> shown = active;
    Microseconds length = 0;
    for (std::size_t k = 0; k < shown.size(); ++k) {
        if (k + 1 < shown.size())
            shown[k].end = std::min(active[k].end + toMicroseconds(options.idle), active[k + 1].begin);
        length += shown[k].end - shown[k].begin;
    }
    std::vector<Microseconds> moments;
    std::size_t k = 0;
    Microseconds before = 0; // film time at which span k begins
    for (std::size_t i = 1; i < count; ++i) {
        const auto film = Microseconds(double(length) * double(i) / double(count));
        while (k + 1 < shown.size() && film > before + shown[k].end - shown[k].begin) {
            before += shown[k].end - shown[k].begin;
            ++k;
        }
        moments.push_back(shown[k].begin + film - before);
    }
    moments.push_back(painting.end());
    return moments;
}

} // namespace suffuse
