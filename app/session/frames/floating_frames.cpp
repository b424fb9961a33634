#include "app/session/frames/floating_frames.h"

#include "model/painting/influence.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace suffuse {

namespace {

/// Pixels of the view to a side of one that is drawn where the hand does not wait for more.
constexpr int hastyFactor = 4;

/// Nothing of it is to be seen.
bool isBlank(const Painting &painting)
{
    const Visibility isVisible(painting.groups);
    return std::none_of(painting.strokes.begin(), painting.strokes.end(),
                        [&](const StrokePtr &stroke) { return isVisible(*stroke); });
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

FloatingFrames::FloatingFrames(const RendererOptions &options, MakeRenderer make, ExactFrames &exact,
                               CoarseFrames &coarse, FrameBoard &board)
    : m_options(options), m_make(std::move(make)), m_exact(exact), m_coarse(coarse), m_board(board)
{
    m_options.backend = Backend::Cpu;
}

bool FloatingFrames::open()
{
    if (m_layers)
        return true;
    Result<std::unique_ptr<Renderer>> renderer = m_make(m_options);
    if (renderer)
        m_layers = std::make_unique<FloatingLayers>(std::move(*renderer));
    return bool(renderer);
}

FrameResult FloatingFrames::show(const FrameTask &task, FrameInfo &frame)
{
    const FrameOutcome outcome = hurry(task);
    if (outcome != FrameOutcome::Done)
        return {.outcome = outcome};
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const View &view = task.job.request.view;
    const PixelRect all{0, 0, view.width, view.height};
    m_board.with([&](ShownFrame &shown) {
        if (shown.width() != all.width || shown.height() != all.height || shown.device)
            shown.picture.resize(all.width, all.height);
        shown.device.reset();
        frame.stats.dirty =
            m_layers->compose(task.job.floating->map, task.replacesAll, shown.picture, m_options.threads);
        shown.dirty.insert(shown.dirty.end(), frame.stats.dirty.begin(), frame.stats.dirty.end());
        shown.view = view;
    });
    (void)m_board.takePatches(); // one for all of them
    m_board.notePatches({all});
    frame.stats.totalMs = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    frame.coarseness = m_layers->factor();
    frame.floats = true;
    return {.ms = frame.stats.totalMs, .pixels = pixelsIn(frame.stats.dirty)};
}

FrameResult FloatingFrames::prepare(const FrameTask &task, const std::atomic<bool> *cancel)
{
    const LiftPtr &lift = task.lift;
    if (!open())
        return {.outcome = FrameOutcome::Failed};
    if (!m_layers->hasRest(lift) && layPaper(task) && m_layers->isOf(lift))
        return {}; // more is made ready when the hand goes on resting
    const FrameOutcome rest = m_layers->hasFineRest(lift) ? FrameOutcome::Done : drawRest(lift, cancel);
    return {.outcome = rest == FrameOutcome::Done ? drawLifted(lift, 1, cancel) : rest};
}

/// While the hand moves a frame waits for it.
FrameOutcome FloatingFrames::hurry(const FrameTask &task)
{
    const LiftPtr &lift = task.lift;
    if (!open())
        return FrameOutcome::Failed;
    if (!m_layers->hasRest(lift) && !layPaper(task) && !drawCoarseRest(task))
        if (const FrameOutcome rest = drawRest(lift, nullptr); rest != FrameOutcome::Done)
            return rest;
    return m_layers->isOf(lift) ? FrameOutcome::Done : drawLifted(lift, hastyFactor, nullptr);
}

/// Exactly: of the last frame little differs.
FrameOutcome FloatingFrames::drawRest(const LiftPtr &lift, const std::atomic<bool> *cancel)
{
    Picture8 rest;
    const FrameOutcome outcome = m_exact.draw({lift->rest, lift->time, lift->view}, cancel, rest);
    if (outcome == FrameOutcome::Done)
        m_layers->setRest(lift, std::move(rest), true);
    return outcome;
}

FrameOutcome FloatingFrames::drawLifted(const LiftPtr &lift, int factor, const std::atomic<bool> *cancel)
{
    const Result<bool> drawn = m_layers->draw(lift, factor, cancel);
    if (!drawn)
        return FrameOutcome::Failed;
    return *drawn ? FrameOutcome::Done : FrameOutcome::Cancelled;
}

/// The rest is what is shown, coarse where lifted strokes are missing. False where that is not at hand.
bool FloatingFrames::drawCoarseRest(const FrameTask &task)
{
    const Lift &lift = *task.lift;
    if (!task.liftIsShown || !m_coarse.isAt({lift.from, lift.time, lift.view}))
        return false;
    const Result<RenderStats> stats = m_coarse.draw({lift.rest, lift.time, lift.view});
    if (!stats)
        return false;
    Picture8 rest;
    m_board.with([&](ShownFrame &shown) { rest = shown.picture; });
    m_coarse.enlargeInto(rest, stats->dirty);
    m_layers->setRest(task.lift, std::move(rest), false);
    return true;
}

/// Where nothing is left the rest is paper: the renderer need not forget the strokes. False where something is left.
bool FloatingFrames::layPaper(const FrameTask &task)
{
    const LiftPtr &lift = task.lift;
    if (!isBlank(*lift->rest))
        return false;
    const std::optional<std::uint32_t> paper = paperPixel(*lift->rest);
    if (!paper)
        return false;
    Picture8 rest;
    rest.resize(lift->view.width, lift->view.height);
    std::fill(rest.argb.begin(), rest.argb.end(), *paper);
    m_layers->setRest(lift, std::move(rest), true);
    if (task.liftIsShown)
        takeShown(lift, *paper);
    return true;
}

/// One without paint.
std::optional<std::uint32_t> FloatingFrames::paperPixel(const Painting &painting) const
{
    const Result<std::unique_ptr<Renderer>> renderer = m_make(m_options);
    auto blank = std::make_shared<Painting>();
    blank->canvas = painting.canvas;
    View view;
    view.width = view.height = 1;
    Picture8 pixel;
    if (!renderer || !(*renderer)->render({blank, 0, view}, pixel))
        return {};
    return pixel.argb.front();
}

/// Where all is lifted what is shown is its picture, as far as the view goes.
void FloatingFrames::takeShown(const LiftPtr &lift, std::uint32_t paper)
{
    Picture8 shown;
    m_board.with([&](ShownFrame &frame) { shown = frame.picture; });
    m_layers->take(lift, shown, paper, isWithin(influenceOf(*lift->lifted, lift->time), lift->view));
}

} // namespace suffuse
