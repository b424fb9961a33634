#include "app/cli/pictures/film_work.h"
#include "app/cli/progress.h"

#include <QCoreApplication>
#include <QElapsedTimer>

namespace suffuse::cli {

namespace {

void addTimelapseOptions(CommandLine &line)
{
    line.add(
        {"o", "output"},
        QCoreApplication::translate("Cli", "Frames with their number, film/%05d.png; or film.webp, .webm or .mp4."),
        "OUT");
    line.add({"fps"}, QCoreApplication::translate("Cli", "Frames a second (default 25)."), "F");
    line.add({"duration"}, QCoreApplication::translate("Cli", "Length in seconds (default 10)."), "S");
    line.add({"idle"},
             QCoreApplication::translate("Cli", "Seconds that are kept of a pause in the painting (default 0.5)."),
             "S");
    addViewOptions(line);
    line.add({"transparent"}, QCoreApplication::translate("Cli", "No background: alpha holds the coverage."));
    line.add({"once"}, QCoreApplication::translate("Cli", "WebP: plays once instead of again and again."));
    line.add({"backend"}, QCoreApplication::translate("Cli", "auto, cpu, cuda or reference."), "BACKEND");
    line.add({"devices"},
             QCoreApplication::translate("Cli", "With CUDA: GPUs that share the frames, all or a number (default 1)."),
             "N");
    line.add({"threads"}, QCoreApplication::translate("Cli", "Number of threads (default: one a core)."), "N");
    line.add({"stats"}, QCoreApplication::translate("Cli", "Prints times and counts as JSON."));
}

QJsonObject statsJson(const Renderer &renderer, std::size_t renderers, const SequenceStats &stats, int frames,
                      double milliseconds)
{
    return {{"backend", nameOf(renderer.backend())},
            {"device", renderer.deviceName()},
            {"devices", qint64(renderers)},
            {"frames", frames},
            {"ms", milliseconds},
            {"tiles", qint64(stats.tiles)},
            {"tilesEvaluated", qint64(stats.tilesEvaluated)}};
}

int timelapse(const CommandLine &line, Film film, const RendererOptions &options)
{
    QElapsedTimer clock;
    clock.start();
    Result<Painting> painting = paintingOf(line.argument(0));
    if (!painting)
        return fail(painting.error());
    const Result<PictureOptions> picture = pictureOptions(line, *painting);
    if (!picture)
        return failUsage("timelapse", picture.error());
    film.file.width = picture->width;
    film.file.height = picture->height;
    if (const QString problem = problemOf(film.file); !problem.isEmpty())
        return failUsage("timelapse", QStringLiteral("%1: %2").arg(film.file.path, problem));
    const Result<FilmTask> work =
        filmTaskOf(std::make_shared<const Painting>(std::move(*painting)), film, *picture, options);
    if (!work)
        return fail(work.error());
    Result<SequenceStats> stats = Error{};
    {
        ProgressLine progress(QCoreApplication::translate("Cli", "drawing"), true);
        stats = writeFilm(*work, options.threads, interrupted(),
                          [&](qint64 done, qint64 all) { progress.show(done, all); });
    }
    if (!stats)
        return fail(interrupted() ? QCoreApplication::translate("Cli", "stopped; nothing was written") : stats.error());
    if (!stats->notice.isEmpty())
        warn(stats->notice);
    return line.isSet("stats") ? printJson(statsJson(*work->renderers.front(), work->renderers.size(), *stats,
                                                     int(work->moments.size()), double(clock.nsecsElapsed()) * 1e-6))
                               : Done;
}

} // namespace

int timelapseCommand(const QStringList &arguments)
{
    CommandLine line("timelapse",
                     QCoreApplication::translate("Cli", "Draws a painting while it is painted, frame by frame."),
                     {"IN"});
    addTimelapseOptions(line);
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    if (line.value("output").isEmpty())
        return failUsage("timelapse",
                         QCoreApplication::translate("Cli", "-o OUT is missing: name the frames or the film to write"));
    Result<Film> film = filmOf(line);
    if (!film)
        return failUsage("timelapse", film.error());
    film->file.path = line.value("output");
    if (const QString problem = problemOf(film->file); !problem.isEmpty())
        return failUsage("timelapse", QStringLiteral("-o %1: %2").arg(film->file.path, problem));
    const Result<RendererOptions> renderer = rendererOptions(line);
    if (!renderer)
        return failUsage("timelapse", renderer.error());
    return timelapse(line, *film, *renderer);
}

} // namespace suffuse::cli
