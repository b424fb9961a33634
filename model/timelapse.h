// The moments at which a painting is looked at when it is shown being painted.
#pragma once

#include "model/painting.h"

namespace suffuse {

/// How a film of a painting runs.
struct TimelapseOptions {
    int frames = 1;    ///< at least 1
    double idle = 0.5; ///< seconds that are kept of a pause in which nothing is drawn or spreads; at least 0
};

/// The document time of each frame, ascending, evenly spaced but for the pauses that are cut: the first one a frame
/// after the painting's begin, the last one its end. An empty painting stands still.
std::vector<Microseconds> timelapseMoments(const Painting &painting, const TimelapseOptions &options);

} // namespace suffuse
