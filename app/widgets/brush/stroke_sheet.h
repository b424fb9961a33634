#pragma once

#include "model/painting/painting.h"
#include "render/renderer.h"

#include <QImage>

#include <memory>

namespace suffuse {

/// Draws strokes on white, dry, by the renderer; a unit is a logical pixel. Strokes that did not change since the last
/// drawing are not drawn again.
class StrokeSheet {
public:
    StrokeSheet();

    /// Returns false, and leaves the image as it was, if the renderer fails.
    bool draw(const std::vector<StrokePtr> &strokes, QSize size, double ratio);
    const QImage &image() const { return m_image; }

private:
    std::unique_ptr<Renderer> m_renderer;
    Picture8 m_picture;
    QImage m_image;
};

} // namespace suffuse
