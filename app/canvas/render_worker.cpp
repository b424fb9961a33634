#include "app/canvas/render_worker.h"

#include <cstring>
#include <utility>

namespace suffuse {

namespace {

using namespace std::chrono_literals;

/// A picture of the same view that takes longer than this gives way to a newer one, but never twice in a row.
constexpr auto longRender = 500ms;
/// While the view moves, an older picture may finish if it is this quick…
constexpr auto quickRender = 100ms;
/// …or if none came for this long…
constexpr auto starving = 250ms;
/// …and it has not been running for this long.
constexpr auto patience = 400ms;
constexpr std::size_t maxDirtyRects = 4096;
/// A gesture that pauses for this long gets its exact frame.
constexpr auto pause = 30ms;
/// Coarse frames are made ready when nothing has been asked for so long, and forgotten when unwanted for so long.
constexpr auto rest = 100ms;
constexpr auto forgetting = 5s;

/// Empty where CUDA can run.
QString whyNoCuda()
{
    for (const BackendInfo &backend : backends())
        if (backend.name == "CUDA" && !backend.unavailable.isEmpty())
            return QStringLiteral("CUDA: %1").arg(backend.unavailable);
    return {};
}

void copyRect(const Picture8 &from, Picture8 &to, const PixelRect &r)
{
    for (int y = r.y; y < r.y + r.height; ++y) {
        const std::size_t at = std::size_t(y) * from.width + r.x;
        std::memcpy(to.argb.data() + at, from.argb.data() + at, std::size_t(r.width) * sizeof(std::uint32_t));
    }
}

} // namespace

RenderWorker::RenderWorker(const RendererOptions &options, MakeRenderer make, QObject *parent)
    : QObject(parent), m_options(options), m_make(std::move(make))
{
    m_thread = std::thread([this] { run(); });
}

RenderWorker::~RenderWorker()
{
    {
        const std::lock_guard lock(m_jobMutex);
        m_stop = true;
        m_cancel = true;
    }
    m_wake.notify_all();
    m_thread.join();
}

quint64 RenderWorker::request(RenderRequest request, std::optional<Floating> floating)
{
    quint64 serial = 0;
    {
        const std::lock_guard lock(m_jobMutex);
        serial = ++m_serial;
        if (m_yields)
            m_cancel = true;
        else
            cancelIfUseless(request.view);
        m_pending = Job{std::move(request), serial, std::move(floating)};
    }
    m_wake.notify_all();
    return serial;
}

void RenderWorker::cancelIfUseless(const View &wanted)
{
    if (!m_runningView)
        return;
    const auto now = Clock::now();
    const auto running = now - m_started;
    const bool moved = *m_runningView != wanted;
    if (moved ? running > quickRender && (now - m_lastShown < starving || running > patience)
              : running > longRender && !m_cancelledLast)
        m_cancel = true;
}

void RenderWorker::withFrame(const std::function<void(ShownFrame &)> &use)
{
    const std::lock_guard lock(m_frameMutex);
    use(m_shown);
}

void RenderWorker::setCoarseWanted(bool wanted)
{
    {
        const std::lock_guard lock(m_jobMutex);
        if (std::exchange(m_coarseWanted, wanted) == wanted)
            return;
    }
    m_wake.notify_all();
}

void RenderWorker::run()
{
    openRenderer();
    for (Task task = next(); task != Task::Stop; task = next()) {
        if (task == Task::Prepare) {
            prepareCoarse();
        } else if (task == Task::Lift) {
            prepareLift();
        } else if (task == Task::Forget) {
            m_coarse.reset();
            m_layers.reset();
        } else {
            draw();
        }
        m_job = {}; // the snapshot must not live on in a thread that sleeps
    }
    // A device is used by one thread, to the end.
    withFrame([](ShownFrame &frame) { frame.device.reset(); });
    m_coarse.reset();
    m_layers.reset();
    m_renderer.reset();
}

void RenderWorker::draw()
{
    if (!m_renderer)
        finish(m_job, Error{m_rendererError});
    else if (!drawFloating(m_job) && (!isCoarse(m_job) || !drawCoarse(m_job)))
        finish(m_job, render(m_job));
}

void RenderWorker::openRenderer()
{
    Result<std::unique_ptr<Renderer>> renderer = m_make(m_options);
    if (!renderer) {
        m_notice = renderer.error();
        m_options.backend = Backend::Cpu;
        renderer = m_make(m_options);
    } else if (m_options.backend == Backend::Auto && (*renderer)->backendName() == "CPU") {
        m_notice = whyNoCuda();
    }
    if (renderer)
        m_renderer = std::move(*renderer);
    else
        m_rendererError = renderer.error();
}

Result<RenderStats> RenderWorker::render(const Job &job)
{
    const bool onDevice = m_deviceFramesWanted && !m_deviceFramesFailed;
    if (m_back.onDevice != onDevice) {
        m_back.onDevice = onDevice;
        m_renderer->invalidate();
    }
    Result<RenderStats> stats = m_renderer->render(job.request, m_back, &m_cancel);
    if (!stats)
        return stats;
    m_backDirty.insert(m_backDirty.end(), stats->dirty.begin(), stats->dirty.end());
    noteTime(job, *stats);
    if (stats->cancelled)
        return stats;
    m_backDirty.insert(m_backDirty.end(), m_enlarged.begin(), m_enlarged.end());
    m_enlarged.clear();
    m_floats = false;
    m_canFloat = !m_layersFailed && drawsInMemory();
    stats->dirty = m_backDirty;
    // The device belongs to this thread: nobody else may hold its last picture.
    const Result<void> published = publish(job.request.view, std::exchange(stats->frame, nullptr));
    if (published)
        return stats;
    if (m_deviceFramesFailed)
        return Error{published.error()};
    m_deviceFramesFailed = true; // once more, to memory: by the device if it still can, else by what stands in for it
    m_notice = published.error();
    return render(job);
}

RenderWorker::Task RenderWorker::next()
{
    std::unique_lock lock(m_jobMutex);
    m_runningView.reset();
    m_refining = m_yields = false;
    while (true) {
        const bool wanted = m_coarseWanted;
        m_lift = m_wantedLift;
        const auto asked = [&] { return m_stop || m_pending || m_coarseWanted != wanted || m_wantedLift != m_lift; };
        if (m_unrefined) {
            if (!m_wake.wait_for(lock, pause, asked)) {
                m_job = *std::exchange(m_unrefined, std::nullopt);
                m_job.request.interactive = false;
                m_refining = m_yields = true;
                begin(m_job.request.view);
                return Task::Refine;
            }
        } else if (lifts()) {
            if (!m_wake.wait_for(lock, m_layers && m_layers->isOf(m_lift) ? rest : 0ms, asked)) {
                m_yields = true;
                begin(m_lift->view);
                return Task::Lift;
            }
        } else if (wanted && !m_lift && m_exact && (!m_coarse || !m_coarse->isAt(*m_exact)) &&
                   canBeCoarse(m_exact->view) && isSlow(m_msPerPixel * m_exact->view.width * m_exact->view.height)) {
            if (!m_wake.wait_for(lock, rest, asked)) {
                m_yields = true;
                begin(m_exact->view);
                return Task::Prepare;
            }
        } else if (!wanted && (m_coarse || m_layers)) {
            if (!m_wake.wait_for(lock, forgetting, asked))
                return Task::Forget;
        } else {
            m_wake.wait(lock, asked);
        }
        if (m_stop)
            return Task::Stop;
        if (!m_pending)
            continue;
        m_job = *std::exchange(m_pending, std::nullopt);
        begin(m_job.request.view);
        return Task::Frame;
    }
}

void RenderWorker::begin(const View &view)
{
    m_runningView = view;
    m_cancel = false;
    m_started = Clock::now();
}

FrameInfo RenderWorker::infoOf(const Job &job) const
{
    FrameInfo frame;
    frame.view = job.request.view;
    frame.time = job.request.time;
    frame.serial = job.serial;
    if (m_renderer) {
        frame.backendText = QStringLiteral("%1 · %2").arg(m_renderer->backendName(), m_renderer->deviceName());
        frame.notice = m_renderer->notice().isEmpty() ? m_notice : m_renderer->notice();
    }
    return frame;
}

void RenderWorker::finish(const Job &job, const Result<RenderStats> &result)
{
    FrameInfo frame = infoOf(job);
    if (result) {
        m_cancelledLast = result->cancelled;
        if (result->cancelled) {
            if (m_refining)
                m_unrefined = job;
            return; // a newer request waits; what is not drawn stays dirty in the renderer
        }
        frame.stats = *result;
        frame.evaluated = std::exchange(m_evaluated, 0);
        m_exact = job.request;
    } else {
        frame.error = result.error();
        m_exact.reset();
    }
    m_unrefined.reset();
    noteShown();
    m_shownSerial = job.serial;
    emit frameReady(frame);
}

void RenderWorker::noteShown()
{
    const std::lock_guard lock(m_jobMutex);
    m_lastShown = Clock::now();
}

Result<void> RenderWorker::publish(const View &view, const std::shared_ptr<DeviceFrame> &device)
{
    const std::lock_guard lock(m_frameMutex);
    const int width = device ? device->width() : m_back.width;
    const int height = device ? device->height() : m_back.height;
    const PixelRect all{0, 0, width, height};
    const bool whole =
        m_publishedView != view || device != m_shown.device || width != m_shown.width() || height != m_shown.height();
    if (whole)
        m_backDirty = {all};
    if (device) {
        if (const Result<void> published = device->publish(m_backDirty); !published)
            return published;
        m_shown.picture = {};
    } else {
        publishFromMemory(whole);
    }
    m_shown.device = device;
    m_shown.dirty.insert(m_shown.dirty.end(), m_backDirty.begin(), m_backDirty.end());
    if (whole || m_shown.dirty.size() > maxDirtyRects)
        m_shown.dirty = {all};
    m_shown.view = view;
    m_publishedView = view;
    m_backDirty.clear();
    return {};
}

void RenderWorker::publishFromMemory(bool whole)
{
    Picture8 &shown = m_shown.picture;
    if (whole) {
        shown = m_back;
        return;
    }
    for (const PixelRect &r : m_backDirty)
        copyRect(m_back, shown, r);
}

} // namespace suffuse
