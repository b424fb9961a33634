// Draws a painting at many moments, for films.
#pragma once

#include "render/renderer.h"

#include <functional>

namespace suffuse {

struct SequenceStats {
    std::int64_t tiles = 0;          ///< tiles of all pictures
    std::int64_t tilesEvaluated = 0; ///< tiles that were evaluated; the others had not changed since the picture before
    QString notice;                  ///< the first notice of a renderer
};

/// Draws `request` at each of the moments (its own time is not used). Each renderer takes runs of moments, so that it
/// evaluates only what changed. `use(i, picture)` gets the pictures while the next ones are drawn, up to `threads`
/// at once on threads of their own. Its first error ends the work. So does `cancel`, with an empty error.
Result<SequenceStats> renderSequence(const std::vector<std::unique_ptr<Renderer>> &renderers,
                                     const RenderRequest &request, const std::vector<Microseconds> &moments,
                                     int threads,
                                     const std::function<Result<void>(std::size_t, const FloatPicture &)> &use,
                                     const std::atomic<bool> *cancel = nullptr);

} // namespace suffuse
