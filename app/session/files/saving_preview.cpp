#include "app/session/files/saving_preview.h"

#include "render/backends.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

QImage previewImage(const PaintingPtr &painting, int side)
{
    auto renderer = makeRenderer({.backend = Backend::Cpu, .threads = 1});
    if (!renderer)
        return {};
    const Canvas &canvas = painting->canvas;
    const double scale = side / std::max(canvas.width, canvas.height);
    const int width = std::max(1, int(std::lround(canvas.width * scale)));
    const int height = std::max(1, int(std::lround(canvas.height * scale)));
    RenderRequest request;
    request.painting = painting;
    request.time = painting->end();
    request.view = View::ofArea(canvas.area(), width, height);
    Picture8 picture;
    if (const auto stats = (*renderer)->render(request, picture); !stats)
        return {};
    const QImage shared(reinterpret_cast<const uchar *>(picture.argb.data()), picture.width, picture.height,
                        picture.width * 4, QImage::Format_ARGB32);
    return shared.convertToFormat(QImage::Format_RGB888);
}

} // namespace suffuse
