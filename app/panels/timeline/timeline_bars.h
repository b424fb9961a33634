#pragma once

#include "model/document/timelapse.h"

#include <optional>
#include <vector>

namespace suffuse {

class Document;

/// The times of a stroke's paint. What takes paint away has neither a colour nor a drying time that anybody sees.
struct TimelineBar {
    StrokeId stroke = 0;
    int lane = 0;
    Microseconds begin = 0; ///< when its first segment is born
    Microseconds drawn = 0; ///< when its last segment, or its fill, is born
    Microseconds dry = 0;   ///< when it stops spreading for the first time
    Microseconds end = 0;   ///< when it stops for the last time, if it is wetted again
    Microseconds done = 0;  ///< when nothing of the stroke changes any more, its erasures included
    Colour colour;          ///< shownColourOf
    friend bool operator==(const TimelineBar &, const TimelineBar &) = default;
};

/// The bar of a stroke.
TimelineBar barOf(const Stroke &stroke);

/// When softly erasing strokes took paint of this stroke away, in ascending order: a span for each time that the eraser
/// was at work, from the birth of its first segment to that of its last.
std::vector<TimeSpan> erasuresOf(const Stroke &stroke);

/// All strokes of a painting as bars in lanes. No bar overlaps another one of its lane. If a few strokes are moved or
/// stretched, each of them stays in its lane if there is room, and the others stay in any case. One that comes back to
/// where it was, as undo makes it, comes back into its lane.
class TimelineBars {
public:
    /// Takes a painting. It takes little time where few strokes changed, and none was added or removed. Returns true if
    /// anything looks different now.
    bool setPainting(const PaintingPtr &painting);
    const Painting &painting() const { return *m_painting; }

    int laneCount() const { return int(m_lanes.size()); }
    /// The bar of stroke i of the painting.
    const TimelineBar &operator[](std::size_t i) const { return m_bars[i]; }
    std::size_t size() const { return m_bars.size(); }
    /// The uppermost lane in which there is nothing from a moment on.
    int laneFrom(Microseconds begin) const;
    /// The time from the first birth until all has dried and all erasures are at rest; empty at 0 without strokes.
    TimeSpan span() const { return m_span; }

    /// Calls visit(i) in ascending order for the bars of a lane that meet the span. A bar that begins within `grain`
    /// after the end of the last visited one is left out, since it would not be seen beside it.
    template <typename Visit>
    void forEachIn(int lane, TimeSpan span, Microseconds grain, Visit visit) const
    {
        const std::vector<std::size_t> &row = m_lanes[std::size_t(lane)];
        auto it = row.begin();
        for (Microseconds from = span.begin;;) {
            it = std::partition_point(it, row.end(), [&](std::size_t i) { return m_bars[i].end < from; });
            if (it == row.end() || m_bars[*it].begin > span.end)
                return;
            visit(*it);
            from = std::max(from, m_bars[*it].end) + grain;
            ++it;
        }
    }

private:
    std::optional<bool> update(const Painting &painting);
    void layOut();
    void place(const std::vector<std::size_t> &moved);
    int laneOf(std::size_t bar) const;
    bool isFree(int lane, const TimelineBar &bar) const;

    PaintingPtr m_painting = std::make_shared<const Painting>();
    std::vector<TimelineBar> m_bars;
    std::vector<TimelineBar> m_laidOut;            ///< the bars as they were when all were laid out
    std::vector<std::vector<std::size_t>> m_lanes; ///< in ascending order
    TimeSpan m_span;
};

/// The bar of the stroke in hand, in the lane where it will be when the pen has lifted. There is none where nothing is
/// being painted.
std::optional<TimelineBar> draftBar(const TimelineBars &bars, const Document &document);

} // namespace suffuse
