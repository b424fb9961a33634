#include "app/widgets/paper/paper_preview.h"

#include "model/paint/half_width.h"
#include "render/backends.h"

#include <cmath>

namespace suffuse {

namespace {

constexpr int segments = 8;
constexpr float dry = 0.35f, wet = 1.7f; ///< peak densities at the ends

Stroke wash(const Rect &area)
{
    Stroke stroke;
    stroke.id = 1;
    stroke.style = {StyleKind::Uniform, {0.5f, 0.08f, 0}};
    const double y = (area.top + area.bottom) / 2, step = (area.right - area.left) / (segments - 2);
    const double spread = 0.55 * (area.bottom - area.top);
    for (int i = 0; i < segments; ++i) {
        Segment s;
        for (int k = 0; k < 4; ++k)
            s.bezier[std::size_t(k)] = {float(area.left + (i - 1 + k / 3.0) * step), float(y)};
        s.diffusion = float(spread * spread / 4);
        const float peak = dry + (wet - dry) * float(i) / (segments - 1);
        s.density = float(densityOfPeak(double(peak), spread));
        s.granulation = 0;
        s.colour = {0.85f, 0.75f, 0.9f, 1};
        stroke.segments.push_back(s);
    }
    for (std::size_t i = 1; i < stroke.segments.size(); ++i)
        stroke.segments[i].bezier[0] = stroke.segments[i - 1].bezier[3];
    return stroke;
}

} // namespace

QImage paperPreview(const Paper &paper, QSize size, double scale)
{
    const auto renderer = makeRenderer({.backend = Backend::Cpu, .threads = 1});
    if (!renderer || size.isEmpty())
        return {};
    auto painting = std::make_shared<Painting>();
    painting->canvas.width = size.width() / scale;
    painting->canvas.height = size.height() / scale;
    painting->canvas.paper = paper;
    painting->strokes.push_back(std::make_shared<const Stroke>(wash(painting->canvas.area())));
    RenderRequest request;
    request.painting = painting;
    request.time = painting->end();
    request.view = View::ofArea(painting->canvas.area(), size.width(), size.height());
    Picture8 picture;
    if (const auto stats = (*renderer)->render(request, picture); !stats)
        return {};
    const QImage shared(reinterpret_cast<const uchar *>(picture.argb.data()), picture.width, picture.height,
                        picture.width * 4, QImage::Format_ARGB32);
    return shared.copy();
}

} // namespace suffuse
