// Which frames of a gesture are coarse, and what becomes of them.
#include "app/canvas/render_worker.h"

#include <algorithm>
#include <tuple>

namespace suffuse {

namespace {

/// An exact frame of a gesture that takes longer than this is too slow.
constexpr double slowMs = 12;
/// Pixels of the view to a side of one that is drawn, and of these to a side of a tile: of the view it is a large one.
constexpr int coarseFactor = 4, coarseTile = 16;

double areaOf(const std::vector<PixelRect> &rects)
{
    double area = 0;
    for (const PixelRect &r : rects)
        area += double(r.width) * r.height;
    return area;
}

} // namespace

bool RenderWorker::isSlow(double ms)
{
    return ms > slowMs;
}

bool RenderWorker::canBeCoarse(const View &view) const
{
    return !m_coarseFailed && drawsInMemory() && m_publishedView == view;
}

/// The CPU does, whatever the presenter would take.
bool RenderWorker::drawsInMemory() const
{
    return m_renderer && m_renderer->backendName() == "CPU";
}

void RenderWorker::noteTime(const Job &job, const RenderStats &stats)
{
    constexpr double enough = 0.1; // of the picture
    const double area = areaOf(stats.dirty);
    m_evaluated += area;
    if (area > enough * job.request.view.width * job.request.view.height)
        m_msPerPixel = stats.totalMs / area;
    if (job.request.interactive) { // twice: once may be another program's fault
        m_slowFrames = isSlow(stats.totalMs) ? m_slowFrames + 1 : 0;
        m_coarseGesture = m_slowFrames > 1;
    }
}

bool RenderWorker::isCoarse(const Job &job)
{
    if (m_refining)
        return false;
    const RenderRequest &request = job.request;
    if (!request.interactive || !m_exact || m_floats || !canBeCoarse(request.view)) {
        m_coarseGesture = false;
        m_slowFrames = 0;
        return false;
    }
    {
        const std::lock_guard lock(m_jobMutex);
        if (!m_coarseWanted)
            return false;
    }
    // Of a single stroke that changes, the renderer keeps what lies below and above: it is quicker than its pixels say.
    if (!m_coarseGesture) {
        const Difference difference = differenceOf(*m_exact->painting, *request.painting, request.view, request.time);
        m_coarseGesture = difference.strokes > 2 && isSlow(difference.pixels * m_msPerPixel);
    }
    return m_coarseGesture;
}

bool RenderWorker::openCoarse()
{
    if (m_coarse)
        return true;
    RendererOptions options = m_options;
    options.backend = Backend::Cpu;
    options.tileSize = coarseTile;
    Result<std::unique_ptr<Renderer>> renderer = m_make(options);
    m_coarseFailed = !renderer;
    if (renderer)
        m_coarse = std::make_unique<CoarseFrames>(std::move(*renderer), coarseFactor);
    return !m_coarseFailed;
}

void RenderWorker::prepareCoarse()
{
    if (openCoarse() && !m_coarse->draw(*m_exact, &m_cancel))
        m_coarseFailed = true;
}

bool RenderWorker::drawCoarse(const Job &job)
{
    // What differs is told from what is on the screen.
    const RenderRequest &shown = m_unrefined ? m_unrefined->request : *m_exact;
    if (!openCoarse() || (!m_coarse->isAt(shown) && !m_coarse->draw(shown)))
        return false;
    const Result<RenderStats> stats = m_coarse->draw(job.request);
    if (!stats) {
        m_coarseFailed = true;
        return false;
    }
    bool fits = false;
    withFrame([&](ShownFrame &frame) {
        fits = frame.picture.width == job.request.view.width && frame.picture.height == job.request.view.height;
        if (!fits)
            return; // the last one stayed on a device
        m_coarse->enlargeInto(frame.picture, stats->dirty, m_options.threads);
        frame.dirty.insert(frame.dirty.end(), stats->dirty.begin(), stats->dirty.end());
    });
    if (!fits)
        return false;
    m_enlarged.insert(m_enlarged.end(), stats->dirty.begin(), stats->dirty.end());
    std::sort(m_enlarged.begin(), m_enlarged.end(),
              [](const PixelRect &a, const PixelRect &b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); });
    m_enlarged.erase(std::unique(m_enlarged.begin(), m_enlarged.end()), m_enlarged.end()); // whole tiles each time
    FrameInfo frame = infoOf(job);
    frame.stats = *stats;
    frame.coarseness = m_coarse->factor();
    frame.evaluated = areaOf(stats->dirty) / (m_coarse->factor() * m_coarse->factor());
    m_unrefined = job;
    noteShown();
    emit frameReady(frame);
    return true;
}

} // namespace suffuse
