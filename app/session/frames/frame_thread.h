// Frames from a thread of their own; the newest request wins.
#pragma once

#include "app/session/frames/frame_schedule.h"
#include "app/session/frames/shown_frame.h"
#include "render/backends.h"

#include <QObject>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace suffuse {

/// Does what the schedule says, by the frame sources, on a thread on which they are made, work and end. The window asks
/// and is told; it never waits for pixels.
class FrameThread : public QObject {
    Q_OBJECT

public:
    /// `make` is called on the frame thread. Where it fails the CPU draws, and `FrameInfo::notice` says why.
    explicit FrameThread(const RendererOptions &options, MakeRenderer make = makeRendererAtOnce,
                         QObject *parent = nullptr);
    ~FrameThread() override;

    /// Asks for a picture; a request that has not begun is forgotten, one that runs is cancelled where the view has
    /// changed or it takes long. Returns the request's serial.
    quint64 request(RenderRequest request, std::optional<Floating> floating = {});
    /// Serial of the last request that an exact frame has answered.
    quint64 shownSerial() const;
    /// Calls `use` with the shown frame locked: keep it short.
    void withFrame(const std::function<void(ShownFrame &)> &use) { m_board.with(use); }

    /// True: pictures may stay on the device that computes them. At first they come to memory. Takes effect with the
    /// next request, which then draws everything.
    void setDeviceFramesWanted(bool wanted);
    /// True: where exact frames of gestures (RenderRequest::interactive) would take too long, coarse ones stand in for
    /// them until the gesture pauses. In memory alone, by the CPU.
    void setCoarseWanted(bool wanted);
    /// Strokes that a drag is about to map as a whole: their pictures are made ready. Null: no more.
    void lift(LiftPtr lift);
    /// Whether frames can be composed of such pictures: in memory, of the CPU. From the first frame on.
    bool canFloat() const;
    /// Whether drawing so many pixels takes too long for a frame of a gesture, by the last exact frames.
    bool isSlowFor(double pixels) const;

signals:
    /// Emitted on the frame thread: connect to an object of the GUI thread.
    void frameReady(const suffuse::FrameInfo &frame);
    /// The hand that asked for the frame with this serial, the last one of a gesture, has not moved for a while.
    /// Emitted on the frame thread.
    void handRests(quint64 serial);

private:
    struct Sources;

    void tell(const std::function<void(FrameSchedule &)> &event);
    std::optional<FrameTask> nextTask();
    void run();
    void deliver(const Sources &sources, const FrameJob &job, FrameInfo &frame);

    const RendererOptions m_options;
    const MakeRenderer m_make;
    FrameBoard m_board;

    mutable std::mutex m_mutex; ///< of the next three
    std::condition_variable m_wake;
    FrameSchedule m_schedule;
    bool m_stop = false;
    std::atomic<bool> m_cancel = false; ///< as the schedule says, for a source that works

    std::thread m_thread;
};

} // namespace suffuse
