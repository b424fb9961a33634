#include "app/cli/tiles/tiles_work.h"

#include "render/backends.h"
#include "render/tiles/big_tiff.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace suffuse::cli {

namespace {

/// Draws into a folder of tiles.
Result<TilesStats> drawDeepZoom(const TilesWork &work, const TilesRequest &request)
{
    const TiledPicture &picture = work.picture;
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
    Result<TilesStats> stats = renderTiles(work.renderers, request, picture, store);
    if (!stats)
        return stats;
    if (const Result<void> finished = store.finish(); !finished)
        return Error{finished.error()};
    return stats;
}

/// Draws into a file beside the picture's place, in which the tiles come one after the other, and frames them in the
/// end.
Result<TilesStats> drawBigTiff(const TilesWork &work, const TilesRequest &request)
{
    const TiledPicture &picture = work.picture;
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
    Result<TilesStats> stats = renderTiles(work.renderers, request, picture, store);
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

Result<TilesWork> tilesWorkOf(const PaintingPtr &painting, TilesRecipe recipe, RendererOptions options)
{
    const RenderRequest request = requestOf(painting, recipe);
    if (options.backend == Backend::Auto && options.devices == 1)
        options.backend = quickestBackend(request, 1, options);
    auto renderers = makeRenderers(options);
    if (!renderers)
        return Error{renderers.error()};
    if (recipe.tiles.sheet == 0)
        recipe.tiles.sheet = usualSheet(renderers->front()->backend());
    TiledPicture picture{
        {recipe.view(), recipe.tiles},
        recipe.encoding,
        recipe.path(),
        identityOf(hashOf(*request.painting), recipe.json(), drawnBy(*renderers->front(), &recipe.encoding))};
    return TilesWork{std::move(*renderers), request, std::move(picture)};
}

Result<TilesStats> writeTiles(const TilesWork &work, int threads, const std::atomic<bool> &cancel,
                              const std::function<void(qint64 done, qint64 all)> &progress)
{
    TilesRequest request;
    request.picture = work.request;
    request.threads = threads;
    request.count = work.picture.plan.sheets();
    request.sheet = [](qint64 i) { return i; };
    request.cancel = &cancel;
    request.progress = progress;
    return work.picture.encoding.format == TileFormat::Tiff ? drawBigTiff(work, request) : drawDeepZoom(work, request);
}

} // namespace suffuse::cli
