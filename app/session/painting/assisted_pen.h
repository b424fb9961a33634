#pragma once

#include "model/brush/stroke_builder.h"
#include "model/geometry/assistant.h"

#include <optional>
#include <vector>

namespace suffuse {

/// Puts the samples of a pen on the assistant that their stroke follows, before the stroke is built from them. Time,
/// pressure and tilt stay. What a stroke follows is decided when it has gone a short way, and stays for all of it.
class AssistedPen {
public:
    /// How far a stroke goes until it is decided, and how near to a ruler or an ellipse it has to begin; logical
    /// pixels.
    static constexpr double usualTravel = 6, usualReach = 20;

    /// Begins a stroke; without assistants it is free. `travel` and `reach` are in canvas units.
    void begin(std::vector<Assistant> assistants, double travel, double reach);
    /// The samples to paint now: none until it is decided, then all that have come until then.
    std::vector<PenSample> take(const PenSample &sample);
    /// Those that still wait when the pen lifts: it has gone nowhere, and they are painted where they are.
    std::vector<PenSample> finish();

    /// What the stroke in hand follows.
    const std::optional<AssistantTrack> &track() const { return m_track; }

private:
    std::vector<Assistant> m_assistants; ///< none: it is decided
    double m_travel = 0;
    double m_reach = 0;
    std::vector<PenSample> m_waiting;
    std::optional<AssistantTrack> m_track;
};

} // namespace suffuse
