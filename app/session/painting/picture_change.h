// How much another picture strokes make after a change.
#pragma once

#include "model/painting/painting.h"
#include "render/renderer.h"

#include <memory>

namespace suffuse {

/// Draws strokes as they were, alone on white and dry, and compares with them what has become of them.
class PictureChange {
public:
    explicit PictureChange(std::vector<StrokePtr> before);

    /// The mean difference of a channel, in [0, 1], over the box of what the strokes were seen in; none if the renderer
    /// fails. The picture is at most 320 pixels long, and a unit at most a pixel.
    std::optional<double> meanTo(const std::vector<StrokePtr> &after);

private:
    bool draw(const std::vector<StrokePtr> &strokes, Picture8 &picture);

    std::unique_ptr<Renderer> m_renderer;
    std::vector<StrokePtr> m_strokes;
    View m_view;
    Picture8 m_before;
    bool m_drawn = false;
};

} // namespace suffuse
