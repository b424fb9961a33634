#include "app/cli/options.h"
#include "app/cli/progress.h"
#include "model/document/timelapse.h"
#include "render/backends.h"
#include "render/film/film_writer.h"
#include "render/sequence.h"

#include <QCoreApplication>
#include <QElapsedTimer>

namespace suffuse::cli {

namespace {

constexpr int mostFrames = 1'000'000;

void addOptions(CommandLine &line)
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
    line.add({"size"}, QCoreApplication::translate("Cli", "Pixels: WxH, or W alone; scales uniformly."), "WxH");
    line.add({"scale"}, QCoreApplication::translate("Cli", "Pixels a canvas unit (default 1)."), "F");
    line.add({"area"}, QCoreApplication::translate("Cli", "Part of the canvas, in canvas units (default: all of it)."),
             "X,Y,W,H");
    line.add({"transparent"}, QCoreApplication::translate("Cli", "No background: alpha holds the coverage."));
    line.add({"once"}, QCoreApplication::translate("Cli", "WebP: plays once instead of again and again."));
    line.add({"backend"}, QCoreApplication::translate("Cli", "auto, cpu, cuda or reference."), "BACKEND");
    line.add({"devices"},
             QCoreApplication::translate("Cli", "With CUDA: GPUs that share the frames, all or a number (default 1)."),
             "N");
    line.add({"threads"}, QCoreApplication::translate("Cli", "Number of threads (default: one a core)."), "N");
    line.add({"stats"}, QCoreApplication::translate("Cli", "Prints times and counts as JSON."));
}

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

struct Film {
    FilmOptions file;
    TimelapseOptions options;
};

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
    film.file.path = line.value("output");
    film.file.frames = std::size_t(frames);
    film.file.fps = *fps;
    film.file.image.alpha = line.isSet("transparent");
    film.file.image.cancel = &interrupted();
    film.file.loops = !line.isSet("once");
    if (const QString problem = problemOf(film.file); !problem.isEmpty())
        return Error{QStringLiteral("-o %1: %2").arg(film.file.path, problem)};
    return film;
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

int timelapse(const CommandLine &line, Film film, RendererOptions options)
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
    if (filmKindOf(film.file.path) != FilmKind::Frames)
        options.devices = 1; // its frames are wanted in order
    const std::vector<Microseconds> moments = timelapseMoments(*painting, film.options);
    RenderRequest request;
    request.time = painting->end();
    request.painting = withoutDrafts(std::make_shared<const Painting>(std::move(*painting)));
    request.view = View::ofArea(picture->area, picture->width, picture->height);
    request.transparent = film.file.image.alpha;
    constexpr std::size_t framesOfPicture = 8; // Frames are drawn only where they differ from the one before.
    if (options.backend == Backend::Auto && options.devices == 1)
        options.backend = quickestBackend(request, moments.size() / framesOfPicture + 1, options);
    const auto renderers = makeRenderers(options);
    if (!renderers)
        return fail(renderers.error());
    const auto file = openFilm(film.file);
    if (!file)
        return fail(file.error());

    Result<SequenceStats> stats = Error{};
    {
        ProgressLine progress(QCoreApplication::translate("Cli", "drawing"), true);
        std::atomic<qint64> done = 0;
        stats = renderSequence(
            *renderers, request, moments, options.threads,
            [&](std::size_t i, const FloatPicture &frame) {
                const Result<void> written = (*file)->write(i, frame);
                progress.show(++done, qint64(moments.size()));
                return written;
            },
            &interrupted());
    }
    if (!stats)
        return fail(interrupted() ? QCoreApplication::translate("Cli", "stopped; nothing was written") : stats.error());
    if (!stats->notice.isEmpty())
        warn(stats->notice);
    if (const Result<void> kept = (*file)->commit(); !kept)
        return fail(kept.error());
    return line.isSet("stats") ? printJson(statsJson(*renderers->front(), renderers->size(), *stats,
                                                     int(moments.size()), double(clock.nsecsElapsed()) * 1e-6))
                               : Done;
}

} // namespace

int timelapseCommand(const QStringList &arguments)
{
    CommandLine line("timelapse",
                     QCoreApplication::translate("Cli", "Draws a painting while it is painted, frame by frame."),
                     {"IN"});
    addOptions(line);
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    if (line.value("output").isEmpty())
        return failUsage("timelapse",
                         QCoreApplication::translate("Cli", "-o OUT is missing: name the frames or the film to write"));
    const Result<Film> film = filmOf(line);
    if (!film)
        return failUsage("timelapse", film.error());
    const Result<RendererOptions> renderer = rendererOptions(line);
    if (!renderer)
        return failUsage("timelapse", renderer.error());
    return timelapse(line, *film, *renderer);
}

} // namespace suffuse::cli
