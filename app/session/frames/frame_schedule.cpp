#include "app/session/frames/frame_schedule.h"

#include "render/picture_grid.h"

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
/// A gesture that pauses for this long gets its exact frame.
constexpr auto pause = 30ms;
/// A view that changes again within this time is in motion.
constexpr auto motion = 150ms;
/// When nothing was asked for so long, what the next gesture will need is made ready…
constexpr auto rest = 100ms;
/// A hand that does not move for this long rests.
constexpr auto handRest = 120ms;
/// …and what was made ready is let go when it was unwanted for so long.
constexpr auto forgetting = 5s;
/// An exact frame of a gesture that takes longer than this is too slow.
constexpr double slowMs = 12;
/// A frame that drew more than this part of the picture tells what a pixel costs.
constexpr double telling = 0.1;

bool isSlow(double ms)
{
    return ms > slowMs;
}

/// Whether one view shows the same pixels as the other, but for those that come into view at its edges.
bool isStep(const View &from, const View &to)
{
    const PictureGrid a = PictureGrid::ofDocument(from), b = PictureGrid::ofDocument(to);
    return a.sameGrid(b) && std::abs(a.picture.x - b.picture.x) < to.width / 4 &&
           std::abs(a.picture.y - b.picture.y) < to.height / 4;
}

} // namespace

quint64 FrameSchedule::request(RenderRequest request, std::optional<Floating> floating, Time now)
{
    if (m_hand && (m_hand->yields || isUseless(request.view, now)))
        m_cancelled = true;
    m_moving = request.interactive ? m_serial + 1 : 0;
    const bool moves = m_asked && *m_asked != request.view;
    const bool inMotion = moves && now - m_movedAt < motion;
    m_asked = request.view;
    if (moves)
        m_movedAt = now;
    m_pending = FrameJob{std::move(request), ++m_serial, std::move(floating), inMotion};
    return m_serial;
}

/// Whether the picture in hand will be worth nothing when one of another view, or a newer one of the same, is wanted.
bool FrameSchedule::isUseless(const View &wanted, Time now) const
{
    const auto running = now - m_hand->since;
    if (m_hand->view == wanted)
        return running > longRender && !m_cancelledLast;
    return running > quickRender && (now - m_shown.at < starving || running > patience);
}

void FrameSchedule::setCoarseWanted(bool wanted, Time now)
{
    if (std::exchange(m_coarseWanted, wanted) != wanted)
        m_idleSince = now;
}

void FrameSchedule::lift(LiftPtr lift, Time now)
{
    if (m_lift == lift)
        return;
    m_lift = std::move(lift);
    m_idleSince = now;
}

bool FrameSchedule::isSlowFor(double pixels) const
{
    return isSlow(pixels * m_msPerPixel);
}

FrameTask FrameSchedule::next(Time now)
{
    if (m_hand) // another way is tried
        return taskInHand();
    if (!m_pending)
        return whileNothingIsAsked(now);
    FrameJob job = *std::exchange(m_pending, std::nullopt);
    const View view = job.request.view;
    return takeUp({.kind = Kind::Exact, .job = std::move(job), .view = view, .since = now});
}

/// The first of these that is wanted is done when the hand has rested for long enough.
FrameTask FrameSchedule::whileNothingIsAsked(Time now)
{
    if (m_unrefined)
        return afterRest(pause, Kind::Exact, m_unrefined->request.view, now);
    if (needsLift())
        return afterRest(m_ready.lift == m_lift ? rest : 0ms, Kind::PrepareLift, m_lift->view, now);
    if (needsCoarse())
        return afterRest(rest, Kind::PrepareCoarse, m_shown.exact->view, now);
    if (m_moving > 0)
        return afterRest(handRest, Kind::TellRest, View(), now);
    if (!m_coarseWanted && !m_lift && m_ready.keepsAny)
        return afterRest(forgetting, Kind::Forget, View(), now);
    return {};
}

FrameTask FrameSchedule::afterRest(Clock::duration wait, Kind kind, const View &view, Time now)
{
    if (now < m_idleSince + wait)
        return {.until = m_idleSince + wait};
    Hand hand{.kind = kind, .view = view, .since = now, .yields = true, .exactly = true};
    if (kind == Kind::Exact) {
        hand.job = *std::exchange(m_unrefined, std::nullopt);
        hand.job.request.interactive = false;
    }
    FrameTask task = takeUp(std::move(hand));
    if (kind == Kind::TellRest)
        task.job.serial = std::exchange(m_moving, 0);
    return task;
}

/// Whether there is something to be made ready for what is lifted, or to be drawn finer than in haste.
bool FrameSchedule::needsLift() const
{
    return m_lift && m_canFloat && !(m_ready.lift == m_lift && m_ready.liftIsFine);
}

/// Whether a gesture may come that will need coarse frames, and their first would have to draw the whole picture.
bool FrameSchedule::needsCoarse() const
{
    if (!m_coarseWanted || m_lift || !m_shown.exact)
        return false;
    const RenderRequest &exact = *m_shown.exact;
    const bool isReady = m_ready.coarse && isSameFrame(*m_ready.coarse, exact);
    return !isReady && canBeCoarse(exact.view) && isSlowFor(double(exact.view.width) * exact.view.height);
}

bool FrameSchedule::canBeCoarse(const View &view) const
{
    return !m_coarseFailed && m_ready.inMemory && m_shown.view == view;
}

FrameTask FrameSchedule::takeUp(Hand hand)
{
    m_cancelled = false;
    m_hand = std::move(hand);
    return taskInHand();
}

FrameTask FrameSchedule::taskInHand()
{
    Hand &hand = *m_hand;
    const bool draws = hand.job.serial > 0;
    if (draws)
        hand.kind = kindFor(hand);
    FrameTask task{.kind = hand.kind, .job = hand.job, .before = m_shown.exact, .lift = m_lift};
    if (hand.kind == Kind::Coarse && m_unrefined)
        task.before = m_unrefined->request; // what differs is told from what is on the screen
    if (draws)
        task.lift = hand.job.floating ? hand.job.floating->lift : nullptr;
    task.onDevice = m_deviceWanted && !m_deviceFailed;
    task.replacesAll = m_shown.floats != task.lift || m_shown.view != hand.view;
    task.liftIsShown = task.lift && isShown(*task.lift);
    return task;
}

/// How the job in hand is done.
FrameSchedule::Kind FrameSchedule::kindFor(const Hand &hand)
{
    const RenderRequest &request = hand.job.request;
    if (hand.exactly)
        return Kind::Exact;
    if (floats(hand.job))
        return Kind::Floating;
    if (movesCoarsely(hand.job))
        return Kind::Coarse;
    if (!request.interactive || !m_shown.exact || m_shown.floats || !canBeCoarse(request.view)) {
        m_gesture = {};
        return Kind::Exact;
    }
    if (!m_coarseWanted)
        return Kind::Exact;
    if (m_gesture.coarse)
        return Kind::Coarse;
    return hand.estimated ? Kind::Exact : Kind::Estimate;
}

bool FrameSchedule::floats(const FrameJob &job) const
{
    if (!job.floating || !m_canFloat)
        return false;
    const bool isOnScreen = m_shown.exact && !m_shown.floats && isSameFrame(*m_shown.exact, job.request);
    return !(job.floating->settled && isOnScreen);
}

bool FrameSchedule::movesCoarsely(const FrameJob &job) const
{
    const View &view = job.request.view;
    return job.inMotion && m_shown.exact && m_ready.inMemory && !m_coarseFailed && !isStep(m_shown.exact->view, view) &&
           isSlowFor(double(view.width) * view.height);
}

bool FrameSchedule::isShown(const Lift &lift) const
{
    return m_ready.inMemory && m_shown.exact && !m_shown.floats && !m_shown.coarse &&
           m_shown.exact->painting == lift.from && m_shown.exact->time == lift.time && m_shown.view == lift.view;
}

void FrameSchedule::finished(const FrameResult &result, Time now)
{
    m_ready = result.ready;
    const Kind kind = m_hand->kind;
    const bool ends = kind == Kind::Exact      ? endsExact(result, now)
                      : kind == Kind::Coarse   ? endsCoarse(result, now)
                      : kind == Kind::Floating ? endsFloating(result, now)
                      : kind == Kind::Estimate ? endsEstimate(result)
                                               : true;
    if (!ends)
        return;
    endPreparing(result);
    m_hand.reset();
    m_idleSince = now;
}

void FrameSchedule::noteCost(const RenderRequest &request, const FrameResult &result)
{
    if (result.pixels > telling * request.view.width * request.view.height)
        m_msPerPixel = result.ms / result.pixels;
    if (request.interactive) { // twice: once may be another program's fault
        m_gesture.slowFrames = isSlow(result.ms) ? m_gesture.slowFrames + 1 : 0;
        m_gesture.coarse = m_gesture.slowFrames > 1;
    }
}

bool FrameSchedule::endsExact(const FrameResult &result, Time now)
{
    const FrameJob &job = m_hand->job;
    if (result.outcome != FrameOutcome::Failed)
        noteCost(job.request, result);
    if (result.outcome == FrameOutcome::Unpublished) { // once more, in memory
        m_deviceFailed = m_hand->exactly = true;
        return false;
    }
    if (result.outcome == FrameOutcome::Failed) {
        m_shown.exact.reset();
    } else {
        m_cancelledLast = result.outcome == FrameOutcome::Cancelled;
        if (m_cancelledLast) { // a newer request waits; what is not drawn stays dirty in the renderer
            if (m_hand->yields)
                m_unrefined = job;
            return true;
        }
        m_shown.exact = job.request;
        m_shown.view = job.request.view;
        m_shown.coarse = false;
        m_shown.floats.reset();
        m_canFloat = !m_floatingFailed && result.ready.inMemory;
    }
    m_unrefined.reset();
    m_shown.serial = job.serial;
    m_shown.at = now;
    return true;
}

bool FrameSchedule::endsCoarse(const FrameResult &result, Time now)
{
    if (result.outcome != FrameOutcome::Done) {
        m_coarseFailed = m_coarseFailed || result.outcome == FrameOutcome::Failed;
        m_hand->exactly = true;
        return false;
    }
    m_shown.coarse = m_shown.coarse || result.pixels > 0;
    m_shown.view = m_hand->view;
    m_shown.floats.reset();
    m_shown.at = now;
    m_unrefined = m_hand->job;
    return true;
}

bool FrameSchedule::endsFloating(const FrameResult &result, Time now)
{
    if (result.outcome != FrameOutcome::Done) {
        m_floatingFailed = m_floatingFailed || result.outcome == FrameOutcome::Failed;
        m_canFloat = false;
        return false;
    }
    m_shown.view = m_hand->view;
    m_shown.coarse = true;
    m_shown.floats = m_hand->job.floating->lift;
    m_shown.at = now;
    m_unrefined.reset();
    if (m_hand->job.floating->settled)
        m_unrefined = m_hand->job;
    return true;
}

/// Of a single stroke that changes, the renderer keeps what lies below and above: it is quicker than its pixels say.
bool FrameSchedule::endsEstimate(const FrameResult &result)
{
    m_hand->estimated = true;
    m_gesture.coarse = result.difference.strokes > 2 && isSlowFor(result.difference.pixels);
    return false;
}

void FrameSchedule::endPreparing(const FrameResult &result)
{
    const bool failed = result.outcome == FrameOutcome::Failed;
    if (m_hand->kind == Kind::PrepareCoarse)
        m_coarseFailed = m_coarseFailed || failed;
    if (m_hand->kind == Kind::PrepareLift && (failed || result.outcome == FrameOutcome::Unfit)) {
        m_floatingFailed = m_floatingFailed || failed;
        m_canFloat = false;
    }
}

} // namespace suffuse
