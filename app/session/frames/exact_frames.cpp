#include "app/session/frames/exact_frames.h"

#include <cstring>
#include <utility>

namespace suffuse {

namespace {

constexpr std::size_t maxDirtyRects = 4096;

/// Adds rectangles of a picture to others of it. One that is all of the picture replaces them.
void append(std::vector<PixelRect> &to, const std::vector<PixelRect> &rects, const Picture8 &picture)
{
    if (rects == std::vector<PixelRect>{{0, 0, picture.width, picture.height}})
        to.clear();
    to.insert(to.end(), rects.begin(), rects.end());
}

void copyRect(const Picture8 &from, Picture8 &to, const PixelRect &r)
{
    for (int y = r.y; y < r.y + r.height; ++y) {
        const std::size_t at = std::size_t(y) * from.width + r.x;
        std::memcpy(to.argb.data() + at, from.argb.data() + at, std::size_t(r.width) * sizeof(std::uint32_t));
    }
}

} // namespace

ExactFrames::ExactFrames(const RendererOptions &options, const MakeRenderer &make, FrameBoard &board) : m_board(board)
{
    Result<std::unique_ptr<Renderer>> renderer = make(options);
    if (!renderer) {
        m_notice = renderer.error();
        RendererOptions byCpu = options;
        byCpu.backend = Backend::Cpu;
        renderer = make(byCpu);
    }
    if (renderer)
        m_renderer = std::move(*renderer);
    else
        m_error = renderer.error();
}

QString ExactFrames::backendText() const
{
    if (!m_renderer)
        return {};
    return QStringLiteral("%1 · %2").arg(nameOf(m_renderer->backend()), m_renderer->deviceName());
}

QString ExactFrames::notice() const
{
    if (!m_renderer)
        return {};
    const QString notice = m_renderer->notice();
    return notice.isEmpty() ? m_notice : notice;
}

FrameResult ExactFrames::show(const FrameTask &task, const std::atomic<bool> *cancel, FrameInfo &frame)
{
    const auto failed = [&frame](const QString &error) {
        frame.error = error;
        return FrameResult{.outcome = FrameOutcome::Failed};
    };
    if (!m_renderer)
        return failed(m_error);
    if (std::exchange(m_back.onDevice, task.onDevice) != task.onDevice)
        m_renderer->invalidate();
    begin(task.job.request.view);
    Result<RenderStats> stats = m_renderer->render(task.job.request, m_back, cancel);
    if (!stats)
        return failed(stats.error());
    FrameResult result{.ms = stats->totalMs, .pixels = stats->pixelsEvaluated};
    m_evaluated += result.pixels;
    append(m_unpublished, stats->dirty, m_back);
    if (stats->cancelled) {
        result.outcome = FrameOutcome::Cancelled;
        return result;
    }
    append(m_unpublished, m_board.takePatches(), m_back);
    stats->dirty = m_unpublished;
    // The device belongs to this thread: nobody else may hold its last picture.
    const Result<void> published = publish(task.job.request.view, std::exchange(stats->frame, nullptr));
    if (!published && !task.onDevice)
        return failed(published.error());
    if (!published) { // by the device if it still can, else by what stands in for it
        m_notice = published.error();
        result.outcome = FrameOutcome::Unpublished;
        return result;
    }
    frame.stats = std::move(*stats);
    frame.evaluated = std::exchange(m_evaluated, 0);
    return result;
}

FrameOutcome ExactFrames::draw(const RenderRequest &request, const std::atomic<bool> *cancel, Picture8 &picture)
{
    if (!isInMemory())
        return FrameOutcome::Unfit;
    begin(request.view);
    const Result<RenderStats> stats = m_renderer->render(request, m_back, cancel);
    if (!stats)
        return FrameOutcome::Failed;
    append(m_unpublished, stats->dirty, m_back);
    if (stats->cancelled)
        return FrameOutcome::Cancelled;
    picture = m_back;
    return FrameOutcome::Done;
}

void ExactFrames::begin(const View &view)
{
    if (m_drawn != view)
        m_unpublished.clear();
    m_drawn = view;
}

Result<void> ExactFrames::publish(const View &view, const std::shared_ptr<DeviceFrame> &device)
{
    const int width = device ? device->width() : m_back.width;
    const int height = device ? device->height() : m_back.height;
    const PixelRect all{0, 0, width, height};
    Result<void> published;
    m_board.with([&](ShownFrame &shown) {
        const bool whole =
            shown.view != view || device != shown.device || width != shown.width() || height != shown.height();
        if (whole)
            m_unpublished = {all};
        if (device)
            published = device->publish(m_unpublished);
        if (!published)
            return;
        copyToShown(shown, device, whole);
        shown.dirty.insert(shown.dirty.end(), m_unpublished.begin(), m_unpublished.end());
        if (whole || shown.dirty.size() > maxDirtyRects)
            shown.dirty = {all};
        shown.view = view;
        m_unpublished.clear();
    });
    return published;
}

/// Takes over the device's picture, or the one in memory.
void ExactFrames::copyToShown(ShownFrame &shown, const std::shared_ptr<DeviceFrame> &device, bool whole) const
{
    shown.device = device;
    if (device)
        shown.picture = {};
    else if (whole)
        shown.picture = m_back;
    else
        for (const PixelRect &r : m_unpublished)
            copyRect(m_back, shown.picture, r);
}

} // namespace suffuse
