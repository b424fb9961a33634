// Renders on a thread of its own; the newest request wins.
#pragma once

#include "app/canvas/coarse_frames.h"
#include "app/canvas/floating_layers.h"
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
    quint64 serial = 0;   ///< of the request, from 1
    QString error;        ///< empty, or why there is no new picture
    QString backendText;  ///< what drew it: "CPU · 2 threads · AVX2"
    QString notice;       ///< empty, or why the CPU drew it, or why it did not stay on the device
    int coarseness = 1;   ///< pixels of the view to a side of one that was drawn
    bool floats = false;  ///< it was composed of two pictures (Floating)
    double evaluated = 0; ///< pixels that were drawn

    bool isExact() const { return coarseness == 1 && !floats; }
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

    /// True: where exact frames of gestures (RenderRequest::interactive) would take too long, coarse ones stand in for
    /// them until the gesture pauses. In memory alone, by the CPU.
    void setCoarseWanted(bool wanted);

    /// Strokes that a drag is about to map as a whole: their pictures are made ready. Null: no more.
    void lift(LiftPtr lift);
    /// Whether frames can be composed of such pictures: in memory, of the CPU. From the first frame on.
    bool canFloat() const { return m_canFloat.load(); }
    /// Whether drawing so many pixels takes too long for a frame of a gesture, by the last exact frames.
    bool isSlowFor(double pixels) const { return isSlow(pixels * m_msPerPixel); }

    /// Asks for a picture; a request that has not begun is forgotten, one that runs is cancelled where the view has
    /// changed or it takes long. Returns the request's serial.
    quint64 request(RenderRequest request, std::optional<Floating> floating = {});
    /// Serial of the last request that an exact frame has answered.
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
        std::optional<Floating> floating;
    };

    /// Where the renderer draws.
    struct CanvasTarget : Picture8 {
        bool onDevice = false;
        bool takesDeviceFrames() const override { return onDevice; }
    };

    enum class Task { Stop, Frame, Refine, Lift, Prepare, Forget };

    void run();
    void openRenderer();
    Task next();
    bool lifts() const;
    void begin(const View &view);
    void draw();
    Result<RenderStats> render(const Job &job);
    bool drawsInMemory() const;
    void noteTime(const Job &job, const RenderStats &stats);
    bool isCoarse(const Job &job);
    bool canBeCoarse(const View &view) const;
    static bool isSlow(double ms);
    bool openCoarse();
    bool drawCoarse(const Job &job);
    void prepareCoarse();
    bool openFloating();
    bool drawRest(const LiftPtr &lift, const std::atomic<bool> *cancel);
    bool shows(const LiftPtr &lift) const;
    std::optional<std::uint32_t> paperPixel(const Painting &painting) const;
    bool layPaper(const LiftPtr &lift);
    void takeShown(const LiftPtr &lift, std::uint32_t paper);
    bool drawCoarseRest(const LiftPtr &lift);
    bool drawLifted(const LiftPtr &lift, int factor, const std::atomic<bool> *cancel);
    void prepareLift();
    bool hurryLift(const LiftPtr &lift);
    bool drawFloating(const Job &job);
    void noteShown();
    FrameInfo infoOf(const Job &job) const;
    void finish(const Job &job, const Result<RenderStats> &result);
    Result<void> publish(const View &view, const std::shared_ptr<DeviceFrame> &device);
    void publishFromMemory(bool whole);
    void cancelIfUseless(const View &wanted);

    // Worker thread only.
    RendererOptions m_options;
    MakeRenderer m_make;
    std::unique_ptr<Renderer> m_renderer;
    QString m_rendererError;
    QString m_notice;                       ///< where the renderer itself has none
    Job m_job;                              ///< in hand
    std::optional<Job> m_unrefined;         ///< that a coarse frame has answered, and no exact one yet
    std::optional<RenderRequest> m_exact;   ///< of the last exact frame that was shown
    std::unique_ptr<CoarseFrames> m_coarse; ///< null until it is needed
    std::vector<PixelRect> m_enlarged;      ///< where the shown picture is coarse
    bool m_coarseGesture = false;           ///< coarse frames from here to its end
    int m_slowFrames = 0;                   ///< of the gesture, exact ones in a row
    bool m_coarseFailed = false;
    double m_evaluated = 0;  ///< pixels since an exact frame was shown
    std::unique_ptr<FloatingLayers> m_layers; ///< null until they are needed
    LiftPtr m_lift;                           ///< to be made ready
    bool m_floats = false;                    ///< the shown picture is composed of them
    bool m_layersFailed = false;

    std::mutex m_jobMutex;
    std::condition_variable m_wake;
    std::optional<Job> m_pending;
    std::optional<View> m_runningView;
    Clock::time_point m_started;
    Clock::time_point m_lastShown;
    bool m_refining = false; ///< what a coarse frame has answered
    bool m_yields = false;   ///< what is being done gives way to every request
    bool m_coarseWanted = false;
    LiftPtr m_wantedLift;
    bool m_stop = false;
    quint64 m_serial = 0;
    std::atomic<bool> m_cancel = false;
    std::atomic<bool> m_cancelledLast = false;
    std::atomic<quint64> m_shownSerial = 0;
    std::atomic<bool> m_deviceFramesWanted = false;
    std::atomic<bool> m_canFloat = false;
    std::atomic<double> m_msPerPixel = 0; ///< of exact frames

    CanvasTarget m_back;                ///< worker thread only, as the next three
    bool m_deviceFramesFailed = false;  ///< a finished one could not be shown
    std::vector<PixelRect> m_backDirty; ///< stored and not shown yet
    std::optional<View> m_publishedView;

    std::mutex m_frameMutex;
    ShownFrame m_shown;

    std::thread m_thread;
};

} // namespace suffuse
