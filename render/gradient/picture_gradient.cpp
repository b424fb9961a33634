#include "render/gradient/picture_gradient.h"

#include <algorithm>

namespace suffuse::gradient {

namespace {

/// What segments and fills have in common.
void setSlopes(const auto &by, const auto &source, Microseconds time, auto &out)
{
    const double spread = source.spread(time);
    out.density = by.density;
    out.diffusion = spread > 0 ? by.spread * 2 * source.age(time) / spread : 0; // s² = 4Dt
    std::copy_n(by.colour, 3, out.colour);
    out.opacity = by.opacity, out.granulation = by.granulation;
}

SegmentSlopes slopesOf(const SegmentNumbers &by, const Segment &segment, Microseconds time)
{
    SegmentSlopes out;
    for (int i = 0; i < 4; ++i)
        out.bezier[i] = {by.x[i], by.y[i]};
    setSlopes(by, segment, time, out);
    return out;
}

} // namespace

Result<DifferentiablePicture> DifferentiablePicture::draw(PaintingPtr painting, Microseconds time, const View &view,
                                                          const Threads &threads, const Precision &precision)
{
    auto flat = flatten(*painting, time, view, threads);
    if (!flat)
        return Error{flat.error()};
    DifferentiablePicture out;
    out.m_painting = std::move(painting);
    out.m_time = time;
    out.m_flat = std::move(*flat);
    out.m_gradient = std::make_unique<SceneGradient<float>>(threads);
    out.m_gradient->choose(out.m_flat.scene, precision);
    out.m_gradient->draw(out.m_flat.scene);
    return out;
}

PictureGradient DifferentiablePicture::backward(std::span<const float> lossByRgb)
{
    const FlatGradient &by = m_gradient->backward(lossByRgb);
    PictureGradient out;
    out.strokes.resize(m_painting->strokes.size());
    for (std::size_t i = 0; i < out.strokes.size(); ++i) {
        out.strokes[i].segments.resize(m_painting->strokes[i]->segments.size());
        if (m_painting->strokes[i]->fill)
            out.strokes[i].fill.emplace();
    }
    const FlatScene &scene = m_flat.scene;
    for (std::size_t i = 0; i < scene.strokes.size(); ++i) {
        const FlatStroke &flat = scene.strokes[i];
        const Stroke &stroke = *m_painting->strokes[m_flat.strokes[i]];
        StrokeGradient &to = out.strokes[m_flat.strokes[i]];
        std::copy_n(by.strokes[i].xi, 3, to.xi);
        if (flat.filled)
            setSlopes(by.strokes[i].fill, *stroke.fill, m_time, *to.fill);
        for (std::size_t k = flat.first; k < flat.first + flat.count; ++k) {
            const std::size_t place = m_flat.segments[k];
            to.segments[place] = slopesOf(by.segments[k], stroke.segments[place], m_time);
        }
    }
    return out;
}

} // namespace suffuse::gradient
