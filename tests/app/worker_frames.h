// Small pictures, asked of a worker without a window.
#pragma once

#include "app/canvas/render_worker.h"
#include "tests/app/session.h"

#include <QSignalSpy>

namespace suffuse {

inline constexpr int width = 300, height = 200;

/// A curve of this density, dry.
inline RenderRequest request(float density, int pictureWidth = width)
{
    auto painting = std::make_shared<Painting>();
    painting->canvas.width = width;
    painting->canvas.height = height;
    Stroke stroke;
    stroke.id = 1;
    stroke.origin = {40, 100};
    Segment segment;
    segment.colour = {0.9f, 0.1f, 0.4f, 1};
    segment.diffusion = 60;
    segment.density = density;
    segment.bezier = {Offset{0, 0}, Offset{70, -60}, Offset{140, 60}, Offset{220, 0}};
    stroke.segments = {segment};
    painting->strokes = {std::make_shared<const Stroke>(std::move(stroke))};
    RenderRequest r;
    r.painting = painting;
    r.time = painting->end();
    r.view = View::ofArea(Rect::of(0, 0, pictureWidth, height), pictureWidth, height);
    return r;
}

/// What the CPU draws of it.
inline std::vector<std::uint32_t> pixelsOf(const RenderRequest &r)
{
    auto renderer = makeRenderer({.backend = Backend::Cpu});
    Picture8 picture;
    if (!renderer || !(*renderer)->render(r, picture))
        return {};
    return picture.argb;
}

/// Asks for a picture and waits for it.
inline FrameInfo draw(RenderWorker &worker, const RenderRequest &r)
{
    FrameInfo last;
    QSignalSpy frames(&worker, &RenderWorker::frameReady);
    const quint64 serial = worker.request(r);
    const auto arrived = [&] {
        for (const QList<QVariant> &arguments : frames)
            if (arguments[0].value<FrameInfo>().serial == serial)
                last = arguments[0].value<FrameInfo>();
        return last.serial == serial;
    };
    return QTest::qWaitFor(arrived, waitMs) ? last : FrameInfo{};
}

} // namespace suffuse
