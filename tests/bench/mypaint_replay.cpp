#include "tests/bench/baselines.h"

#ifdef SUFFUSE_LIBMYPAINT

#include <QElapsedTimer>

#include <cmath>

extern "C" {
#include <mypaint-brush.h>
#include <mypaint-fixed-tiled-surface.h>
}

namespace suffuse::baseline {

namespace {

/// Hue, saturation and value of the stroke's colour do not matter for time; its red, yellow and blue stand for them.
void setBrush(MyPaintBrush *brush, double radius, const Colour &colour)
{
    mypaint_brush_set_base_value(brush, MYPAINT_BRUSH_SETTING_RADIUS_LOGARITHMIC, float(std::log(radius)));
    mypaint_brush_set_base_value(brush, MYPAINT_BRUSH_SETTING_HARDNESS, 0.5f);
    mypaint_brush_set_base_value(brush, MYPAINT_BRUSH_SETTING_OPAQUE, colour.opacity);
    mypaint_brush_set_base_value(brush, MYPAINT_BRUSH_SETTING_COLOR_H, colour.red);
    mypaint_brush_set_base_value(brush, MYPAINT_BRUSH_SETTING_COLOR_S, colour.yellow);
    mypaint_brush_set_base_value(brush, MYPAINT_BRUSH_SETTING_COLOR_V, colour.blue);
}

void replayStroke(MyPaintBrush *brush, MyPaintSurface *surface, const Stroke &stroke, const RenderRequest &request)
{
    mypaint_brush_reset(brush);
    mypaint_brush_new_stroke(brush);
    const auto to = [&](Point p, double pressure, double seconds) {
        const Point at = request.view.toPixels(p);
        mypaint_brush_stroke_to(brush, surface, float(at.x), float(at.y), float(pressure), 0, 0, seconds);
    };
    to(stroke.cubicOf(stroke.segments.front()).p[0], 0, 10); // far from the stroke before
    for (const Segment &s : stroke.segments) {
        setBrush(brush, 1.2 * s.spread(request.time) * request.view.scale, s.colour);
        to(stroke.cubicOf(s).p[3], 1, 1.0 / 60);
    }
}

} // namespace

double myPaintReplay(const RenderRequest &request)
{
    MyPaintFixedTiledSurface *tiles = mypaint_fixed_tiled_surface_new(request.view.width, request.view.height);
    MyPaintSurface *surface = mypaint_fixed_tiled_surface_interface(tiles);
    MyPaintBrush *brush = mypaint_brush_new();
    mypaint_brush_from_defaults(brush);
    QElapsedTimer timer;
    timer.start();
    for (const StrokePtr &stroke : request.painting->strokes) {
        if (!request.painting->isVisible(*stroke))
            continue;
        mypaint_surface_begin_atomic(surface);
        replayStroke(brush, surface, *stroke, request);
        MyPaintRectangle dirty;
        mypaint_surface_end_atomic(surface, &dirty);
    }
    const double ms = double(timer.nsecsElapsed()) * 1e-6;
    mypaint_brush_unref(brush);
    mypaint_surface_unref(surface);
    return ms;
}

} // namespace suffuse::baseline

#else

double suffuse::baseline::myPaintReplay(const RenderRequest &)
{
    return -1;
}

#endif
