#include "app/cli/tiles/tiles_command.h"

#include "app/cli/progress.h"
#include "app/cli/tiles/tiles_work.h"

#include <QCoreApplication>
#include <QElapsedTimer>

namespace suffuse::cli {

namespace {

QJsonObject statsJson(const TilesWork &work, const TilesStats &stats, double milliseconds)
{
    const Renderer &renderer = *work.renderers.front();
    const TilePlan &plan = work.picture.plan;
    return {{"backend", nameOf(renderer.backend())},
            {"device", renderer.deviceName()},
            {"devices", qint64(work.renderers.size())},
            {"width", plan.view().width},
            {"height", plan.view().height},
            {"levels", qint64(plan.levels().size())},
            {"tiles", plan.tiles()},
            {"sheets", stats.sheets},
            {"kept", stats.kept},
            {"pixels", stats.pixels},
            {"bytes", stats.bytes},
            {"ms", QJsonObject{{"draw", stats.drawMs}, {"total", milliseconds}}}};
}

} // namespace

void addTilesOptions(CommandLine &line)
{
    line.add({"tiles"},
             QCoreApplication::translate("Cli",
                                         "A picture of any size in tiles: OUT.dzi (Deep Zoom), OUT.tif (BigTIFF) or a "
                                         "folder; --format jpg or png."),
             "OUT");
    line.add({"tile"}, QCoreApplication::translate("Cli", "With --tiles: pixels a side (default 254; TIFF 512)."), "N");
    line.add({"overlap"},
             QCoreApplication::translate(
                 "Cli", "With --tiles: pixels that tiles show of their neighbours (default 1; TIFF 0)."),
             "N");
    line.add({"sheet"},
             QCoreApplication::translate(
                 "Cli", "With --tiles: pixels a side of what is drawn at once (default 2048; CUDA 8192)."),
             "N");
}

int renderTilesCommand(const CommandLine &line)
{
    QElapsedTimer clock;
    clock.start();
    for (const char *option : {"output", "dpi", "profile"})
        if (line.isSet(QLatin1String(option)))
            return failUsage("render",
                             QCoreApplication::translate("Cli", "--%1 is not for --tiles").arg(QLatin1String(option)));
    const Result<RendererOptions> options = rendererOptions(line);
    if (!options)
        return failUsage("render", options.error());
    Result<Painting> painting = paintingOf(line.argument(0));
    if (!painting)
        return fail(painting.error());
    const Result<TilesRecipe> recipe = tilesRecipe(line, *painting);
    if (!recipe)
        return failUsage("render", recipe.error());
    const Result<TilesWork> work =
        tilesWorkOf(std::make_shared<const Painting>(std::move(*painting)), *recipe, *options);
    if (!work)
        return fail(work.error());
    Result<TilesStats> stats = Error{};
    {
        ProgressLine progress(QCoreApplication::translate("Cli", "drawing"), true);
        stats = writeTiles(*work, options->threads, interrupted(),
                           [&](qint64 done, qint64 all) { progress.show(done, all); });
    }
    if (!stats)
        return fail(interrupted() ? QCoreApplication::translate(
                                        "Cli", "stopped; what is finished is kept, and the same command goes on")
                                  : stats.error());
    return line.isSet("stats") ? printJson(statsJson(*work, *stats, double(clock.nsecsElapsed()) * 1e-6)) : Done;
}

} // namespace suffuse::cli
