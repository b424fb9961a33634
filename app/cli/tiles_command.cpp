#include "app/cli/tiles_command.h"

#include "app/cli/progress.h"
#include "app/cli/tiles_recipe.h"
#include "render/backends.h"
#include "render/tiles/big_tiff.h"
#include "render/tiles/render_tiles.h"

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>

#include <cerrno>

#include <unistd.h>

namespace suffuse::cli {

namespace {

QJsonObject statsJson(const Renderer &renderer, std::size_t renderers, const TiledPicture &picture,
                      const TilesStats &stats, double milliseconds)
{
    return {{"backend", nameOf(renderer.backend())},
            {"device", renderer.deviceName()},
            {"devices", qint64(renderers)},
            {"width", picture.plan.view().width},
            {"height", picture.plan.view().height},
            {"levels", qint64(picture.plan.levels().size())},
            {"tiles", picture.plan.tiles()},
            {"sheets", stats.sheets},
            {"kept", stats.kept},
            {"pixels", stats.pixels},
            {"bytes", stats.bytes},
            {"ms", QJsonObject{{"draw", stats.drawMs}, {"total", milliseconds}}}};
}

Result<TilesStats> draw(const std::vector<std::unique_ptr<Renderer>> &renderers, const RenderRequest &request,
                        const TiledPicture &picture, TileStore &store, int threads)
{
    ProgressLine progress(QCoreApplication::translate("Cli", "drawing"), true);
    TilesRequest tiles;
    tiles.picture = request;
    tiles.threads = threads;
    tiles.count = picture.plan.sheets();
    tiles.sheet = [](qint64 i) { return i; };
    tiles.cancel = &interrupted();
    tiles.progress = [&](qint64 done, qint64 all) { progress.show(done, all); };
    Result<TilesStats> stats = renderTiles(renderers, tiles, picture, store);
    if (!stats && interrupted())
        return Error{
            QCoreApplication::translate("Cli", "stopped; what is finished is kept, and the same command goes on")};
    return stats;
}

/// Draws into a folder of tiles.
Result<TilesStats> drawDeepZoom(const std::vector<std::unique_ptr<Renderer>> &renderers, const RenderRequest &request,
                                const TiledPicture &picture, int threads)
{
    const QString files = DeepZoomStore::filesOf(picture.path), journalPath = files + QStringLiteral("/tiles.journal");
    const bool isFolderTaken = QFileInfo::exists(files) && !QFileInfo::exists(journalPath) && !QDir(files).isEmpty();
    if (isFolderTaken || DeepZoomStore::isPageTaken(picture.path))
        return Error{QCoreApplication::translate(
                         "Cli", "%1: there is something else already. Remove it, or choose another name.")
                         .arg(isFolderTaken ? files : DeepZoomStore::pageOf(picture.path))};
    if (!QDir().mkpath(files))
        return Error{QCoreApplication::translate("Cli",
                                                 "%1: the folder cannot be made. Choose another one, or change its "
                                                 "permissions.")
                         .arg(files)};
    const auto records = TileJournal::read(journalPath, picture.identity);
    if (!records)
        return Error{records.error()};
    SheetRecords bySheet;
    for (const SheetRecord &record : *records)
        bySheet.emplace(record.sheet, record);
    TileJournal journal;
    if (const Result<void> opened = journal.open(journalPath, picture.identity); !opened)
        return Error{opened.error()};
    DeepZoomStore store(picture, std::move(bySheet), journal);
    Result<TilesStats> stats = draw(renderers, request, picture, store, threads);
    if (!stats)
        return stats;
    if (const Result<void> finished = store.finish(); !finished)
        return Error{finished.error()};
    return stats;
}

/// Draws into a file beside the picture's place, in which the tiles come one after the other, and frames them in the
/// end.
Result<TilesStats> drawBigTiff(const std::vector<std::unique_ptr<Renderer>> &renderers, const RenderRequest &request,
                               const TiledPicture &picture, int threads)
{
    const QString part = picture.path + QStringLiteral(".part"),
                  journalPath = picture.path + QStringLiteral(".journal");
    if (QFileInfo(picture.path).isDir())
        return Error{QCoreApplication::translate("Cli", "%1: is a folder. Give a file name.").arg(picture.path)};
    const auto records = TileJournal::read(journalPath, picture.identity);
    if (!records)
        return Error{records.error()};
    PackRecords bySheet;
    for (const SheetRecord &record : *records)
        bySheet.emplace(record.sheet, std::pair(record, part));
    TileJournal journal;
    PackFile file;
    PackStore store(std::move(bySheet), journal, file);
    if (const Result<void> opened = file.open(part, bigTiffHead); !opened)
        return Error{opened.error()};
    if (const Result<void> opened = journal.open(journalPath, picture.identity); !opened)
        return Error{opened.error()};
    Result<TilesStats> stats = draw(renderers, request, picture, store, threads);
    if (!stats)
        return stats;
    const auto all = TileJournal::read(journalPath, picture.identity);
    if (!all)
        return Error{all.error()};
    if (const Result<void> finished = frameBigTiff(picture, part, file.end(), *all); !finished)
        return Error{finished.error()};
    journal.close();
    QFile::remove(journalPath);
    return stats;
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
    Result<RendererOptions> options = rendererOptions(line);
    if (!options)
        return failUsage("render", options.error());
    Result<Painting> painting = paintingOf(line.argument(0));
    if (!painting)
        return fail(painting.error());
    Result<TilesRecipe> recipe = tilesRecipe(line, *painting);
    if (!recipe)
        return failUsage("render", recipe.error());
    const RenderRequest request = requestOf(std::make_shared<const Painting>(std::move(*painting)), *recipe);
    if (options->backend == Backend::Auto && options->devices == 1)
        options->backend = quickestBackend(request, 1, *options);
    const auto renderers = makeRenderers(*options);
    if (!renderers)
        return fail(renderers.error());
    if (recipe->tiles.sheet == 0)
        recipe->tiles.sheet = usualSheet(renderers->front()->backend());
    const TiledPicture picture{
        {recipe->view(), recipe->tiles},
        recipe->encoding,
        recipe->path(),
        identityOf(hashOf(*request.painting), recipe->json(), drawnBy(*renderers->front(), &recipe->encoding))};
    const Result<TilesStats> stats = recipe->isTiff() ? drawBigTiff(*renderers, request, picture, options->threads)
                                                      : drawDeepZoom(*renderers, request, picture, options->threads);
    if (!stats)
        return fail(stats.error());
    return line.isSet("stats") ? printJson(statsJson(*renderers->front(), renderers->size(), picture, *stats,
                                                     double(clock.nsecsElapsed()) * 1e-6))
                               : Done;
}

} // namespace suffuse::cli
