// Frames that are drawn as they are.
#pragma once

#include "app/session/frames/frame_schedule.h"
#include "app/session/frames/shown_frame.h"
#include "render/renderer.h"

#include <atomic>
#include <memory>
#include <vector>

namespace suffuse {

/// Draws exact frames, on the device that there is or by the CPU, and shows them. Used by one thread, on which the
/// renderer is made and ends.
class ExactFrames {
public:
    /// Where `make` fails for the backend of `options` the CPU draws, and `notice` says why.
    ExactFrames(const RendererOptions &options, const MakeRenderer &make, FrameBoard &board);

    /// Draws the task's job and puts it on the board. `frame` gets figures and, where there is no picture, the error.
    FrameResult show(const FrameTask &task, const std::atomic<bool> *cancel, FrameInfo &frame);
    /// Draws the picture of a request in memory, into `picture`, and does not show it. Of the last frame that this
    /// renderer has drawn it should differ little: what differs is drawn, and drawn back with the next frame.
    FrameOutcome draw(const RenderRequest &request, const std::atomic<bool> *cancel, Picture8 &picture);

    /// The CPU draws, and its pictures are in memory.
    bool isInMemory() const { return m_renderer && m_renderer->backend() == Backend::Cpu; }
    /// "CPU · 2 threads · AVX2"; empty where nothing can draw.
    QString backendText() const;
    /// Empty, or why the CPU draws, or why pictures do not stay on the device.
    QString notice() const;

private:
    /// Where the renderer draws.
    struct Back : Picture8 {
        bool onDevice = false;
        bool takesDeviceFrames() const override { return onDevice; }
    };

    /// Begins a frame: what was stored for another view is stored anew.
    void begin(const View &view);
    Result<void> publish(const View &view, const std::shared_ptr<DeviceFrame> &device);
    void copyToShown(ShownFrame &shown, const std::shared_ptr<DeviceFrame> &device, bool whole) const;

    FrameBoard &m_board;
    std::unique_ptr<Renderer> m_renderer;
    QString m_error;  ///< why there is no renderer
    QString m_notice; ///< where the renderer itself has none
    Back m_back;
    View m_drawn;                         ///< the view of the last request, of which m_back has some or all
    std::vector<PixelRect> m_unpublished; ///< stored for this view and not shown yet
    double m_evaluated = 0;               ///< pixels since a frame was shown
};

} // namespace suffuse
