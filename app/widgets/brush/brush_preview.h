#pragma once

#include "model/brush/brush.h"
#include "render/renderer.h"

#include <QImage>

#include <memory>

namespace suffuse {

/// Draws brushes as a stroke on paper with the real renderer.
class BrushPreview {
public:
    /// An S-shaped stroke of the brush on `size` device pixels, with straight alpha (draw it over paper). Larger
    /// brushes are shown from further away. A null image if the renderer fails.
    QImage render(const Brush &brush, QSize size);

private:
    std::unique_ptr<Renderer> m_renderer;
};

} // namespace suffuse
