#include "app/cli/options.h"
#include "app/cli/progress.h"
#include "app/cli/tiles/tiles_command.h"
#include "model/painting/resolution.h"
#include "render/backends.h"
#include "render/image_io/colour_conversion.h"
#include "render/image_io/image_io.h"
#include "render/layered/layered_file.h"

#include <QCoreApplication>
#include <QElapsedTimer>

#include <cmath>
#include <map>
#include <new>

#include <unistd.h>

namespace suffuse::cli {

namespace {

void addRenderOptions(CommandLine &line)
{
    line.add({"o", "output"},
             QCoreApplication::translate("Cli", "The picture: .png, .tiff, .exr, .jpg, .webp or .pfm; .ora or .psd: "
                                                "its layers; -: standard output."),
             "OUT");
    line.add({"format"},
             QCoreApplication::translate("Cli", "With -o -: png, tiff, exr, jpg, webp or pfm (default: png)."),
             "FORMAT");
    addTilesOptions(line);
    addViewOptions(line);
    line.add({"time"}, QCoreApplication::translate("Cli", "The moment that is drawn, in seconds (default: the end)."),
             "T");
    line.add({"transparent"}, QCoreApplication::translate("Cli", "No background: alpha holds the coverage."));
    line.add({"drafts"}, QCoreApplication::translate("Cli", "Draws groups that are drafts, too."));
    line.add({"depth"}, QCoreApplication::translate("Cli", "8, 16, half or float (default: the format's usual one)."),
             "DEPTH");
    line.add({"quality"},
             QCoreApplication::translate("Cli", "Of JPEG and WebP, 1 to 100 (default 92); WebP loses nothing at 100."),
             "N");
    line.add({"dpi"},
             QCoreApplication::translate(
                 "Cli", "Pixels an inch, as the file says it (default: what makes the picture as large on "
                        "paper as IN says that it is; else it says nothing)."),
             "N");
    line.add({"profile"},
             QCoreApplication::translate("Cli", "ICC profile of RGB colours that the file has (default: sRGB)."),
             "FILE");
    line.add({"backend"}, QCoreApplication::translate("Cli", "auto, cpu, cuda or reference."), "BACKEND");
    line.add({"devices"},
             QCoreApplication::translate("Cli", "With CUDA: GPUs that share the picture, all or a number (default 1)."),
             "N");
    line.add({"threads"}, QCoreApplication::translate("Cli", "Number of threads (default: one a core)."), "N");
    line.add({"stats"}, QCoreApplication::translate("Cli", "Prints times and counts as JSON."));
}

bool isToStdout(const CommandLine &line)
{
    return line.value("output") == QLatin1String("-");
}

/// Errors are usage errors.
Result<ImageFormat> formatOf(const CommandLine &line)
{
    if (!isToStdout(line)) {
        if (line.isSet("format"))
            return Error{QCoreApplication::translate("Cli", "--format is for -o -; the ending of %1 chooses the format")
                             .arg(line.value("output"))};
        return imageFormatForPath(line.value("output"));
    }
    if (line.isSet("stats"))
        return Error{QCoreApplication::translate("Cli", "--stats and -o - both write to standard output; give one")};
    if (::isatty(STDOUT_FILENO))
        return Error{QCoreApplication::translate("Cli",
                                                 "standard output is a terminal, which shows no pictures; lead it "
                                                 "into a file or a program")};
    const QString name = line.isSet("format") ? line.value("format") : QStringLiteral("png");
    const ImageFormat format = imageFormatForPath(QLatin1Char('.') + name);
    if (format == ImageFormat::Unknown)
        return Error{QCoreApplication::translate("Cli", "--format %1: give one of %2")
                         .arg(name, imageEndings().join(QStringLiteral(", ")))};
    return format;
}

/// --quality and --dpi. Where the format has no such thing, that is said and it is drawn all the same.
Result<void> takeNumbers(const CommandLine &line, ImageFormat format, ImageOptions &image)
{
    if (line.isSet("quality")) {
        const std::optional<double> quality = toNumber(line.value("quality"));
        if (!quality || *quality != std::floor(*quality) || *quality < 1 || *quality > 100)
            return Error{QCoreApplication::translate("Cli", "--quality %1: give a whole number from 1 to 100")
                             .arg(line.value("quality"))};
        image.quality = int(*quality);
        if (!hasQuality(format))
            warn(QCoreApplication::translate("Cli", "--quality is ignored: %1 loses nothing").arg(nameOf(format)));
    }
    if (line.isSet("dpi")) {
        const std::optional<double> dpi = toNumber(line.value("dpi"));
        if (!dpi || *dpi < 1 || *dpi > 10'000)
            return Error{QCoreApplication::translate("Cli", "--dpi %1: give a number from 1 to 10000, e.g. 300")
                             .arg(line.value("dpi"))};
        image.dpi = *dpi;
        if (!hasResolution(format))
            warn(QCoreApplication::translate("Cli", "--dpi is ignored: %1 files hold no resolution")
                     .arg(nameOf(format)));
    }
    return {};
}

/// --profile.
Result<void> takeProfile(const CommandLine &line, ImageOptions &image)
{
    if (!line.isSet("profile"))
        return {};
    const Result<QByteArray> profile = readProfile(line.value("profile"));
    if (!profile)
        return Error{QStringLiteral("--profile %1").arg(profile.error())};
    image.profile = *profile;
    if (const auto usable = ColourConversion::between({{}, image.profile, {}}); !usable)
        return Error{QCoreApplication::translate("Cli", "--profile %1: %2; give an ICC profile of RGB colours")
                         .arg(line.value("profile"), usable.error())};
    return {};
}

/// Depth, alpha, quality, resolution and profile as asked; errors are usage errors. Sizes are checked later, when they
/// are known.
Result<ImageOptions> imageOptions(const CommandLine &line, ImageFormat format)
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
    if (const Result<void> taken = takeProfile(line, out); !taken)
        return Error{taken.error()};
    const QString problem = problemOf(format, out, 1, 1);
    if (!problem.isEmpty())
        return Error{QStringLiteral("%1: %2").arg(line.value("output"), problem)};
    if (const Result<void> taken = takeNumbers(line, format, out); !taken)
        return Error{taken.error()};
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
    return {{"backend", nameOf(renderer.backend())},
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

/// To the file, or to standard output.
int write(const CommandLine &line, ImageFormat format, const FloatPicture &pixels, const ImageOptions &image)
{
    if (!isToStdout(line)) {
        const Result<void> written = writeImage(line.value("output"), pixels, image);
        return written ? int(Done) : fail(written.error());
    }
    const Result<QByteArray> bytes = encodeImage(format, pixels, image, line.value("output"));
    return bytes ? printBytes(*bytes) : fail(bytes.error());
}

int render(const CommandLine &line, ImageFormat format, ImageOptions image, const RendererOptions &options)
{
    QElapsedTimer clock;
    clock.start();
    Times times;
    double resolution = 0;
    Result<Painting> painting = paintingOf(line.argument(0), &resolution);
    if (!painting)
        return fail(painting.error());
    times.loadMs = lap(clock);
    const Result<PictureOptions> picture = pictureOptions(line, *painting);
    if (!picture)
        return failUsage("render", picture.error());
    if (!line.isSet("dpi") && isResolution(resolution)) // The picture is as large on paper as the sheet.
        image.dpi = resolution * picture->width / picture->area.width();
    const QString problem = problemOf(format, image, picture->width, picture->height);
    if (!problem.isEmpty())
        return failUsage("render", QStringLiteral("%1: %2").arg(line.value("output"), problem));
    RenderRequest request;
    request.painting = std::make_shared<const Painting>(std::move(*painting));
    if (!line.isSet("drafts"))
        request.painting = withoutDrafts(request.painting);
    request.time = picture->time;
    request.view = View::ofArea(picture->area, picture->width, picture->height);
    request.transparent = image.alpha;
    RendererOptions chosen = options;
    if (options.backend == Backend::Auto)
        chosen.backend = quickestBackend(request, 1, options);
    Result<std::unique_ptr<Renderer>> renderer = makeRenderer(chosen);
    if (!renderer)
        return fail(renderer.error());

    FloatPicture pixels;
    const Result<RenderStats> stats = renderPicture(**renderer, request, pixels);
    if (!stats)
        return fail(QStringLiteral("%1: %2").arg(line.argument(0), stats.error()));
    times.renderMs = lap(clock);
    if (const QString notice = (*renderer)->notice(); !notice.isEmpty())
        warn(notice);
    image.cancel = &interrupted();
    if (const int code = write(line, format, pixels, image); code != Done)
        return code;
    times.writeMs = lap(clock);
    return line.isSet("stats") ? printJson(statsJson(**renderer, request, *stats, times)) : Done;
}

/// What a layered file cannot be asked for; errors are usage errors.
Result<int> bitsOfLayers(const CommandLine &line)
{
    if (line.isSet("transparent"))
        return Error{QCoreApplication::translate("Cli", "--transparent: the background is a layer of its own, which "
                                                        "other programs can hide")};
    const QString depth = line.isSet("depth") ? line.value("depth") : QStringLiteral("8");
    if (depth != QLatin1String("8") && depth != QLatin1String("16"))
        return Error{QCoreApplication::translate("Cli", "--depth %1: layers have 8 or 16 bits").arg(depth)};
    for (const char *option : {"format", "quality", "dpi", "profile", "stats"})
        if (line.isSet(QLatin1String(option)))
            warn(QCoreApplication::translate("Cli", "--%1 is ignored: it is not for layered files")
                     .arg(QLatin1String(option)));
    return depth.toInt();
}

/// Draws the layers, each of which costs but its own strokes.
int renderLayers(const CommandLine &line, RendererOptions options)
{
    const QString out = line.value("output");
    const Result<int> bits = bitsOfLayers(line);
    if (!bits)
        return failUsage("render", bits.error());
    Result<Painting> painting = paintingOf(line.argument(0));
    if (!painting)
        return fail(painting.error());
    const Result<PictureOptions> picture = pictureOptions(line, *painting);
    if (!picture)
        return failUsage("render", picture.error());
    ImageOptions image;
    image.alpha = true;
    const QString problem = problemOf(ImageFormat::Png, image, picture->width, picture->height);
    if (!problem.isEmpty())
        return failUsage("render", QStringLiteral("%1: %2").arg(out, problem));
    LayeredRequest request;
    request.painting = std::make_shared<const Painting>(std::move(*painting));
    request.time = picture->time;
    request.view = View::ofArea(picture->area, picture->width, picture->height);
    request.bits = *bits;
    request.cancel = &interrupted();
    ProgressLine progress{QCoreApplication::translate("Cli", "drawing layers")};
    request.progress = [&](std::size_t done, std::size_t layers) { progress.show(qint64(done), qint64(layers)); };
    if (options.backend == Backend::Auto)
        options.backend = quickestBackend({request.painting, request.time, request.view}, 1, options);
    Result<std::unique_ptr<Renderer>> renderer = makeRenderer(options), groups = makeRenderer(options);
    if (!renderer || !groups)
        return fail(renderer ? groups.error() : renderer.error());
    try {
        const Result<LayeredStats> written = writeLayered(out, request, **renderer, **groups);
        if (!written)
            return fail(written.error());
        if (written->baked > 0)
            warn(QCoreApplication::translate("Cli",
                                             "%n group(s) would look otherwise in other programs; their layers "
                                             "show what they make of the picture instead",
                                             nullptr, int(written->baked)));
        return Done;
    } catch (const std::bad_alloc &) {
        return fail(QCoreApplication::translate("Cli", "there is not enough memory for layers of %1 × %2 pixels. "
                                                       "Choose a smaller size.")
                        .arg(request.view.width)
                        .arg(request.view.height));
    }
}

} // namespace

int renderCommand(const QStringList &arguments)
{
    CommandLine line("render",
                     QCoreApplication::translate("Cli", "Draws a painting or a recording into an image file."), {"IN"});
    addRenderOptions(line);
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    if (line.isSet("tiles"))
        return renderTilesCommand(line);
    if (line.value("output").isEmpty())
        return failUsage("render", QCoreApplication::translate("Cli", "-o OUT is missing: name the picture to write"));
    if (isSameFile(line.argument(0), line.value("output")))
        return failUsage("render", inputWouldBeLost(line.value("output")));
    const QString problem = problemOfPictureFile(line.value("output"));
    if (layeredFormatFor(line.value("output")) != LayeredFormat::None) {
        const Result<RendererOptions> renderer = rendererOptions(line);
        if (!renderer)
            return failUsage("render", renderer.error());
        return problem.isEmpty() ? renderLayers(line, *renderer) : fail(problem);
    }
    const Result<ImageFormat> format = formatOf(line);
    if (!format)
        return failUsage("render", format.error());
    const Result<ImageOptions> image = imageOptions(line, *format);
    if (!image)
        return failUsage("render", image.error());
    const Result<RendererOptions> renderer = rendererOptions(line);
    if (!renderer)
        return failUsage("render", renderer.error());
    return problem.isEmpty() ? render(line, *format, *image, *renderer) : fail(problem);
}

} // namespace suffuse::cli
