#pragma once

#include "model/brush/brush.h"
#include "model/brush/stroke_builder.h"

#include <optional>

namespace suffuse {

/// Smooths the way of the pen before a stroke is built from it. The result depends only on the reports and their times.
class PenStabiliser {
public:
    /// Begins a stroke. `stringLength` is the string's length in canvas units.
    void begin(const Stabiliser &settings, const PenSample &first, double stringLength);
    /// The sample to paint for a report; none where the string is slack.
    std::optional<PenSample> take(const PenSample &pen);
    /// The sample that is still to be painted when the pen lifts there.
    std::optional<PenSample> finish(const PenSample &pen) const;

    /// The end of the string at which paint comes out, if there is a string.
    std::optional<Point> anchor() const;

private:
    Stabiliser m_settings;
    PenSample m_at; ///< the sample that was painted last
    Microseconds m_time = 0;
    double m_length = 0;
};

} // namespace suffuse
