#include "app/cli/pictures/film_work.h"

#include "render/backends.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace suffuse::cli {

namespace {

constexpr int mostFrames = 1'000'000;

/// How many seconds `option` asks for.
Result<double> seconds(const CommandLine &line, const QString &option, double usual, double least)
{
    if (!line.isSet(option))
        return usual;
    const std::optional<double> value = toNumber(line.value(option));
    if (!value || *value < least || *value > 1e6)
        return Error{QCoreApplication::translate("Cli", "--%1 %2: give a number from %3 to 1000000")
                         .arg(option, line.value(option))
                         .arg(least)};
    return *value;
}

} // namespace

Result<Film> filmOf(const CommandLine &line)
{
    const Result<double> fps = seconds(line, "fps", FilmOptions{}.fps, 0.001),
                         duration = seconds(line, "duration", 10, 0.001), idle = seconds(line, "idle", 0.5, 0);
    for (const Result<double> *value : {&fps, &duration, &idle})
        if (!*value)
            return Error{value->error()};
    const double frames = std::max(1.0, std::round(*fps * *duration));
    if (frames > mostFrames)
        return Error{QCoreApplication::translate("Cli", "%1 frames are too many: at most %2. Choose a smaller --fps or "
                                                        "--duration")
                         .arg(frames, 0, 'f', 0)
                         .arg(mostFrames)};
    Film film;
    film.options = {int(frames), *idle};
    film.file.frames = std::size_t(frames);
    film.file.fps = *fps;
    film.file.image.alpha = line.isSet("transparent");
    film.file.loops = !line.isSet("once");
    return film;
}

RenderRequest framesRequest(const PaintingPtr &painting, const PictureOptions &picture, bool transparent)
{
    RenderRequest request;
    request.time = painting->end();
    request.painting = withoutDrafts(painting);
    request.view = View::ofArea(picture.area, picture.width, picture.height);
    request.transparent = transparent;
    return request;
}

std::size_t wholePictures(std::size_t frames)
{
    constexpr std::size_t framesOfPicture = 8;
    return frames / framesOfPicture + 1;
}

Result<FilmTask> filmTaskOf(const PaintingPtr &painting, const Film &film, const PictureOptions &picture,
                            RendererOptions options)
{
    FilmTask work;
    work.film = film;
    work.film.file.width = picture.width;
    work.film.file.height = picture.height;
    if (filmKindOf(film.file.path) != FilmKind::Frames)
        options.devices = 1; // its frames are wanted in order
    work.moments = timelapseMoments(*painting, film.options);
    work.request = framesRequest(painting, picture, film.file.image.alpha);
    if (options.backend == Backend::Auto && options.devices == 1)
        options.backend = quickestBackend(work.request, wholePictures(work.moments.size()), options);
    auto renderers = makeRenderers(options);
    if (!renderers)
        return Error{renderers.error()};
    work.renderers = std::move(*renderers);
    return work;
}

Result<SequenceStats> writeFilm(const FilmTask &work, int threads, const std::atomic<bool> &cancel,
                                const std::function<void(qint64 done, qint64 all)> &progress)
{
    FilmOptions options = work.film.file;
    options.image.cancel = &cancel;
    const auto file = openFilm(options);
    if (!file)
        return Error{file.error()};
    std::atomic<qint64> done = 0;
    Result<SequenceStats> stats = renderSequence(
        work.renderers, work.request, work.moments, threads,
        [&](std::size_t i, const FloatPicture &frame) {
            const Result<void> written = (*file)->write(i, frame);
            progress(++done, qint64(work.moments.size()));
            return written;
        },
        &cancel);
    if (stats)
        if (const Result<void> kept = (*file)->commit(); !kept)
            return Error{kept.error()};
    return stats;
}

} // namespace suffuse::cli
