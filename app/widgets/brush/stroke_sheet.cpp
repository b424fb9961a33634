#include "app/widgets/brush/stroke_sheet.h"

#include "render/backends.h"

namespace suffuse {

StrokeSheet::StrokeSheet()
{
    if (auto made = makeRenderer({.backend = Backend::Cpu, .threads = 1}))
        m_renderer = std::move(*made);
}

bool StrokeSheet::draw(const std::vector<StrokePtr> &strokes, QSize size, double ratio)
{
    if (!m_renderer || size.isEmpty())
        return false;
    auto painting = std::make_shared<Painting>();
    painting->canvas.width = size.width();
    painting->canvas.height = size.height();
    for (const StrokePtr &stroke : strokes)
        painting->strokes.push_back(stroke);
    RenderRequest request;
    request.painting = painting;
    request.time = painting->end();
    request.view = View::ofArea(painting->canvas.area(), qRound(size.width() * ratio), qRound(size.height() * ratio));
    if (const auto stats = m_renderer->render(request, m_picture); !stats)
        return false;
    m_image = QImage(reinterpret_cast<const uchar *>(m_picture.argb.data()), m_picture.width, m_picture.height,
                     m_picture.width * 4, QImage::Format_ARGB32)
                  .copy();
    return true;
}

} // namespace suffuse
