#include "app/session/painting/picture_change.h"

#include "model/paint/half_width.h"
#include "render/backends.h"

namespace suffuse {

namespace {

constexpr double longestPicture = 320; ///< pixels

} // namespace

PictureChange::PictureChange(std::vector<StrokePtr> before) : m_strokes(std::move(before))
{
    if (auto made = makeRenderer({.backend = Backend::Cpu}))
        m_renderer = std::move(*made);
    Rect box;
    for (const StrokePtr &stroke : m_strokes)
        box = box.united(seenBox(*stroke));
    const double longest = std::max({box.width(), box.height(), 1e-9});
    m_view.scale = std::min(1.0, longestPicture / longest);
    m_view.centre = box.isEmpty() ? Point() : box.centre();
    m_view.width = int(std::clamp(std::ceil(box.width() * m_view.scale), 1.0, longestPicture));
    m_view.height = int(std::clamp(std::ceil(box.height() * m_view.scale), 1.0, longestPicture));
}

bool PictureChange::draw(const std::vector<StrokePtr> &strokes, Picture8 &picture)
{
    if (!m_renderer)
        return false;
    auto painting = std::make_shared<Painting>();
    for (const StrokePtr &stroke : strokes)
        painting->strokes.push_back(stroke);
    RenderRequest request;
    request.painting = painting;
    request.time = painting->end();
    request.view = m_view;
    return bool(m_renderer->render(request, picture));
}

std::optional<double> PictureChange::meanTo(const std::vector<StrokePtr> &after)
{
    m_drawn = m_drawn || draw(m_strokes, m_before);
    Picture8 picture;
    if (!m_drawn || !draw(after, picture) || picture.argb.size() != m_before.argb.size())
        return std::nullopt;
    double sum = 0;
    for (std::size_t i = 0; i < picture.argb.size(); ++i)
        for (int shift = 0; shift < 24; shift += 8)
            sum += std::abs(int(picture.argb[i] >> shift & 255) - int(m_before.argb[i] >> shift & 255));
    return sum / (255.0 * 3 * double(std::max<std::size_t>(picture.argb.size(), 1)));
}

} // namespace suffuse
