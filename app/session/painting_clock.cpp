#include "app/session/painting_clock.h"

#include <QTimerEvent>

namespace suffuse {

namespace {

constexpr int clockTickMs = 16;

} // namespace

Microseconds PaintingClock::reached() const
{
    if (!m_running || m_manual)
        return m_time;
    const Microseconds now = m_time + m_since.nsecsElapsed() / 1000;
    // A reopened file stands at its end. A clock that stops exactly there shows the same picture as the reopened file.
    return m_drawing ? now : std::min(now, std::max(m_time, runsUntil()));
}

void PaintingClock::hold(bool drawing, Microseconds late)
{
    const Microseconds began = momentBefore(late);
    m_time = began + late;
    m_since.start();
    m_drawing = drawing;
    if (drawing)
        m_drawnSince = m_dryAt = began;
    start();
}

void PaintingClock::setTime(Microseconds time)
{
    if (!m_drawing)
        setInPast(false);
    m_time = time;
    m_since.start();
    start();
    tick();
}

void PaintingClock::lookAt(Microseconds time)
{
    if (m_drawing)
        return;
    stop();
    m_time = m_dryAt = std::min(time, m_end);
    setInPast(m_time < m_end);
    emit timeChanged();
}

void PaintingClock::setManual(bool manual)
{
    m_time = reached();
    m_since.start();
    m_manual = manual;
}

void PaintingClock::reset(Microseconds end)
{
    m_drawing = false;
    stop();
    setInPast(false);
    m_time = m_end = end;
}

void PaintingClock::setEnd(Microseconds end)
{
    const Microseconds now = time();
    m_end = end;
    if (m_inPast && !m_drawing && now >= end)
        setInPast(false);
}

void PaintingClock::forgetUndone()
{
    if (m_drawing || m_manual || reached() <= m_end)
        return;
    m_time = m_end;
    m_since.start();
}

void PaintingClock::runFrom(Microseconds earliest)
{
    m_time = std::max(time(), earliest);
    m_since.start();
    start();
}

void PaintingClock::noteDrawn(const Segment &segment)
{
    if (segment.born >= m_drawnSince)
        m_dryAt = std::max(m_dryAt, segment.driesAt());
}

void PaintingClock::runUntil(Microseconds dryAt)
{
    m_dryAt = std::max(m_dryAt, dryAt);
    start();
}

void PaintingClock::setInPast(bool past)
{
    if (past == m_inPast)
        return;
    m_inPast = past;
    emit pastChanged();
}

void PaintingClock::timerEvent(QTimerEvent *event)
{
    if (event->timerId() == m_timer.timerId())
        tick();
}

void PaintingClock::tick()
{
    if (!m_drawing && reached() >= runsUntil()) {
        stop();
        if (m_time >= m_end)
            setInPast(false);
    }
    emit timeChanged();
}

void PaintingClock::start()
{
    if (m_running)
        return;
    m_running = true;
    m_since.start();
    m_timer.start(clockTickMs, Qt::PreciseTimer, this);
}

void PaintingClock::stop()
{
    m_time = reached();
    m_running = false;
    m_timer.stop();
}

} // namespace suffuse
