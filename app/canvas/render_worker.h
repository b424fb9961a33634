// Renders on a thread of its own; the newest request wins.
#pragma once

#include "render/renderer.h"

#include <QObject>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace suffuse {

/// What a finished frame was.
struct FrameInfo {
    RenderStats stats;
    View view;
    Microseconds time = 0;
    quint64 serial = 0;  ///< of the request, from 1
    QString error;       ///< empty, or why there is no new picture
    QString backendText; ///< what drew it: "CPU · 2 threads · AVX2"
    QString notice;      ///< empty, or why the CPU drew it, or why it did not stay on the device
};

/// The last whole picture, on the device or in memory. `dirty` lists what changed since a presenter last cleared it.
struct ShownFrame {
    View view;
    std::shared_ptr<DeviceFrame> device; ///< null: `picture` has the pixels; else it is empty
    Picture8 picture;
    std::vector<PixelRect> dirty;

    int width() const { return device ? device->width() : picture.width; }
    int height() const { return device ? device->height() : picture.height; }
};

/// As makeRenderer (render/renderer.h); tests put others in its place.
using MakeRenderer = std::function<Result<std::unique_ptr<Renderer>>(const RendererOptions &)>;

/// Owns the renderer and the thread that it is made, runs and ends on. The window asks and is told; it never waits for
/// pixels.
class RenderWorker : public QObject {
    Q_OBJECT

public:
    /// `make` is called on the worker's thread. Where it fails the CPU draws, and `FrameInfo::notice` says why.
    explicit RenderWorker(const RendererOptions &options, MakeRenderer make = makeRenderer, QObject *parent = nullptr);
    ~RenderWorker() override;

    /// True: pictures may stay on the device that computes them. At first they come to memory. Takes effect with the
    /// next request, which then draws everything.
    void setDeviceFramesWanted(bool wanted) { m_deviceFramesWanted = wanted; }

    /// Asks for a picture; a request that has not begun is forgotten, one that runs is cancelled where the view has
    /// changed or it takes long. Returns the request's serial.
    quint64 request(RenderRequest request);
    /// Serial of the last finished request.
    quint64 shownSerial() const { return m_shownSerial.load(); }

    /// Calls `use` with the shown frame locked: keep it short.
    void withFrame(const std::function<void(ShownFrame &)> &use);

signals:
    /// Emitted on the worker's thread: connect to an object of the GUI thread.
    void frameReady(const suffuse::FrameInfo &frame);

private:
    using Clock = std::chrono::steady_clock;

    struct Job {
        RenderRequest request;
        quint64 serial = 0;
    };

    /// Where the renderer draws.
    struct CanvasTarget : Picture8 {
        bool onDevice = false;
        bool takesDeviceFrames() const override { return onDevice; }
    };

    void run();
    void openRenderer();
    bool next(Job &job);
    Result<RenderStats> render(const Job &job);
    void finish(const Job &job, const Result<RenderStats> &result);
    Result<void> publish(const View &view, const std::shared_ptr<DeviceFrame> &device);
    void publishFromMemory(bool whole);
    void cancelIfUseless(const View &wanted);

    // Worker thread only.
    RendererOptions m_options;
    MakeRenderer m_make;
    std::unique_ptr<Renderer> m_renderer;
    QString m_rendererError;
    QString m_notice; ///< where the renderer itself has none

    std::mutex m_jobMutex;
    std::condition_variable m_wake;
    std::optional<Job> m_pending;
    std::optional<View> m_runningView;
    Clock::time_point m_started;
    Clock::time_point m_lastShown;
    bool m_cancelledLast = false;
    bool m_stop = false;
    quint64 m_serial = 0;
    std::atomic<bool> m_cancel = false;
    std::atomic<quint64> m_shownSerial = 0;
    std::atomic<bool> m_deviceFramesWanted = false;

    CanvasTarget m_back;                ///< worker thread only, as the next three
    bool m_deviceFramesFailed = false;  ///< a finished one could not be shown
    std::vector<PixelRect> m_backDirty; ///< stored and not shown yet
    std::optional<View> m_publishedView;

    std::mutex m_frameMutex;
    ShownFrame m_shown;

    std::thread m_thread;
};

} // namespace suffuse
