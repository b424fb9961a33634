#include "app/cli/options.h"
#include "model/formats/files.h"
#include "render/image_io/image_io.h"

#include <QCoreApplication>
#include <QElapsedTimer>

#include <map>

namespace suffuse::cli {

namespace {

void addOptions(CommandLine &line)
{
    line.add({"o", "output"},
             QCoreApplication::translate("Cli", "The picture: .png, .tiff, .exr, .jpg, .webp or .pfm."), "OUT");
    line.add({"size"}, QCoreApplication::translate("Cli", "Pixels: WxH, or W alone; scales uniformly."), "WxH");
    line.add({"scale"}, QCoreApplication::translate("Cli", "Pixels a canvas unit (default 1)."), "F");
    line.add({"area"}, QCoreApplication::translate("Cli", "Part of the canvas, in canvas units (default: all of it)."),
             "X,Y,W,H");
    line.add({"time"}, QCoreApplication::translate("Cli", "The moment that is drawn, in seconds (default: the end)."),
             "T");
    line.add({"transparent"}, QCoreApplication::translate("Cli", "No background: alpha holds the coverage."));
    line.add({"depth"}, QCoreApplication::translate("Cli", "8, 16, half or float (default: the format's usual one)."),
             "DEPTH");
    line.add({"backend"}, QCoreApplication::translate("Cli", "auto, cpu, cuda or reference."), "BACKEND");
    line.add({"devices"},
             QCoreApplication::translate("Cli", "With CUDA: GPUs that share the picture, all or a number (default 1)."),
             "N");
    line.add({"threads"}, QCoreApplication::translate("Cli", "Number of threads (default: one a core)."), "N");
    line.add({"stats"}, QCoreApplication::translate("Cli", "Prints times and counts as JSON."));
}

/// Format, depth and alpha as asked; errors are usage errors. Sizes are checked later, when they are known.
Result<ImageOptions> imageOptions(const CommandLine &line)
{
    ImageOptions out;
    out.alpha = line.isSet("transparent");
    if (line.isSet("depth")) {
        static const std::map<QString, ImageDepth> depths = {{"8", ImageDepth::Bits8},
                                                             {"16", ImageDepth::Bits16},
                                                             {"half", ImageDepth::Half},
                                                             {"float", ImageDepth::Float}};
        const auto depth = depths.find(line.value("depth"));
        if (depth == depths.end())
            return Error{
                QCoreApplication::translate("Cli", "--depth %1: give 8, 16, half or float").arg(line.value("depth"))};
        out.depth = depth->second;
    }
    const QString problem = problemOf(imageFormatForPath(line.value("output")), out, 1, 1);
    if (!problem.isEmpty())
        return Error{QStringLiteral("%1: %2").arg(line.value("output"), problem)};
    return out;
}

struct Times {
    double loadMs = 0;
    double renderMs = 0;
    double writeMs = 0;
};

QJsonObject statsJson(const Renderer &renderer, const RenderRequest &request, const RenderStats &stats,
                      const Times &times)
{
    return {{"backend", renderer.backendName()},
            {"device", renderer.deviceName()},
            {"width", request.view.width},
            {"height", request.view.height},
            {"time", toSeconds(request.time)},
            {"strokes", qint64(request.painting->strokes.size())},
            {"segments", qint64(request.painting->segmentCount())},
            {"nodes", qint64(stats.nodes)},
            {"tiles", stats.tiles},
            {"tilesEvaluated", stats.tilesEvaluated},
            {"ms", QJsonObject{{"load", times.loadMs},
                               {"nodes", stats.nodesMs},
                               {"binning", stats.binningMs},
                               {"tiles", stats.tilesMs},
                               {"render", times.renderMs},
                               {"write", times.writeMs}}}};
}

/// Milliseconds since the last call.
double lap(QElapsedTimer &clock)
{
    const double ms = double(clock.nsecsElapsed()) * 1e-6;
    clock.start();
    return ms;
}

int render(const CommandLine &line, ImageOptions image, const RendererOptions &options)
{
    QElapsedTimer clock;
    clock.start();
    Times times;
    Result<Painting> painting = loadPainting(line.argument(0));
    if (!painting)
        return fail(painting.error());
    times.loadMs = lap(clock);
    const Result<PictureOptions> picture = pictureOptions(line, *painting);
    if (!picture)
        return failUsage("render", picture.error());
    const QString out = line.value("output");
    const QString problem = problemOf(imageFormatForPath(out), image, picture->width, picture->height);
    if (!problem.isEmpty())
        return failUsage("render", QStringLiteral("%1: %2").arg(out, problem));
    Result<std::unique_ptr<Renderer>> renderer = makeRenderer(options);
    if (!renderer)
        return fail(renderer.error());

    RenderRequest request;
    request.painting = std::make_shared<const Painting>(std::move(*painting));
    request.time = picture->time;
    request.view = View::ofArea(picture->area, picture->width, picture->height);
    request.transparent = image.alpha;
    FloatPicture pixels;
    const Result<RenderStats> stats = renderPicture(**renderer, request, pixels);
    if (!stats)
        return fail(QStringLiteral("%1: %2").arg(line.argument(0), stats.error()));
    times.renderMs = lap(clock);
    if (const QString notice = (*renderer)->notice(); !notice.isEmpty())
        warn(notice);
    image.cancel = &interrupted();
    if (const Result<void> written = writeImage(out, pixels, image); !written)
        return fail(written.error());
    times.writeMs = lap(clock);
    return line.isSet("stats") ? printJson(statsJson(**renderer, request, *stats, times)) : Done;
}

} // namespace

int renderCommand(const QStringList &arguments)
{
    CommandLine line("render",
                     QCoreApplication::translate("Cli", "Draws a painting or a recording into an image file."), {"IN"});
    addOptions(line);
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    if (line.value("output").isEmpty())
        return failUsage("render", QCoreApplication::translate("Cli", "-o OUT is missing: name the picture to write"));
    const Result<ImageOptions> image = imageOptions(line);
    if (!image)
        return failUsage("render", image.error());
    const Result<RendererOptions> renderer = rendererOptions(line);
    if (!renderer)
        return failUsage("render", renderer.error());
    return render(line, *image, *renderer);
}

} // namespace suffuse::cli
