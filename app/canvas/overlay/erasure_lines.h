#pragma once

#include "app/canvas/overlay/overlay.h"

#include <optional>
#include <set>

namespace suffuse {

/// Dashed lines along the segments that take paint away, as far as they are begun. The path of one painting in one view
/// is kept.
class ErasureLines {
public:
    /// Those that are begun by T. `only`: of these strokes; null: of all visible ones.
    void paint(QPainter &painter, const View &view, const PaintingPtr &painting, Microseconds T,
               const std::set<StrokeId> *only, const OverlayColours &colours, double dpr);

    /// Whether the same lines were painted for that moment.
    bool holds(Microseconds T) const { return m_from <= T && T < m_until; }

private:
    void gather(const View &view, const PaintingPtr &painting, Microseconds T, const std::set<StrokeId> *only);

    PaintingPtr m_painting; ///< of which the path is; null: of none yet
    View m_view;
    std::optional<std::set<StrokeId>> m_only;
    Microseconds m_from = 0, m_until = 0; ///< the moments, from a birth to the next one, for which the path is
    QPainterPath m_path;
};

} // namespace suffuse
