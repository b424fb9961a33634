// Measures how long a renderer takes for the work of an editor.
#pragma once

#include "render/bench/rows.h"
#include "render/renderer.h"

#include <atomic>

namespace suffuse::bench {

/// What is drawn, by which renderer, and how often.
struct Job {
    PaintingPtr painting;
    View view;
    Microseconds time = 0; ///< document time T
    RendererOptions renderer;
    MakeRenderer make;
    int runs = 9;
    int dragSteps = 30;
    const std::atomic<bool> *cancel = nullptr;
};

/// A job for a painting at its end, with its whole canvas, `width` pixels wide. `make` is makeRenderer
/// (render/backends.h).
Job jobOf(PaintingPtr painting, int width, const RendererOptions &renderer, MakeRenderer make);

struct StageTimings {
    Timing nodeBuild;  ///< segments to nodes, by a new renderer
    Timing binning;    ///< nodes to tiles, in a full render
    Timing fullRender; ///< sorting and pixels, while nodes exist; on a device by its clock (RenderStats::deviceMs)
    Timing first;      ///< all three, by a new renderer
};

/// Measures with a new renderer for each run, then full renders by one that has its nodes. This function and those
/// below fail as the renderer does, or with a message if `cancel` was set.
Result<StageTimings> measureStages(const Job &job);

/// Measures full renders as in StageTimings, all by one warm renderer.
Result<Timing> measureFullRender(const Job &job);

/// Measures the picture after the zoom has come to the next octave and back, from segments to pixels, by one warm
/// renderer.
Result<Timing> measureZoom(const Job &job);

/// Measures the cost of opening: reading the painting from a `.suffuse` file, and drawing it with a new renderer.
Result<Timing> measureOpen(const Job &job);

/// Measures frames in which the density of one stroke changes a little, from the snapshot to the finished picture in
/// memory or on the device. `stroke` is a stroke of the painting.
Result<Timing> measureDrag(const Job &job, StrokeId stroke);

/// The same for one segment in the middle of the stroke.
Result<Timing> measureSegmentEdit(const Job &job, StrokeId stroke);

/// The same where the node between the first two segments of the stroke moves a little.
Result<Timing> measureNodeDrag(const Job &job, StrokeId stroke);

/// Measures frames of a stroke on top of the painting that grows to `segments` (at least 140), with a frame each 1/60 s
/// while segments spread: the last 140 of them. Segments spread for `maxAge` seconds, so that 60 · maxAge of them are
/// active.
Result<Timing> measureLiveStroke(const Job &job, double spread, int segments, float maxAge = 1);

/// Measures frames in which the opacity of a group changes.
Result<Timing> measureGroupOpacity(const Job &job, GroupId group);

/// An ordinary stroke from the middle of the order: of the ten strokes there, the visible one with the median number of
/// segments. Null where no stroke is visible.
StrokePtr middleStroke(const Painting &painting);

/// A painting with `stroke` among `count` strokes like those of `painting`, which are spread over the canvas, half of
/// them below it. The stroke gets the id 1.
Painting amongOthers(const Painting &painting, const StrokePtr &stroke, std::size_t count);

/// Deals a painting's strokes into so many groups of different modes and opacities, one after another. With `clips`
/// every third one is clipped to the one below it.
Painting inLayers(Painting painting, std::size_t groups, bool clips = false);

/// A row with backend and device as the renderer names them, and with the number of threads that are used.
Result<Row> rowFor(const Job &job, const QString &name, const QString &paintingName);

} // namespace suffuse::bench
