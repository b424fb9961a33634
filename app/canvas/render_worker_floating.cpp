// Frames of a drag that floats.
#include "app/canvas/render_worker.h"
#include "model/painting/influence.h"

#include <algorithm>

namespace suffuse {

namespace {

/// Pixels of the view to a side of one that is drawn where the hand does not wait for more.
constexpr int hastyFactor = 4;

/// Nothing of it is to be seen.
bool isBlank(const Painting &painting)
{
    return std::none_of(painting.strokes.begin(), painting.strokes.end(),
                        [&](const StrokePtr &stroke) { return painting.isVisible(*stroke); });
}

bool isWithin(const Rect &units, const View &view)
{
    const Rect window = Rect::of(0, 0, view.width, view.height);
    for (const Point corner : {Point{units.left, units.top}, Point{units.right, units.top},
                               Point{units.right, units.bottom}, Point{units.left, units.bottom}})
        if (!window.contains(view.toPixels(corner)))
            return false;
    return true;
}

} // namespace

void RenderWorker::lift(LiftPtr lift)
{
    {
        const std::lock_guard lock(m_jobMutex);
        if (m_wantedLift == lift)
            return;
        m_wantedLift = std::move(lift);
    }
    m_wake.notify_all();
}

/// Whether there is something to be made ready, or to be drawn finer than in haste.
bool RenderWorker::lifts() const
{
    return m_lift && m_canFloat && !(m_layers && m_layers->isOf(m_lift) && m_layers->areFine());
}

bool RenderWorker::openFloating()
{
    if (m_layers)
        return true;
    RendererOptions options = m_options;
    options.backend = Backend::Cpu;
    Result<std::unique_ptr<Renderer>> renderer = m_make(options);
    m_layersFailed = !renderer;
    if (renderer)
        m_layers = std::make_unique<FloatingLayers>(std::move(*renderer));
    return bool(renderer);
}

/// Exactly; of the last frame little differs. False where it was cancelled or cannot be.
bool RenderWorker::drawRest(const LiftPtr &lift, const std::atomic<bool> *cancel)
{
    if (!drawsInMemory())
        return false;
    const Result<RenderStats> stats = m_renderer->render({lift->rest, lift->time, lift->view}, m_back, cancel);
    m_layersFailed = !stats;
    if (!stats)
        return false;
    m_backDirty.insert(m_backDirty.end(), stats->dirty.begin(), stats->dirty.end());
    if (!stats->cancelled)
        m_layers->setRest(lift, m_back, true);
    return !stats->cancelled;
}

/// Whether the exact picture of what it was lifted off is shown.
bool RenderWorker::shows(const LiftPtr &lift) const
{
    return drawsInMemory() && m_exact && !m_floats && m_enlarged.empty() && m_exact->painting == lift->from &&
           m_exact->time == lift->time && m_publishedView == lift->view;
}

/// One without paint.
std::optional<std::uint32_t> RenderWorker::paperPixel(const Painting &painting) const
{
    RendererOptions options = m_options;
    options.backend = Backend::Cpu;
    const Result<std::unique_ptr<Renderer>> renderer = m_make(options);
    auto blank = std::make_shared<Painting>();
    blank->canvas = painting.canvas;
    View view;
    view.width = view.height = 1;
    Picture8 pixel;
    if (!renderer || !(*renderer)->render({blank, 0, view}, pixel))
        return {};
    return pixel.argb.front();
}

/// Where nothing is left the rest is paper: the renderer need not forget the strokes.
bool RenderWorker::layPaper(const LiftPtr &lift)
{
    if (!isBlank(*lift->rest))
        return false;
    const std::optional<std::uint32_t> paper = paperPixel(*lift->rest);
    if (!paper)
        return false;
    Picture8 rest;
    rest.resize(lift->view.width, lift->view.height);
    std::fill(rest.argb.begin(), rest.argb.end(), *paper);
    m_layers->setRest(lift, std::move(rest), true);
    takeShown(lift, *paper);
    return true;
}

/// Where all is lifted what is shown is its picture, as far as the view goes.
void RenderWorker::takeShown(const LiftPtr &lift, std::uint32_t paper)
{
    if (!shows(lift))
        return;
    Picture8 shown;
    withFrame([&](ShownFrame &frame) { shown = frame.picture; });
    m_layers->take(lift, shown, paper, isWithin(influenceOf(*lift->lifted, lift->time), lift->view));
}

/// What is shown, coarse where lifted strokes are missing.
bool RenderWorker::drawCoarseRest(const LiftPtr &lift)
{
    const RenderRequest shown{lift->from, lift->time, lift->view};
    if (!shows(lift) || !openCoarse() || !m_coarse->isAt(shown))
        return false;
    const Result<RenderStats> stats = m_coarse->draw({lift->rest, lift->time, lift->view});
    m_coarseFailed = !stats;
    if (!stats)
        return false;
    Picture8 rest;
    withFrame([&](ShownFrame &frame) { rest = frame.picture; });
    m_coarse->enlargeInto(rest, stats->dirty, m_options.threads);
    m_layers->setRest(lift, std::move(rest), false);
    return true;
}

bool RenderWorker::drawLifted(const LiftPtr &lift, int factor, const std::atomic<bool> *cancel)
{
    const Result<bool> drawn = m_layers->draw(lift, factor, cancel);
    m_layersFailed = !drawn;
    return drawn && *drawn;
}

/// While the hand rests.
void RenderWorker::prepareLift()
{
    if (openFloating() && !m_layers->hasRest(m_lift) && layPaper(m_lift) && m_layers->isOf(m_lift))
        return; // more is made ready when the hand goes on resting
    const bool drawn = !m_layersFailed && (m_layers->hasFineRest(m_lift) || drawRest(m_lift, &m_cancel)) &&
                       drawLifted(m_lift, 1, &m_cancel);
    if (!drawn && !m_cancel)
        m_canFloat = false;
}

/// While the hand moves: a frame waits for it.
bool RenderWorker::hurryLift(const LiftPtr &lift)
{
    if (!openFloating())
        return false;
    if (!m_layers->hasRest(lift) && !layPaper(lift) && !drawCoarseRest(lift) && !drawRest(lift, nullptr))
        return false;
    return m_layers->isOf(lift) || drawLifted(lift, hastyFactor, nullptr);
}

bool RenderWorker::drawFloating(const Job &job)
{
    if (!job.floating || !m_canFloat)
        return false;
    const Floating &floating = *job.floating;
    const RenderRequest &request = job.request;
    const bool isShown = m_exact && !m_floats && m_exact->painting == request.painting &&
                         m_exact->time == request.time && m_publishedView == request.view;
    if (floating.settled && (isShown || m_refining))
        return false; // exactly
    if (!hurryLift(floating.lift)) {
        m_canFloat = false;
        return false;
    }
    FrameInfo frame = infoOf(job);
    const Clock::time_point start = Clock::now();
    const PixelRect all{0, 0, request.view.width, request.view.height};
    withFrame([&](ShownFrame &shown) {
        const bool whole = !m_floats || m_publishedView != request.view;
        if (shown.width() != all.width || shown.height() != all.height || shown.device)
            shown.picture.resize(all.width, all.height);
        shown.device.reset();
        frame.stats.dirty = m_layers->compose(floating.map, whole, shown.picture, m_options.threads);
        shown.dirty.insert(shown.dirty.end(), frame.stats.dirty.begin(), frame.stats.dirty.end());
        shown.view = request.view;
    });
    m_publishedView = request.view;
    m_floats = true;
    m_enlarged = {all};
    frame.stats.totalMs = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    frame.coarseness = m_layers->factor();
    frame.floats = true;
    if (floating.settled)
        m_unrefined = job;
    else
        m_unrefined.reset();
    noteShown();
    emit frameReady(frame);
    return true;
}

} // namespace suffuse
