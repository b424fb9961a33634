#include "app/canvas/render_worker.h"

#include <cstring>

namespace suffuse {

namespace {

using namespace std::chrono_literals;

/// A picture of the same view that takes longer than this gives way to a newer one, but never twice in a row.
constexpr auto longRender = 500ms;
/// While the view moves, an older picture may finish if none came for this long…
constexpr auto starving = 250ms;
/// …and it has not been running for this long.
constexpr auto patience = 400ms;
constexpr std::size_t maxDirtyRects = 4096;

void copyRect(const Picture8 &from, Picture8 &to, const PixelRect &r)
{
    for (int y = r.y; y < r.y + r.height; ++y) {
        const std::size_t at = std::size_t(y) * from.width + r.x;
        std::memcpy(to.argb.data() + at, from.argb.data() + at, std::size_t(r.width) * sizeof(std::uint32_t));
    }
}

} // namespace

RenderWorker::RenderWorker(const RendererOptions &options, QObject *parent) : QObject(parent)
{
    Result<std::unique_ptr<Renderer>> renderer = makeRenderer(options);
    if (!renderer) {
        m_rendererError = renderer.error();
        renderer = makeRenderer(RendererOptions{Backend::Cpu, options.threads, options.tileSize});
    }
    if (renderer) {
        m_renderer = std::move(*renderer);
        m_backendText = QStringLiteral("%1 · %2").arg(m_renderer->backendName(), m_renderer->deviceName());
    }
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

quint64 RenderWorker::request(RenderRequest request)
{
    quint64 serial = 0;
    {
        const std::lock_guard lock(m_jobMutex);
        serial = ++m_serial;
        cancelIfUseless(request.view);
        m_pending = Job{std::move(request), serial};
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
    if (moved ? now - m_lastShown < starving || running > patience : running > longRender && !m_cancelledLast)
        m_cancel = true;
}

void RenderWorker::withFrame(const std::function<void(ShownFrame &)> &use)
{
    const std::lock_guard lock(m_frameMutex);
    use(m_shown);
}

void RenderWorker::run()
{
    Job job;
    while (next(job)) {
        if (!m_renderer) {
            finish(job, Error{m_rendererError});
            continue;
        }
        finish(job, m_renderer->render(job.request, m_back, &m_cancel));
        job = {}; // the snapshot must not live on in a thread that sleeps
    }
}

bool RenderWorker::next(Job &job)
{
    std::unique_lock lock(m_jobMutex);
    m_runningView.reset();
    m_wake.wait(lock, [this] { return m_stop || m_pending; });
    if (m_stop)
        return false;
    job = std::move(*m_pending);
    m_pending.reset();
    m_runningView = job.request.view;
    m_cancel = false;
    m_started = Clock::now();
    return true;
}

void RenderWorker::finish(const Job &job, const Result<RenderStats> &result)
{
    FrameInfo frame;
    frame.view = job.request.view;
    frame.time = job.request.time;
    frame.serial = job.serial;
    if (result) {
        frame.stats = *result;
        m_backDirty.insert(m_backDirty.end(), result->dirty.begin(), result->dirty.end());
        m_cancelledLast = result->cancelled;
        if (result->cancelled)
            return; // a newer request waits; what is not drawn stays dirty in the renderer
        frame.stats.dirty = m_backDirty;
        publish(job.request.view);
    } else {
        frame.error = result.error();
    }
    {
        const std::lock_guard lock(m_jobMutex);
        m_lastShown = Clock::now();
    }
    m_shownSerial = job.serial;
    emit frameReady(frame);
}

void RenderWorker::publish(const View &view)
{
    const std::lock_guard lock(m_frameMutex);
    Picture8 &shown = m_shown.picture;
    if (m_publishedView != view || shown.width != m_back.width || shown.height != m_back.height) {
        shown.width = m_back.width;
        shown.height = m_back.height;
        shown.argb = m_back.argb;
        m_shown.dirty = {PixelRect{0, 0, shown.width, shown.height}};
    } else {
        for (const PixelRect &r : m_backDirty)
            copyRect(m_back, shown, r);
        m_shown.dirty.insert(m_shown.dirty.end(), m_backDirty.begin(), m_backDirty.end());
        if (m_shown.dirty.size() > maxDirtyRects)
            m_shown.dirty = {PixelRect{0, 0, shown.width, shown.height}};
    }
    m_shown.view = view;
    m_publishedView = view;
    m_backDirty.clear();
}

} // namespace suffuse
