#pragma once

#include "model/painting/painting.h"

#include <QImage>

#include <atomic>
#include <memory>

namespace suffuse {

class Renderer;

/// Draws what is in the rows of the Strokes dock: a whole painting, dry and on no ground, in a few pixels. One thread
/// uses it at a time.
class ThumbnailRenderer {
public:
    static constexpr QSize size{32, 20}; ///< logical pixels

    ThumbnailRenderer();
    ~ThumbnailRenderer();

    /// The picture of what lies in a box, canvas units, with `ratio` pixels to a logical one. Null where nothing can be
    /// drawn, and soon after `cancel` becomes true.
    QImage draw(const PaintingPtr &painting, const Rect &box, double ratio, const std::atomic<bool> *cancel = nullptr);

private:
    std::unique_ptr<Renderer> m_renderer;
};

} // namespace suffuse
