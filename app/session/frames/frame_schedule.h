// Which frame is drawn next, and how: decided without thread, timer or window.
#pragma once

#include "app/session/frames/lift.h"
#include "app/session/frames/reach.h"
#include "render/renderer.h"

#include <QtGlobal>

#include <chrono>
#include <optional>

namespace suffuse {

/// Whether two requests ask for the same painting, moment and view.
inline bool isSameFrame(const RenderRequest &a, const RenderRequest &b)
{
    return a.painting == b.painting && a.time == b.time && a.view == b.view;
}

/// A frame that was asked for.
struct FrameJob {
    RenderRequest request;
    quint64 serial = 0;               ///< from 1
    std::optional<Floating> floating; ///< what floats in it
    bool inMotion = false;            ///< the view had changed shortly before, and changed again with this request
};

/// What came of a task, in a word.
enum class FrameOutcome {
    Done,
    Cancelled,
    Unfit,       ///< The source cannot draw this frame; it may draw others.
    Unpublished, ///< An exact picture that stayed on the device could not be shown from there.
    Failed,      ///< The source cannot draw at all. For an exact frame: there is no picture.
};

/// What is to be done next.
struct FrameTask {
    enum class Kind {
        Wait,          ///< Nothing is to be done before `until`, unless something happens.
        Exact,         ///< The job's picture is drawn and shown.
        Estimate,      ///< `differenceOf` the job and `before` is computed; the job follows.
        Coarse,        ///< The job's picture is drawn coarsely, and what differs from `before` is shown.
        Floating,      ///< The job's picture is composed of the two pictures of its lift, and shown.
        PrepareCoarse, ///< The coarse picture of `before` is drawn, and not shown.
        PrepareLift,   ///< The two pictures of `lift` are drawn, and not shown.
        TellRest,      ///< The window is told that the hand rests since the job was asked for.
        Forget,        ///< What the coarse and the floating source keep is let go.
    };

    Kind kind = Kind::Wait;
    std::optional<std::chrono::steady_clock::time_point> until{}; ///< none: for as long as nothing happens
    FrameJob job{};
    std::optional<RenderRequest> before{}; ///< the frame that was shown before, exactly or, for Coarse, coarsely
    LiftPtr lift{};                        ///< of PrepareLift, and of the job where it floats
    bool onDevice = false;                 ///< Exact: the picture may stay on the device that computes it.
    bool replacesAll = false;              ///< Floating: what is shown was not composed of the same two pictures.
    bool liftIsShown = false;              ///< The exact picture of what was lifted off is on the screen.

    /// Whether with this outcome there is a new frame on the screen, or the error in its place.
    bool isAnswered(FrameOutcome outcome) const
    {
        const bool shows = kind == Kind::Exact || kind == Kind::Coarse || kind == Kind::Floating;
        return (shows && outcome == FrameOutcome::Done) || (kind == Kind::Exact && outcome == FrameOutcome::Failed);
    }
};

/// What the sources have at hand after a task.
struct FrameReadiness {
    bool inMemory = false;                 ///< exact frames are drawn in memory, by the CPU
    bool keepsAny = false;                 ///< there is something to forget
    std::optional<RenderRequest> coarse{}; ///< the frame that the coarse picture shows
    LiftPtr lift{};                        ///< of which there are both pictures
    bool liftIsFine = false;               ///< neither of them is coarse
};

/// What came of a task.
struct FrameResult {
    FrameOutcome outcome = FrameOutcome::Done;
    double ms = 0;           ///< that drawing took
    double pixels = 0;       ///< of the view, that were drawn
    Difference difference{}; ///< of Estimate
    FrameReadiness ready{};
};

/// Decides what the frame thread does next. It is told what happens, and at which time; it asks no clock, holds no lock
/// and draws nothing. It promises:
/// - The newest request is drawn, exactly once nothing is asked for any more; requests before it may be left out.
/// - A picture that is being drawn is cancelled where it would be of no use, but requests that come without end do not
///   keep the screen from changing.
/// - Frames of a gesture are coarse only while that is wanted, and in the view of the last exact frame.
/// - Frames of a view that keeps moving are coarse, unless the picture moved by whole pixels alone, which is quick.
/// - They are coarse only where exact ones take longer than a frame has, which the schedule estimates from the last
/// ones.
/// - A pause of the gesture brings the exact frame.
/// - When the hand has rested for long enough, the window hears of it once: what floats cannot be exact before the
/// document has it.
/// - Whatever fails, the exact frame is drawn in its place.
class FrameSchedule {
public:
    using Clock = std::chrono::steady_clock;
    using Time = Clock::time_point;

    /// Asks for a frame, in place of one that waits. Returns its serial.
    quint64 request(RenderRequest request, std::optional<Floating> floating, Time now);
    /// Whether coarse frames may stand in for exact ones of gestures (RenderRequest::interactive).
    void setCoarseWanted(bool wanted, Time now);
    /// Whether pictures may stay on the device that computes them, from the next exact frame on.
    void setDeviceFramesWanted(bool wanted) { m_deviceWanted = wanted; }
    /// The strokes that a drag is about to map as a whole; null: none.
    void lift(LiftPtr lift, Time now);

    /// What is to be done now. Not while a task is in hand: ask again when it is finished, after events, and at
    /// `until`.
    FrameTask next(Time now);
    /// The task that `next` gave last, unless it was Wait, has ended.
    void finished(const FrameResult &result, Time now);

    /// Whether the task in hand is to be given up.
    bool isCancelled() const { return m_cancelled; }
    /// Whether frames can float: from the first exact one on that the CPU drew in memory.
    bool canFloat() const { return m_canFloat; }
    /// Whether drawing so many pixels takes too long for a frame of a gesture, by the last exact frames.
    bool isSlowFor(double pixels) const;
    /// Serial of the last request that an exact frame has answered, or an error.
    quint64 shownSerial() const { return m_shown.serial; }

private:
    using Kind = FrameTask::Kind;

    /// The task that is being done, and the job that it is done for.
    struct Hand {
        Kind kind = Kind::Wait;
        FrameJob job{}; ///< of tasks that show a frame
        View view{};
        Time since{};
        bool yields = false;    ///< every request cancels it
        bool exactly = false;   ///< nothing may stand in for the exact frame
        bool estimated = false; ///< how slow the exact frame will be is known
    };
    /// What is on the screen.
    struct Shown {
        std::optional<RenderRequest> exact; ///< the last exact frame, which may have been painted over since
        std::optional<View> view;
        bool coarse = false; ///< parts of it, or all, are not exact
        LiftPtr floats;      ///< it was composed of the two pictures of this lift; null: it was not
        quint64 serial = 0;
        Time at; ///< when any frame came last
    };
    /// What is known of the gesture that is going on.
    struct Gesture {
        bool coarse = false; ///< its frames are coarse from here on
        int slowFrames = 0;  ///< exact ones, in a row
    };

    Kind kindFor(const Hand &hand);
    bool floats(const FrameJob &job) const;
    bool movesCoarsely(const FrameJob &job) const;
    bool canBeCoarse(const View &view) const;
    bool isShown(const Lift &lift) const;
    bool isUseless(const View &wanted, Time now) const;
    bool needsLift() const;
    bool needsCoarse() const;
    FrameTask whileNothingIsAsked(Time now);
    FrameTask afterRest(Clock::duration wait, Kind kind, const View &view, Time now);
    FrameTask takeUp(Hand hand);
    FrameTask taskInHand();
    void noteCost(const RenderRequest &request, const FrameResult &result);
    bool endsExact(const FrameResult &result, Time now);
    bool endsCoarse(const FrameResult &result, Time now);
    bool endsFloating(const FrameResult &result, Time now);
    bool endsEstimate(const FrameResult &result);
    void endPreparing(const FrameResult &result);

    std::optional<FrameJob> m_pending;
    std::optional<Hand> m_hand;
    quint64 m_moving = 0;                ///< the last request, where it was of a gesture that has not rested since
    std::optional<FrameJob> m_unrefined; ///< that a coarse frame has answered, and no exact one yet
    Shown m_shown;
    Gesture m_gesture;
    FrameReadiness m_ready;
    LiftPtr m_lift;
    Time m_idleSince;
    std::optional<View> m_asked; ///< the view of the last request
    Time m_movedAt;              ///< when a request had another view than the one before it
    quint64 m_serial = 0;
    double m_msPerPixel = 0; ///< of exact frames
    bool m_coarseWanted = false;
    bool m_coarseFailed = false;
    bool m_deviceWanted = false;
    bool m_deviceFailed = false; ///< a finished picture could not be shown from there
    bool m_canFloat = false;
    bool m_floatingFailed = false;
    bool m_cancelled = false;
    bool m_cancelledLast = false; ///< the last exact frame
};

} // namespace suffuse
