#pragma once

#include "model/painting/selection.h"
#include "model/painting/stroke_values.h"

#include <optional>

namespace suffuse {

/// What is selected of the strokes that are begun at a moment. It is computed anew only where the painting or the
/// selection changes, or a selected stroke begins.
class BegunSelection {
public:
    /// Of the painting or the selection: what was computed does not hold.
    void noteChange() { m_known = false; }
    /// Whether what was computed holds at the moment.
    bool holds(Microseconds T) const { return m_known && T >= m_from && T < m_until; }
    const Selection &at(Microseconds T, const StrokeList &strokes, const Selection &selection);
    /// The strokes left out last.
    const std::set<StrokeId> &leftOut() const { return m_leftOut; }

private:
    StrokeValues<Microseconds> m_births;
    Selection m_begun; ///< where some are left out
    std::set<StrokeId> m_leftOut;
    bool m_known = false;
    Microseconds m_from = 0, m_until = 0; ///< between which it holds
};

} // namespace suffuse
