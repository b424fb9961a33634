// Quick stand-ins for frames of a gesture that would take too long.
#pragma once

#include "app/session/frames/frame_schedule.h"
#include "app/session/frames/shown_frame.h"
#include "render/renderer.h"

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

namespace suffuse {

/// The same picture, drawn by the CPU at a coarser view and enlarged. Keeps a renderer of its own, from the first frame
/// on, which like any other evaluates only what differs from its last frame. Used by one thread.
class CoarseFrames {
public:
    /// Pixels of the view to a side of one that is drawn.
    static constexpr int usualFactor = 4;

    CoarseFrames(const RendererOptions &options, MakeRenderer make, int factor = usualFactor);

    /// Draws the task's job, and enlarges what differs from the frame before it into the picture on the board: all,
    /// where that was of another view. `frame` gets figures.
    FrameResult show(const FrameTask &task, FrameBoard &board, FrameInfo &frame);
    /// Draws what the task has on the screen, so that the next frame has to draw only what differs.
    FrameResult prepare(const FrameTask &task, const std::atomic<bool> *cancel);
    /// Lets picture and renderer go.
    void forget();
    bool keepsAny() const { return m_renderer != nullptr; }

    View coarseView(const View &view) const;
    /// The last frame; none: there is none, or it was cancelled.
    const std::optional<RenderRequest> &at() const { return m_at; }
    /// Whether that is one of this painting, moment and view.
    bool isAt(const RenderRequest &request) const { return m_at && isSameFrame(*m_at, request); }
    /// Draws a frame; what differs from the last one is listed in pixels of the request's view, whole at first.
    Result<RenderStats> draw(const RenderRequest &request, const std::atomic<bool> *cancel = nullptr);
    /// The rectangles of `picture`, which has the size of the last frame's view, enlarged from the frame.
    void enlargeInto(Picture8 &picture, const std::vector<PixelRect> &rects) const;

private:
    RendererOptions m_options;
    MakeRenderer m_make;
    int m_factor;
    std::unique_ptr<Renderer> m_renderer;
    Picture8 m_picture;
    std::optional<RenderRequest> m_at;
};

} // namespace suffuse
