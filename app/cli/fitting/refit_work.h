// Fewer strokes in place of many: for `refit` and for Python.
#pragma once

#include "app/cli/options.h"
#include "render/fitting/fitting.h"
#include "render/refit/refit_target.h"

#include <atomic>
#include <functional>
#include <unordered_set>

namespace suffuse::cli {

struct RefitRequest {
    fitting::FitOptions options; ///< strokes: 0 unless they are given
    int pixels = fitting::usualFitPixels;
};
/// --strokes, --error, --style, --iterations, --pixels, --seed and --threads. Errors are usage errors.
Result<RefitRequest> refitRequestOf(const CommandLine &line);
/// --select or --layer; all strokes where neither is given. Errors are usage errors.
Result<std::unordered_set<StrokeId>> chosenStrokes(const CommandLine &line, const Painting &painting);
/// --to.
Result<refit::RefitGoal> goalOf(const CommandLine &line);

/// What is said of a refit when it is done.
struct RefitReport {
    std::size_t before = 0, now = 0, between = 0;
    Rect area;
    refit::RefitPictures::Difference was, is; ///< from the goal
    int steps = 0;
    std::uint64_t seed = 0;
    double seconds = 0;
    QString goal = {};         ///< the file that the strokes are to look like; empty: as they looked
    double wanted = 0, fitted = 0; ///< root mean square errors, 255ths: asked for (0: none was), and of the fit

    bool isWorse() const { return !goal.isEmpty() && is.rootMeanSquare > was.rootMeanSquare; }
    bool isTooFar() const { return wanted > 0 && fitted > wanted; }
};

struct Refitted {
    Painting painting;
    RefitReport report; ///< without its seconds
};
/// Makes the strokes anew. `progress` is called with [0, 1]; where an error is asked for, it begins anew with each number
/// of strokes. `cancel` ends it with an error.
Result<Refitted> refitted(const PaintingPtr &painting, const std::unordered_set<StrokeId> &ids,
                          const refit::RefitGoal &goal, const RefitRequest &request, const std::atomic<bool> &cancel,
                          const std::function<void(double)> &progress);

} // namespace suffuse::cli
