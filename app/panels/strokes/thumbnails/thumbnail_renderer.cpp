#include "app/panels/strokes/thumbnails/thumbnail_renderer.h"

#include "render/backends.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {
constexpr double thumbnailMargin = 0.04;
} // namespace

ThumbnailRenderer::ThumbnailRenderer() = default;
ThumbnailRenderer::~ThumbnailRenderer() = default;

QImage ThumbnailRenderer::draw(const PaintingPtr &painting, const Rect &box, double ratio,
                               const std::atomic<bool> *cancel)
{
    if (!m_renderer) {
        auto made = makeRenderer({.backend = Backend::Cpu, .threads = 1});
        if (!made)
            return {};
        m_renderer = std::move(*made);
    }
    RenderRequest request;
    request.painting = painting;
    request.time = painting->end();
    request.transparent = true;
    request.view.width = int(std::lround(size.width() * ratio));
    request.view.height = int(std::lround(size.height() * ratio));
    request.view.centre = box.centre();
    request.view.scale =
        std::clamp((1 - 2 * thumbnailMargin) * std::min(request.view.width / std::max(box.width(), 1e-9),
                                                        request.view.height / std::max(box.height(), 1e-9)),
                   1e-3, 1e9);
    Picture8 picture;
    m_renderer->invalidate();
    const auto drawn = m_renderer->render(request, picture, cancel);
    if (!drawn || drawn->cancelled)
        return {};
    QImage image = QImage(reinterpret_cast<const uchar *>(picture.argb.data()), picture.width, picture.height,
                          picture.width * 4, QImage::Format_ARGB32)
                       .copy();
    image.setDevicePixelRatio(ratio);
    return image;
}

} // namespace suffuse
