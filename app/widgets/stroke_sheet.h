#pragma once

#include "model/painting/painting.h"
#include "render/renderer.h"

#include <QImage>

#include <memory>

namespace suffuse {

/// Strokes on white, dry, drawn by the renderer; a unit is a logical pixel. What did not change since the last drawing
/// is not drawn again.
class StrokeSheet {
public:
    StrokeSheet();

    /// False, and the image as before, where the renderer fails.
    bool draw(const std::vector<StrokePtr> &strokes, QSize size, double ratio);
    const QImage &image() const { return m_image; }

private:
    std::unique_ptr<Renderer> m_renderer;
    Picture8 m_picture;
    QImage m_image;
};

} // namespace suffuse
