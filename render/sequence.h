// Pictures of a painting at one moment after another: films.
#pragma once

#include "render/renderer.h"

#include <functional>

namespace suffuse {

struct SequenceStats {
    std::int64_t tiles = 0;          ///< of all pictures
    std::int64_t tilesEvaluated = 0; ///< of them evaluated: the others did not change since the picture before
    QString notice;                  ///< of the first renderer that has one
};

/// Draws `request` (its time is not used) at each of the moments. Each renderer takes a run of them, so that it
/// evaluates only what changed. `use(i, picture)` gets the pictures, up to `threads` at once from threads of their own,
/// while the next ones are drawn; its first error ends the work, as `cancel` does (an empty error).
Result<SequenceStats> renderSequence(const std::vector<std::unique_ptr<Renderer>> &renderers,
                                     const RenderRequest &request, const std::vector<Microseconds> &moments,
                                     int threads,
                                     const std::function<Result<void>(std::size_t, const FloatPicture &)> &use,
                                     const std::atomic<bool> *cancel = nullptr);

} // namespace suffuse
