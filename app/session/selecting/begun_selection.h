#pragma once

#include "model/painting/selection.h"
#include "model/painting/stroke_values.h"

#include <optional>

namespace suffuse {

/// The selection without the strokes that are not begun at a moment. It is computed anew only where the painting or the
/// selection changes, or a selected stroke begins.
class BegunSelection {
public:
    /// Call it when the painting or the selection changed: the computed selection does not hold any more.
    void noteChange() { m_known = false; }
    /// Whether the computed selection holds at the moment.
    bool holds(Microseconds T) const { return m_known && T >= m_from && T < m_until; }
    const Selection &at(Microseconds T, const StrokeList &strokes, const Selection &selection);
    /// The strokes that were left out last.
    const std::set<StrokeId> &leftOut() const { return m_leftOut; }

private:
    StrokeValues<Microseconds> m_births;
    Selection m_begun; ///< the selection where some strokes are left out
    std::set<StrokeId> m_leftOut;
    bool m_known = false;
    Microseconds m_from = 0, m_until = 0; ///< the computed selection holds from the first to before the second
};

} // namespace suffuse
