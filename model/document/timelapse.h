// The moments at which a painting is looked at when it is shown being painted.
#pragma once

#include "model/painting/painting.h"

namespace suffuse {

/// A time from `begin` to `end`, document time.
struct TimeSpan {
    Microseconds begin = 0;
    Microseconds end = 0;
    friend bool operator==(const TimeSpan &, const TimeSpan &) = default;
};

/// The times in which visible strokes are drawn or spread, ascending and without overlaps.
std::vector<TimeSpan> activeSpans(const Painting &painting);

/// Converts between document time and the time of a film, in which pauses are shortened.
class FilmClock {
public:
    /// `idle` microseconds are kept of each pause in which nothing is drawn or spreads.
    FilmClock(const Painting &painting, Microseconds idle);

    Microseconds length() const { return m_length; }
    /// The document time at `film` in [0, length]; 0 where nothing is ever drawn.
    Microseconds documentTime(Microseconds film) const;
    /// The first film time that shows a document time. If that lies in a part of a pause that is cut, it is the end of
    /// the pause.
    Microseconds filmTime(Microseconds document) const;

private:
    std::vector<TimeSpan> m_shown;      ///< the times that are shown
    std::vector<Microseconds> m_before; ///< the film time at which each of them begins
    Microseconds m_length = 0;
};

/// How a film of a painting runs.
struct TimelapseOptions {
    int frames = 1;    ///< at least 1
    double idle = 0.5; ///< seconds, at least 0, that are kept of a pause in which nothing is drawn or spreads
};

/// The document time of each frame, ascending. The times are evenly spaced except for the pauses that are cut: the
/// first is a frame after the begin of the painting, the last is its end. An empty painting does not change.
std::vector<Microseconds> timelapseMoments(const Painting &painting, const TimelapseOptions &options);

} // namespace suffuse
