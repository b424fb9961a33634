#include "app/cli/options.h"
#include "app/cli/progress.h"
#include "model/formats/files.h"
#include "model/timelapse.h"
#include "render/image_io/image_io.h"
#include "render/sequence.h"

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <filesystem>

namespace suffuse::cli {

namespace {

constexpr int mostFrames = 1'000'000;

void addOptions(CommandLine &line)
{
    line.add({"o", "output"}, QCoreApplication::translate("Cli", "The frames, with their number: film/%05d.png."),
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
    line.add({"backend"}, QCoreApplication::translate("Cli", "auto, cpu, cuda or reference."), "BACKEND");
    line.add({"devices"},
             QCoreApplication::translate("Cli", "With CUDA: GPUs that share the frames, all or a number (default 1)."),
             "N");
    line.add({"threads"}, QCoreApplication::translate("Cli", "Number of threads (default: one a core)."), "N");
    line.add({"stats"}, QCoreApplication::translate("Cli", "Prints times and counts as JSON."));
}

/// Names of numbered files: "film/%05d.png".
struct FrameNames {
    QString folder, before, after;
    int digits = 1;

    QString nameOf(std::size_t frame) const
    {
        return before + QStringLiteral("%1").arg(qulonglong(frame), digits, 10, QLatin1Char('0')) + after;
    }
};

Result<FrameNames> frameNames(const QString &pattern)
{
    static const QRegularExpression number(QStringLiteral("%(?:0?(\\d))?d"));
    const QFileInfo file(pattern);
    const QString name = file.fileName();
    const QRegularExpressionMatch found = number.match(name);
    FrameNames out{file.path(), name.left(found.capturedStart()), name.mid(found.capturedEnd()),
                   std::max(1, found.captured(1).toInt())};
    if (!found.hasMatch() || out.before.contains(QLatin1Char('%')) || out.after.contains(QLatin1Char('%')))
        return Error{QCoreApplication::translate("Cli", "-o %1: frames are numbered files: give a name such as "
                                                        "film/%05d.png")
                         .arg(pattern)};
    return out;
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

Result<TimelapseOptions> filmOptions(const CommandLine &line)
{
    const Result<double> fps = seconds(line, "fps", 25, 0.001), duration = seconds(line, "duration", 10, 0.001),
                         idle = seconds(line, "idle", 0.5, 0);
    for (const Result<double> *value : {&fps, &duration, &idle})
        if (!*value)
            return Error{value->error()};
    const double frames = std::max(1.0, std::round(*fps * *duration));
    if (frames > mostFrames)
        return Error{QCoreApplication::translate("Cli", "%1 frames are too many: at most %2. Choose a smaller --fps or "
                                                        "--duration")
                         .arg(frames, 0, 'f', 0)
                         .arg(mostFrames)};
    return TimelapseOptions{int(frames), *idle};
}

/// Frames on their way to their folder: they lie in one beside their places until all are whole.
class FrameFolder {
public:
    explicit FrameFolder(const FrameNames &names)
        : m_names(names), m_existed(QDir(names.folder).exists()), m_made(QDir().mkpath(names.folder)),
          m_hidden(QDir(names.folder).filePath(QStringLiteral(".suffuse-frames-XXXXXX")))
    {}
    ~FrameFolder()
    {
        m_hidden.remove();
        if (!m_existed && !m_kept)
            QDir().rmdir(m_names.folder);
    }
    FrameFolder(const FrameFolder &) = delete;
    FrameFolder &operator=(const FrameFolder &) = delete;

    Result<void> check() const
    {
        if (m_made && m_hidden.isValid())
            return {};
        return Error{QCoreApplication::translate("Cli", "%1: cannot write into this folder. Choose another one.")
                         .arg(m_names.folder)};
    }
    QString pathOf(std::size_t frame) const { return m_hidden.filePath(m_names.nameOf(frame)); }

    /// Puts all frames into their places.
    Result<void> keep(std::size_t frames)
    {
        for (std::size_t i = 1; i <= frames; ++i) {
            const QString path = QDir(m_names.folder).filePath(m_names.nameOf(i));
            std::error_code error;
            std::filesystem::rename(pathOf(i).toStdString(), path.toStdString(), error); // over an older film
            if (error)
                return Error{QStringLiteral("%1: %2").arg(path, QString::fromLocal8Bit(error.message().c_str()))};
            m_kept = true;
        }
        return {};
    }

private:
    FrameNames m_names;
    bool m_existed, m_made;
    QTemporaryDir m_hidden;
    bool m_kept = false;
};

struct Film {
    FrameNames names;
    TimelapseOptions options;
    ImageOptions image;
};

QJsonObject statsJson(const Renderer &renderer, std::size_t renderers, const SequenceStats &stats, int frames,
                      double milliseconds)
{
    return {{"backend", renderer.backendName()},
            {"device", renderer.deviceName()},
            {"devices", qint64(renderers)},
            {"frames", frames},
            {"ms", milliseconds},
            {"tiles", qint64(stats.tiles)},
            {"tilesEvaluated", qint64(stats.tilesEvaluated)}};
}

int timelapse(const CommandLine &line, const Film &film, const RendererOptions &options)
{
    QElapsedTimer clock;
    clock.start();
    Result<Painting> painting = loadPainting(line.argument(0));
    if (!painting)
        return fail(painting.error());
    const Result<PictureOptions> picture = pictureOptions(line, *painting);
    if (!picture)
        return failUsage("timelapse", picture.error());
    const QString out = line.value("output");
    if (const QString problem = problemOf(imageFormatForPath(out), film.image, picture->width, picture->height);
        !problem.isEmpty())
        return failUsage("timelapse", QStringLiteral("%1: %2").arg(out, problem));
    const auto renderers = makeRenderers(options);
    if (!renderers)
        return fail(renderers.error());
    FrameFolder folder(film.names);
    if (const Result<void> checked = folder.check(); !checked)
        return fail(checked.error());

    const std::vector<Microseconds> moments = timelapseMoments(*painting, film.options);
    RenderRequest request;
    request.painting = std::make_shared<const Painting>(std::move(*painting));
    request.view = View::ofArea(picture->area, picture->width, picture->height);
    request.transparent = film.image.alpha;
    Result<SequenceStats> stats = Error{};
    {
        ProgressLine progress(QCoreApplication::translate("Cli", "drawing"), true);
        std::atomic<qint64> done = 0;
        stats = renderSequence(
            *renderers, request, moments, options.threads,
            [&](std::size_t i, const FloatPicture &frame) {
                const Result<void> written = writeImage(folder.pathOf(i + 1), frame, film.image);
                progress.show(++done, qint64(moments.size()));
                return written;
            },
            &interrupted());
    }
    if (!stats)
        return fail(interrupted() ? QCoreApplication::translate("Cli", "stopped; nothing was written") : stats.error());
    if (!stats->notice.isEmpty())
        warn(stats->notice);
    if (const Result<void> kept = folder.keep(moments.size()); !kept)
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
                         QCoreApplication::translate("Cli", "-o OUT is missing: name the frames to write"));
    const Result<FrameNames> names = frameNames(line.value("output"));
    if (!names)
        return failUsage("timelapse", names.error());
    const Result<TimelapseOptions> options = filmOptions(line);
    if (!options)
        return failUsage("timelapse", options.error());
    const Result<RendererOptions> renderer = rendererOptions(line);
    if (!renderer)
        return failUsage("timelapse", renderer.error());
    ImageOptions image;
    image.alpha = line.isSet("transparent");
    image.cancel = &interrupted();
    if (const QString problem = problemOf(imageFormatForPath(line.value("output")), image, 1, 1); !problem.isEmpty())
        return failUsage("timelapse", QStringLiteral("%1: %2").arg(line.value("output"), problem));
    return timelapse(line, {*names, *options, image}, *renderer);
}

} // namespace suffuse::cli
