// The moments at which a painting is looked at when it is shown being painted.
#pragma once

#include "model/painting/painting.h"

namespace suffuse {

/// From `begin` to `end`, document time.
struct TimeSpan {
    Microseconds begin = 0;
    Microseconds end = 0;
    friend bool operator==(const TimeSpan &, const TimeSpan &) = default;
};

/// When visible strokes are drawn or spread: ascending and apart.
std::vector<TimeSpan> activeSpans(const Painting &painting);

/// Film time, in which pauses are cut, and document time.
class FilmClock {
public:
    /// Of each pause in which nothing is drawn or spreads, `idle` microseconds are kept.
    FilmClock(const Painting &painting, Microseconds idle);

    Microseconds length() const { return m_length; }
    /// Document time at `film` in [0, length]; 0 where nothing is ever drawn.
    Microseconds documentTime(Microseconds film) const;
    /// The first film time that shows the document time, or a pause's end for what is cut.
    Microseconds filmTime(Microseconds document) const;

private:
    std::vector<TimeSpan> m_shown;      ///< what is left
    std::vector<Microseconds> m_before; ///< film time at which each begins
    Microseconds m_length = 0;
};

/// How a film of a painting runs.
struct TimelapseOptions {
    int frames = 1;    ///< at least 1
    double idle = 0.5; ///< seconds that are kept of a pause in which nothing is drawn or spreads; at least 0
};

/// The document time of each frame, ascending, evenly spaced but for the pauses that are cut: the first one a frame
/// after the painting's begin, the last one its end. An empty painting stands still.
std::vector<Microseconds> timelapseMoments(const Painting &painting, const TimelapseOptions &options);

} // namespace suffuse
