// Quick stand-ins for frames of a gesture that would take too long.
#pragma once

#include "render/renderer.h"

#include <memory>
#include <optional>
#include <vector>

namespace suffuse {

/// The same picture, drawn at a coarser view and enlarged. Keeps a renderer of its own, which like any other evaluates
/// only what differs from its last frame. Used by one thread.
class CoarseFrames {
public:
    /// `factor`: pixels of the view to a side of one that is drawn.
    CoarseFrames(std::unique_ptr<Renderer> renderer, int factor) : m_renderer(std::move(renderer)), m_factor(factor) {}

    int factor() const { return m_factor; }
    View coarseView(const View &view) const;

    /// Whether the last frame is one of this painting, moment and view.
    bool isAt(const RenderRequest &request) const;
    /// Draws a frame; what differs from the last one is listed in pixels of the request's view, whole at first.
    Result<RenderStats> draw(const RenderRequest &request, const std::atomic<bool> *cancel = nullptr);
    /// The rectangles of `picture`, which has the size of the last frame's view, enlarged from the frame.
    void enlargeInto(Picture8 &picture, const std::vector<PixelRect> &rects, int threads) const;

private:
    std::unique_ptr<Renderer> m_renderer;
    int m_factor;
    Picture8 m_picture;
    std::optional<RenderRequest> m_at;
};

/// Pixels of the view that the influence of what differs covers, before and after, roughly; and how many strokes that
/// are, counted before and after.
struct Difference {
    double pixels = 0;
    std::size_t strokes = 0;
};
Difference differenceOf(const Painting &before, const Painting &after, const View &view, Microseconds time);

/// Pixels of the view that the influence of a painting's strokes covers, roughly.
double reachedPixels(const Painting &painting, const View &view, Microseconds time);

} // namespace suffuse
