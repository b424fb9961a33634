#include "app/session/playback.h"

#include "app/session/editor.h"

#include <QTimerEvent>

#include <limits>

namespace suffuse {

namespace {

constexpr int playbackTickMs = 16;
constexpr Microseconds keptOfPauses = 500'000;

} // namespace

Playback::Playback(Editor &editor, QObject *parent) : QObject(parent), m_editor(editor)
{
    connect(&editor.document(), &Document::changed, this, [this](const Change &change) {
        if (change.reset)
            pause();
    });
}

void Playback::play()
{
    const PaintingPtr &painting = m_editor.document().painting();
    if (isPlaying() || painting->strokes.empty() || m_editor.clock().isDrawing())
        return;
    if (m_editor.clock().time() >= end())
        m_editor.clock().lookAt(begin());
    else
        m_editor.clock().lookAt(m_editor.clock().shown());
    m_rest = 0;
    m_since.start();
    m_timer.start(playbackTickMs, Qt::PreciseTimer, this);
    emit stateChanged();
}

void Playback::pause()
{
    if (!isPlaying())
        return;
    m_timer.stop();
    emit stateChanged();
}

void Playback::toggle()
{
    if (isPlaying())
        pause();
    else
        play();
}

void Playback::timerEvent(QTimerEvent *event)
{
    if (event->timerId() == m_timer.timerId())
        advance(m_since.nsecsElapsed() / 1000);
}

void Playback::advance(Microseconds real)
{
    m_since.start();
    if (m_editor.clock().isDrawing()) // the pen moves the clock meanwhile
        return pause();
    m_rest += double(real) * m_speed;
    const auto played = Microseconds(m_rest);
    m_rest -= double(played);
    const Microseconds time = after(m_editor.clock().shown(), played);
    if (time < end())
        return m_editor.clock().lookAt(time);
    m_editor.clock().lookAt(m_loops ? begin() : end());
    if (!m_loops)
        pause();
}

Microseconds Playback::after(Microseconds time, Microseconds played) const
{
    if (!m_skipsPauses)
        return time + played;
    const Microseconds shown = film().filmTime(time) + played;
    return shown < film().length() ? std::max(time, film().documentTime(shown)) : end();
}

void Playback::setSpeed(double speed)
{
    speed = std::clamp(speed, slowest, fastest);
    if (speed == m_speed)
        return;
    m_speed = speed;
    emit stateChanged();
}

void Playback::setLoops(bool loops)
{
    if (loops == m_loops)
        return;
    m_loops = loops;
    emit stateChanged();
}

void Playback::setSkipsPauses(bool skips)
{
    if (skips == m_skipsPauses)
        return;
    m_skipsPauses = skips;
    emit stateChanged();
}

const TimeSpan &Playback::span() const
{
    // What floats moves in space alone, so the timeline, which asks by a timer of its own, need not end it.
    const PaintingPtr &painting = m_editor.unsettled().painting();
    if (m_measured.painting == painting)
        return m_measured.span;
    m_measured = {painting, {0, painting->end()}, {}};
    if (!painting->strokes.empty())
        m_measured.span.begin = std::numeric_limits<Microseconds>::max();
    for (const StrokePtr &stroke : painting->strokes)
        m_measured.span.begin = std::min(m_measured.span.begin, stroke->born());
    return m_measured.span;
}

const FilmClock &Playback::film() const
{
    span();
    if (!m_measured.film)
        m_measured.film.emplace(*m_measured.painting, keptOfPauses);
    return *m_measured.film;
}

void Playback::seek(Microseconds time)
{
    pause();
    m_editor.clock().lookAt(time);
}

void Playback::toNextStroke()
{
    Microseconds next = end();
    for (const StrokePtr &stroke : m_editor.document().painting()->strokes)
        if (const Microseconds born = stroke->born(); born > m_editor.clock().time())
            next = std::min(next, born);
    seek(next);
}

void Playback::toPreviousStroke()
{
    Microseconds previous = begin();
    for (const StrokePtr &stroke : m_editor.document().painting()->strokes)
        if (const Microseconds born = stroke->born(); born < m_editor.clock().shown())
            previous = std::max(previous, born);
    seek(previous);
}

} // namespace suffuse
