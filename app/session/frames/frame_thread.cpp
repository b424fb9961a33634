#include "app/session/frames/frame_thread.h"

#include "app/session/frames/coarse_frames.h"
#include "app/session/frames/exact_frames.h"
#include "app/session/frames/floating_frames.h"

#include <utility>

namespace suffuse {

/// Made and used by the thread alone.
struct FrameThread::Sources {
    FrameBoard &board;
    ExactFrames exact;
    CoarseFrames coarse;
    FloatingFrames floating;

    Sources(const RendererOptions &options, const MakeRenderer &make, FrameBoard &frameBoard)
        : board(frameBoard), exact(options, make, board), coarse(options, make),
          floating(options, make, exact, coarse, board)
    {}
    /// Does a task. `frame` gets figures, where it was to show one.
    FrameResult carryOut(const FrameTask &task, const std::atomic<bool> *cancel, FrameInfo &frame);
    FrameReadiness readiness() const
    {
        return {exact.isInMemory(), coarse.keepsAny() || floating.keepsAny(), coarse.at(), floating.lift(),
                floating.isFine()};
    }
};

FrameThread::FrameThread(const RendererOptions &options, MakeRenderer make, QObject *parent)
    : QObject(parent), m_options(options), m_make(std::move(make))
{
    m_thread = std::thread([this] { run(); });
}

FrameThread::~FrameThread()
{
    {
        const std::lock_guard lock(m_mutex);
        m_stop = m_cancel = true;
    }
    m_wake.notify_all();
    m_thread.join();
}

void FrameThread::tell(const std::function<void(FrameSchedule &)> &event)
{
    {
        const std::lock_guard lock(m_mutex);
        event(m_schedule);
        m_cancel = m_schedule.isCancelled();
    }
    m_wake.notify_all();
}

quint64 FrameThread::request(RenderRequest request, std::optional<Floating> floating)
{
    quint64 serial = 0;
    tell([&](FrameSchedule &schedule) {
        serial = schedule.request(std::move(request), std::move(floating), FrameSchedule::Clock::now());
    });
    return serial;
}

void FrameThread::setDeviceFramesWanted(bool wanted)
{
    tell([=](FrameSchedule &schedule) { schedule.setDeviceFramesWanted(wanted); });
}

void FrameThread::setCoarseWanted(bool wanted)
{
    tell([=](FrameSchedule &schedule) { schedule.setCoarseWanted(wanted, FrameSchedule::Clock::now()); });
}

void FrameThread::lift(LiftPtr lift)
{
    tell([&](FrameSchedule &schedule) { schedule.lift(std::move(lift), FrameSchedule::Clock::now()); });
}

quint64 FrameThread::shownSerial() const
{
    const std::lock_guard lock(m_mutex);
    return m_schedule.shownSerial();
}

bool FrameThread::canFloat() const
{
    const std::lock_guard lock(m_mutex);
    return m_schedule.canFloat();
}

bool FrameThread::isSlowFor(double pixels) const
{
    const std::lock_guard lock(m_mutex);
    return m_schedule.isSlowFor(pixels);
}

/// Waits for the next task; none: the thread is to end.
std::optional<FrameTask> FrameThread::nextTask()
{
    std::unique_lock lock(m_mutex);
    while (!m_stop) {
        FrameTask task = m_schedule.next(FrameSchedule::Clock::now());
        m_cancel = m_schedule.isCancelled();
        if (task.kind != FrameTask::Kind::Wait)
            return task;
        if (task.until)
            m_wake.wait_until(lock, *task.until);
        else
            m_wake.wait(lock);
    }
    return {};
}

FrameResult FrameThread::Sources::carryOut(const FrameTask &task, const std::atomic<bool> *cancel, FrameInfo &frame)
{
    using Kind = FrameTask::Kind;
    const RenderRequest &request = task.job.request;
    switch (task.kind) {
    case Kind::Exact:
        return exact.show(task, cancel, frame);
    case Kind::Estimate:
        return {.difference = differenceOf(*task.before->painting, *request.painting, request.view, request.time)};
    case Kind::Coarse:
        return coarse.show(task, board, frame);
    case Kind::Floating:
        return floating.show(task, frame);
    case Kind::PrepareCoarse:
        return coarse.prepare(task, cancel);
    case Kind::PrepareLift:
        return floating.prepare(task, cancel);
    case Kind::Forget:
        coarse.forget();
        floating.forget();
        return {};
    case Kind::TellRest:
    case Kind::Wait:
        break;
    }
    return {};
}

void FrameThread::run()
{
    Sources sources(m_options, m_make, m_board);
    while (const std::optional<FrameTask> task = nextTask()) {
        FrameInfo frame;
        FrameResult result = sources.carryOut(*task, &m_cancel, frame);
        result.ready = sources.readiness();
        tell([&](FrameSchedule &schedule) { schedule.finished(result, FrameSchedule::Clock::now()); });
        if (task->kind == FrameTask::Kind::TellRest)
            emit handRests(task->job.serial);
        if (task->isAnswered(result.outcome))
            deliver(sources, task->job, frame);
    }
    // A device is used by one thread, to the end.
    m_board.with([](ShownFrame &shown) { shown.device.reset(); });
}

void FrameThread::deliver(const Sources &sources, const FrameJob &job, FrameInfo &frame)
{
    frame.view = job.request.view;
    frame.time = job.request.time;
    frame.serial = job.serial;
    frame.backendText = sources.exact.backendText();
    frame.notice = sources.exact.notice();
    emit frameReady(frame);
}

} // namespace suffuse
