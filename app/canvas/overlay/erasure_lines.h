#pragma once

#include "app/canvas/overlay/overlay.h"

#include <optional>
#include <set>

namespace suffuse {

/// Dashed lines along the segments that take paint away. The path of one painting in one view is kept.
class ErasureLines {
public:
    /// `only`: of these strokes; null: of all visible ones.
    void paint(QPainter &painter, const View &view, const PaintingPtr &painting, const std::set<StrokeId> *only,
               const OverlayColours &colours, double dpr);

private:
    void gather(const View &view, const PaintingPtr &painting, const std::set<StrokeId> *only);

    PaintingPtr m_painting; ///< of which the path is; null: of none yet
    View m_view;
    std::optional<std::set<StrokeId>> m_only;
    QPainterPath m_path;
};

} // namespace suffuse
