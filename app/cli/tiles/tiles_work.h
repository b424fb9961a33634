// A picture in tiles on its way to the disk: for `render --tiles` and for Python.
#pragma once

#include "app/cli/tiles/tiles_recipe.h"
#include "render/tiles/render_tiles.h"

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace suffuse::cli {

/// What draws a picture, and which picture that is. At least one renderer is there.
struct TilesWork {
    std::vector<std::unique_ptr<Renderer>> renderers;
    RenderRequest request;
    TiledPicture picture;
};

/// Makes the renderers that the options ask for. Where the recipe names no sheet, it is the usual one of the backend.
Result<TilesWork> tilesWorkOf(const PaintingPtr &painting, TilesRecipe recipe, RendererOptions options);

/// Draws what is missing of the picture, and puts it into its place when all of it is there. `threads` encode; 0: one a
/// core. `progress` is called by any thread, one at a time. `cancel` ends it with an empty error; what is finished stays, and
/// the same work goes on with it.
Result<TilesStats> writeTiles(const TilesWork &work, int threads, const std::atomic<bool> &cancel,
                              const std::function<void(qint64 done, qint64 all)> &progress);

} // namespace suffuse::cli
