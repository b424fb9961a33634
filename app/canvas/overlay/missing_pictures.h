// Frames where pictures would be that are missing, so that they are found.
#pragma once

#include "app/canvas/overlay/overlay.h"

namespace suffuse {

/// Draws a frame with a cross for each visible stroke whose picture is missing: of it nothing is in the picture.
class MissingPictures {
public:
    void paint(QPainter &painter, const View &view, const PaintingPtr &painting, const OverlayColours &colours,
               double dpr);
    /// Whether there were any when it was painted last.
    bool any() const { return !m_missing.empty(); }

private:
    PaintingPtr m_painting; ///< in which they were looked for
    std::vector<StrokePtr> m_missing;
};

} // namespace suffuse
