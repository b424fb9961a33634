// Times a renderer at the jobs an editor gives it.
#pragma once

#include "render/bench/rows.h"
#include "render/renderer.h"

#include <atomic>

namespace suffuse::bench {

/// What is drawn, by what, how often.
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

/// The job's painting at its end, all of its canvas, `width` pixels wide. `make`: makeRenderer (render/backends.h).
Job jobOf(PaintingPtr painting, int width, const RendererOptions &renderer, MakeRenderer make);

struct StageTimings {
    Timing nodeBuild;  ///< segments to nodes, by a fresh renderer
    Timing binning;    ///< nodes to tiles, of a full render
    Timing fullRender; ///< binning and pixels, nodes being there; on a device by its clock (RenderStats::deviceMs)
    Timing first;      ///< all three, by a fresh renderer
};

/// A fresh renderer for each run, then a full render by one that has its nodes. All of these fail as the renderer does,
/// or with a message when `cancel` was set.
Result<StageTimings> measureStages(const Job &job);

/// Full renders as in StageTimings, all by one renderer that is warm.
Result<Timing> measureFullRender(const Job &job);

/// Reading the painting from a `.suffuse` file and drawing it with a fresh renderer: what opening costs.
Result<Timing> measureOpen(const Job &job);

/// Frames in which one stroke's density changes a little, snapshot and all, up to the finished picture in memory or on
/// the device. `stroke` is a stroke of the painting.
Result<Timing> measureDrag(const Job &job, StrokeId stroke);

/// The same for one segment from the middle of the stroke.
Result<Timing> measureSegmentEdit(const Job &job, StrokeId stroke);

/// Frames of a stroke on top of the painting that grows to `segments` (at least 140), one each 1/60 s, while they
/// spread: the last 140 of them. They spread for `maxAge` seconds, so that 60 · maxAge of them are active.
Result<Timing> measureLiveStroke(const Job &job, double spread, int segments, float maxAge = 1);

/// An ordinary stroke from the middle of the order: of the ten there, the visible one with the median number of
/// segments. Null where no stroke is visible.
StrokePtr middleStroke(const Painting &painting);

/// `stroke` amid `count` strokes like the painting's own, spread over the canvas, half of them below it; it
/// has the id 1.
Painting amongOthers(const Painting &painting, const StrokePtr &stroke, std::size_t count);

/// Backend and device as the renderer names them, threads as they are used.
Result<Row> rowFor(const Job &job, const QString &name, const QString &paintingName);

} // namespace suffuse::bench
