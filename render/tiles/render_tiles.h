// Draws a picture of any size, sheet by sheet, and has its tiles put down.
#pragma once

#include "render/renderer.h"
#include "render/tiles/tile_store.h"

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace suffuse {

struct TilesStats {
    qint64 sheets = 0, kept = 0; ///< of those that were asked for: drawn now, and there already
    double pixels = 0;           ///< drawn now
    qint64 bytes = 0;            ///< of tiles that were written
    double drawMs = 0;           ///< in which renderers drew, added up
};

struct TilesRequest {
    RenderRequest picture;               ///< its view is that of the plan, its part is set for each sheet
    int threads = 0;                     ///< that encode; 0: one a core
    qint64 count = 0;                    ///< sheets that are asked for,
    std::function<qint64(qint64)> sheet; ///< and the number of the i-th of them
    const std::atomic<bool> *cancel = nullptr;
    std::function<void(qint64 done, qint64 all)> progress; ///< any thread; sheets
};

/// Draws the sheets that the store does not have. Each renderer draws one after the other, while others are encoded;
/// only a few are in memory at a time. A renderer that another backend replaces ends the work, since its bits differ.
/// The first error ends it, and so does `cancel`, with an empty error; what was put down stays.
Result<TilesStats> renderTiles(const std::vector<std::unique_ptr<Renderer>> &renderers, const TilesRequest &request,
                               const TiledPicture &picture, TileStore &store);

} // namespace suffuse
