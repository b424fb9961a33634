// Pictures of any size, in tiles on the disk.
#include "app/python/views.h"

#include "app/cli/tiles/tiles_work.h"

#include <QElapsedTimer>

namespace suffuse::python {

namespace {

/// How tiles are made, as Python says it; None: as usual.
struct TilesWish {
    py::object tile, overlap, sheet, format, quality, depth;
    bool transparent, drafts;
};

cli::TilesRecipe recipeOf(const QString &out, const Painting &painting, const ViewWish &view, const TilesWish &wish)
{
    if (const QString problem = cli::problemOfTilesName(out); !problem.isEmpty())
        raise(Raised::Value, QString(problem).remove(QLatin1String("--tiles ")));
    Asked asked("render", {"tiles", "tile", "overlap", "sheet", "format", "quality", "depth", "size", "scale", "area", "time"});
    asked.set("tiles", out);
    asked.set("tile", wish.tile);
    asked.set("overlap", wish.overlap);
    asked.set("sheet", wish.sheet);
    asked.set("format", wish.format);
    asked.set("quality", wish.quality);
    asked.set("depth", wish.depth);
    asked.set(view);
    if (wish.transparent)
        asked.set("transparent");
    if (wish.drafts)
        asked.set("drafts");
    return valueOf(cli::tilesRecipe(asked.line(), painting), Raised::Value);
}

py::dict statsOf(const cli::TilesWork &work, const TilesStats &stats, double milliseconds)
{
    const Renderer &renderer = *work.renderers.front();
    const TilePlan &plan = work.picture.plan;
    py::dict out;
    out["path"] = work.picture.path;
    out["backend"] = nameOf(renderer.backend());
    out["device"] = renderer.deviceName();
    out["devices"] = work.renderers.size();
    out["width"] = plan.view().width;
    out["height"] = plan.view().height;
    out["levels"] = plan.levels().size();
    out["tiles"] = plan.tiles();
    out["sheets"] = stats.sheets;
    out["kept"] = stats.kept;
    out["pixels"] = stats.pixels;
    out["bytes"] = stats.bytes;
    out["ms"] = milliseconds;
    return out;
}

py::dict renderTilesOf(const PaintingValue &painting, const cli::TilesRecipe &recipe, const RendererOptions &options,
                       const py::object &progress)
{
    QElapsedTimer clock;
    clock.start();
    WorkShare share(progress);
    Result<cli::TilesWork> work = Error{};
    Result<TilesStats> stats = Error{};
    withoutLock(
        [&](std::atomic<bool> &cancel) {
            work = cli::tilesWorkOf(painting.painting, recipe, options);
            if (work)
                stats = cli::writeTiles(*work, options.threads, cancel,
                                        [&](qint64 done, qint64 all) { share.set(double(done) / double(all)); });
        },
        share.teller());
    const cli::TilesWork drawn = valueOf(std::move(work), Raised::Plain);
    return statsOf(drawn, valueOf(std::move(stats), Raised::File), double(clock.nsecsElapsed()) * 1e-6);
}

} // namespace

void addTiles(py::module_ &module)
{
    using namespace py::literals;
    module.def(
        "render_tiles",
        [](const PaintingValue &painting, const py::object &path, const py::object &size, std::optional<double> scale,
           const std::optional<std::array<double, 4>> &area, std::optional<double> time, bool transparent, bool drafts,
           const py::object &tile, const py::object &overlap, const py::object &sheet, const py::object &format,
           const py::object &quality, const py::object &depth, const QString &backend, int threads,
           const py::object &devices, const py::object &progress) {
            const cli::TilesRecipe recipe =
                recipeOf(pathOf(path), *painting.painting, {size, scale, area, time},
                         {tile, overlap, sheet, format, quality, depth, transparent, drafts});
            return renderTilesOf(painting, recipe, rendererOptionsOf(backend, threads, devices), progress);
        },
        "painting"_a, "path"_a, py::kw_only(), "size"_a = py::none(), "scale"_a = py::none(), "area"_a = py::none(),
        "time"_a = py::none(), "transparent"_a = false, "drafts"_a = false, "tile"_a = py::none(),
        "overlap"_a = py::none(), "sheet"_a = py::none(), "format"_a = py::none(), "quality"_a = py::none(),
        "depth"_a = py::none(), "backend"_a = "auto", "threads"_a = 0, "devices"_a = py::none(),
        "progress"_a = py::none());
}

} // namespace suffuse::python
