// A schedule of frames, driven by hand: events and what it does are words.
#pragma once

#include "app/session/frames/frame_schedule.h"

#include <QMap>
#include <QStringList>

#include <map>
#include <memory>

namespace suffuse {

/// Pixels to a side of every view.
inline constexpr int side = 100;

inline View viewOf(int number)
{
    View view;
    view.width = view.height = side;
    view.scale = number;
    return view;
}

/// Drives a schedule by hand: the clock, the hand, and the sources, which have what they would have drawn.
class ScheduleStage {
public:
    /// Lets something happen. Words of an event: see `happens`. Returns what the schedule does then: "busy" and
    /// "cancelled" while a task is in hand, else the next task, as `describe` writes it.
    QString after(const QString &event)
    {
        const QStringList words = event.split(' ', Qt::SkipEmptyParts);
        m_now = base + std::chrono::milliseconds(words[0].toInt());
        happens(words.mid(1));
        return m_task ? (schedule.isCancelled() ? "cancelled" : "busy") : next();
    }

    FrameSchedule schedule;

private:
    using Kind = FrameTask::Kind;
    using Outcome = FrameOutcome;

    static inline const FrameSchedule::Time base{std::chrono::hours(1)};

    /// ask NAME [drag] [float LIFT [settled]]   a frame of the painting NAME; NAME@2: in view 2
    /// coarse on|off, device on|off, lift NAME  as the schedule's functions; "lift none": no more
    /// done [MS [PIXELS]]                       the task, which took so long; of a whole picture without a number
    /// cancelled, unfit, unpublished, failed    what else may come of it
    /// differs STROKES PIXELS                   of Estimate
    /// lost                                     the device: the CPU draws from now on
    /// rest                                     nothing
    void happens(const QStringList &words)
    {
        const QString &deed = words[0];
        if (deed == "ask")
            ask(words);
        else if (deed == "coarse")
            schedule.setCoarseWanted(words[1] == "on", m_now);
        else if (deed == "device")
            schedule.setDeviceFramesWanted(m_deviceThere = words[1] == "on");
        else if (deed == "lift")
            schedule.lift(words[1] == "none" ? nullptr : lift(words[1]), m_now);
        else if (deed == "lost")
            m_deviceThere = false;
        else if (deed != "rest")
            finish(words);
    }

    void ask(const QStringList &words)
    {
        std::optional<Floating> floating;
        if (const qsizetype at = words.indexOf("float"); at > 0)
            floating = Floating{lift(words[at + 1]), Affine(), words.contains("settled")};
        schedule.request(request(words[1], words.contains("drag")), floating, m_now);
    }

    void finish(const QStringList &words)
    {
        static const QMap<QString, Outcome> outcomes{{"done", Outcome::Done},
                                                     {"differs", Outcome::Done},
                                                     {"cancelled", Outcome::Cancelled},
                                                     {"unfit", Outcome::Unfit},
                                                     {"unpublished", Outcome::Unpublished},
                                                     {"failed", Outcome::Failed}};
        if (!m_task || !outcomes.contains(words[0]))
            qFatal("%s: there is nothing to finish so", qPrintable(words.join(' ')));
        FrameResult result{.outcome = outcomes[words[0]], .ms = 1, .pixels = side * side};
        if (words[0] == "differs")
            result.difference = {words[2].toDouble(), words[1].toULongLong()};
        if (words[0] == "done" && words.size() > 1)
            result.ms = words[1].toDouble();
        if (words[0] == "done" && words.size() > 2)
            result.pixels = words[2].toDouble();
        keep(*m_task, result.outcome == Outcome::Done);
        result.ready = m_ready;
        m_task.reset();
        schedule.finished(result, m_now);
    }

    /// What the sources have then.
    void keep(const FrameTask &task, bool done)
    {
        if (task.kind == Kind::Exact)
            m_ready.inMemory = !m_deviceThere;
        if (task.kind == Kind::PrepareCoarse || task.kind == Kind::Coarse) {
            m_ready.keepsAny = true;
            m_ready.coarse.reset();
            if (done)
                m_ready.coarse = task.kind == Kind::Coarse ? task.job.request : *task.before;
        }
        if ((task.kind == Kind::PrepareLift || task.kind == Kind::Floating) && done) {
            m_ready.keepsAny = true;
            m_ready.liftIsFine = task.kind == Kind::PrepareLift || (m_ready.lift == task.lift && m_ready.liftIsFine);
            m_ready.lift = task.lift;
        }
        if (task.kind == Kind::Forget)
            m_ready = {.inMemory = m_ready.inMemory};
    }

    QString next()
    {
        const FrameTask task = schedule.next(m_now);
        if (task.kind != Kind::Wait)
            m_task = task;
        return describe(task);
    }

    /// "exact a", "exact a device", "estimate a b": from a to b, "coarse b from a", "float b" and its flags, "prepare
    /// coarse a", "prepare lift L", "tell rest", "forget", "wait", "wait 30": until then.
    QString describe(const FrameTask &task) const
    {
        using std::chrono::milliseconds;
        const QString before = task.before ? nameOf(*task.before) : QString();
        const QString job = task.job.serial > 0 ? nameOf(task.job.request) : QString();
        switch (task.kind) {
        case Kind::Wait:
            return task.until
                       ? QString("wait %1").arg(std::chrono::duration_cast<milliseconds>(*task.until - base).count())
                       : QString("wait");
        case Kind::Exact:
            return "exact " + job + (task.onDevice ? " device" : "");
        case Kind::Estimate:
            return "estimate " + before + ' ' + job;
        case Kind::Coarse:
            return "coarse " + job + " from " + before;
        case Kind::Floating:
            return "float " + job + (task.liftIsShown ? " over exact" : "") + (task.replacesAll ? " all" : "");
        case Kind::PrepareCoarse:
            return "prepare coarse " + before;
        case Kind::PrepareLift:
            return "prepare lift" + QString(task.liftIsShown ? " over exact" : "");
        case Kind::Forget:
            return "forget";
        case Kind::TellRest:
            return "tell rest";
        }
        return {};
    }

    RenderRequest request(const QString &name, bool drag)
    {
        RenderRequest r;
        r.painting = painting(name.section('@', 0, 0));
        r.view = viewOf(std::max(1, name.section('@', 1, 1).toInt()));
        r.interactive = drag;
        return r;
    }
    QString nameOf(const RenderRequest &r) const
    {
        QString name;
        for (const auto &[known, painting] : m_paintings)
            if (painting == r.painting)
                name = known;
        return name + (r.view.scale > 1 ? QString("@%1").arg(r.view.scale) : QString()) + (r.interactive ? "~" : "");
    }
    PaintingPtr painting(const QString &name)
    {
        PaintingPtr &painting = m_paintings[name];
        if (!painting)
            painting = std::make_shared<const Painting>();
        return painting;
    }
    /// A lift is called as the painting that it was lifted off, in view 1.
    LiftPtr lift(const QString &name)
    {
        LiftPtr &lift = m_lifts[name];
        if (!lift)
            lift = std::make_shared<const Lift>(Lift{painting(name), nullptr, nullptr, 0, viewOf(1)});
        return lift;
    }

    FrameSchedule::Time m_now = base;
    std::optional<FrameTask> m_task; ///< in hand
    FrameReadiness m_ready;
    bool m_deviceThere = false;
    std::map<QString, PaintingPtr> m_paintings;
    std::map<QString, LiftPtr> m_lifts;
};

} // namespace suffuse
