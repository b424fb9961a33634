#pragma once

#include "model/brush/brush.h"
#include "model/brush/stroke_builder.h"

#include <optional>

namespace suffuse {

/// Smooths the pen's way before a stroke is built from it. What it gives out depends on the reports and their times
/// only.
class PenStabiliser {
public:
    /// A new stroke; `stringLength` is the string's length in canvas units.
    void begin(const Stabiliser &settings, const PenSample &first, double stringLength);
    /// What is painted for a report; none where the string is slack.
    std::optional<PenSample> take(const PenSample &pen);
    /// What is still to be painted when the pen lifts there.
    std::optional<PenSample> finish(const PenSample &pen) const;

    /// The paint's end of the string, if there is one.
    std::optional<Point> anchor() const;

private:
    Stabiliser m_settings;
    PenSample m_at; ///< painted last
    Microseconds m_time = 0;
    double m_length = 0;
};

} // namespace suffuse
