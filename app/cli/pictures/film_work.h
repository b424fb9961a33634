// A painting being painted, as a film: for `timelapse` and for Python.
#pragma once

#include "app/cli/options.h"
#include "model/document/timelapse.h"
#include "render/film/film_writer.h"
#include "render/sequence.h"

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace suffuse::cli {

struct Film {
    FilmOptions file;
    TimelapseOptions options;
};
/// --fps, --duration, --idle, --transparent and --once. The film has neither a path nor a size yet. Errors are usage errors.
Result<Film> filmOf(const CommandLine &line);

/// What draws a film. At least one renderer is there.
struct FilmTask {
    Film film;
    std::vector<std::unique_ptr<Renderer>> renderers;
    RenderRequest request; ///< without its time
    std::vector<Microseconds> moments; ///< of the frames
};
/// Makes the renderers that the options ask for. The film has its path.
Result<FilmTask> filmTaskOf(const PaintingPtr &painting, const Film &film, const PictureOptions &picture,
                            RendererOptions options);
/// The request for frames of a painting, at its end.
RenderRequest framesRequest(const PaintingPtr &painting, const PictureOptions &picture, bool transparent);

/// To how many whole pictures the work for so many frames amounts, about: frames are drawn only where they differ from the
/// one before.
std::size_t wholePictures(std::size_t frames);

/// Draws the frames, and puts the film into its place when all of them are there. `progress` is called by any thread.
/// `cancel` ends it with an error; then nothing was written.
Result<SequenceStats> writeFilm(const FilmTask &work, int threads, const std::atomic<bool> &cancel,
                                const std::function<void(qint64 done, qint64 all)> &progress);

} // namespace suffuse::cli
