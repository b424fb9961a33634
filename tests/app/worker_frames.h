// Small pictures, asked of a worker without a window.
#pragma once

#include "app/session/frames/frame_thread.h"
#include "render/backends.h"
#include "tests/app/session.h"

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
inline Pixels<std::uint32_t> pixelsOf(const RenderRequest &r)
{
    auto renderer = makeRenderer({.backend = Backend::Cpu});
    Picture8 picture;
    if (!renderer || !(*renderer)->render(r, picture))
        return {};
    return picture.argb;
}

/// Asks for a picture and waits for it.
inline FrameInfo draw(FrameThread &worker, const RenderRequest &r)
{
    FrameInfo last;
    quint64 serial = 0;
    QObject here; // a signal spy would listen on the worker's thread
    QObject::connect(&worker, &FrameThread::frameReady, &here, [&](const FrameInfo &frame) {
        if (frame.serial == serial)
            last = frame;
    });
    serial = worker.request(r);
    const auto arrived = [&] { return last.serial == serial; };
    return QTest::qWaitFor(arrived, waitMs) ? last : FrameInfo{};
}

/// Of a picture without padding.
inline Pixels<std::uint32_t> argbOf(const QImage &image)
{
    const auto *argb = reinterpret_cast<const std::uint32_t *>(image.constBits());
    return {argb, argb + std::size_t(image.width()) * std::size_t(image.height())};
}

/// Of all channels, in levels of 8 bits; 256 where the sizes differ.
inline int greatestDifference(const Pixels<std::uint32_t> &a, const Pixels<std::uint32_t> &b)
{
    int greatest = a.size() == b.size() ? 0 : 256;
    for (std::size_t i = 0; i < a.size() && greatest < 256; ++i)
        for (int shift = 0; shift < 32; shift += 8)
            greatest = std::max(greatest, std::abs(int(a[i] >> shift & 255) - int(b[i] >> shift & 255)));
    return greatest;
}

/// Of red, green and blue, in levels of 8 bits.
inline double meanDifference(const Pixels<std::uint32_t> &a, const Pixels<std::uint32_t> &b)
{
    if (a.size() != b.size())
        return 256;
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int shift = 0; shift < 24; shift += 8)
            sum += std::abs(int(a[i] >> shift & 255) - int(b[i] >> shift & 255));
    return sum / (3.0 * double(a.size()));
}

} // namespace suffuse
