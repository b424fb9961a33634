#include "app/widgets/brush/brush_preview.h"

#include "model/brush/stroke_builder.h"
#include "render/backends.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

constexpr double aspectLength = 150; ///< length of the stroke in canvas units, at spread 9

/// An S from left to right, pressed as a calligrapher would: light, heavy, light.
std::vector<PenSample> sShape(double width, double height)
{
    constexpr int count = 64;
    std::vector<PenSample> samples;
    for (int i = 0; i <= count; ++i) {
        const double p = double(i) / count;
        const double x = width * (0.16 + 0.68 * p);
        const double y = height * (0.5 + 0.2 * std::sin(2 * std::numbers::pi * p));
        samples.push_back({{x, y}, toMicroseconds(1.1 * p), float(0.35 + 0.65 * std::sin(std::numbers::pi * p))});
    }
    return samples;
}

} // namespace

QImage BrushPreview::render(const Brush &brush, QSize size)
{
    if (!m_renderer) {
        auto made = makeRenderer({.backend = Backend::Cpu, .threads = 1});
        if (!made)
            return {};
        m_renderer = std::move(*made);
    }
    const double distance = std::clamp(std::pow(brush.spread() / 9, 0.75), 0.25, 50.0);
    auto painting = std::make_shared<Painting>();
    painting->canvas.width = aspectLength * distance;
    painting->canvas.height = painting->canvas.width * size.height() / size.width();
    if (brush.granulation < 1) {
        painting->canvas.paper.kind = PaperKind::Procedural;
        painting->canvas.paper.scale = float(std::max(2.5, 6 * distance));
        painting->canvas.paper.strength = 0.5f;
    }
    const StrokePtr stroke = buildStroke(brush, 1, sShape(painting->canvas.width, painting->canvas.height));
    if (stroke)
        painting->strokes.push_back(stroke);

    RenderRequest request;
    request.painting = painting;
    request.time = painting->end();
    request.view = View::ofArea(painting->canvas.area(), size.width(), size.height());
    request.transparent = true;
    Picture8 picture;
    m_renderer->invalidate();
    if (const auto stats = m_renderer->render(request, picture); !stats)
        return {};
    const QImage shared(reinterpret_cast<const uchar *>(picture.argb.data()), picture.width, picture.height,
                        picture.width * 4, QImage::Format_ARGB32);
    return shared.copy();
}

} // namespace suffuse
