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

namespace suffuse {

/// What a finished frame was.
struct FrameInfo {
    RenderStats stats;
    View view;
    Microseconds time = 0;
    quint64 serial = 0; ///< of the request, from 1
    QString error;      ///< empty, or why there is no new picture
};

/// The last whole picture. `dirty` lists what changed since a presenter last cleared it.
struct ShownFrame {
    View view;
    Picture8 picture;
    std::vector<PixelRect> dirty;
};

/// Owns the renderer and the thread that it runs on. The window asks and is told; it never waits for pixels.
class RenderWorker : public QObject {
    Q_OBJECT

public:
    explicit RenderWorker(const RendererOptions &options, QObject *parent = nullptr);
    ~RenderWorker() override;

    /// "CPU · 2 threads · AVX2"
    const QString &backendText() const { return m_backendText; }

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

    void run();
    bool next(Job &job);
    void finish(const Job &job, const Result<RenderStats> &result);
    void publish(const View &view);
    void cancelIfUseless(const View &wanted);

    std::unique_ptr<Renderer> m_renderer;
    QString m_rendererError;
    QString m_backendText;

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

    Picture8 m_back;                       ///< worker thread only
    std::vector<PixelRect> m_backDirty;    ///< stored into m_back and not shown yet
    std::optional<View> m_publishedView;

    std::mutex m_frameMutex;
    ShownFrame m_shown;

    std::thread m_thread;
};

} // namespace suffuse
