// Which moment of the painting is looked at, and when it goes on by itself.
#pragma once

#include "model/painting/segment.h"

#include <QBasicTimer>
#include <QElapsedTimer>
#include <QObject>

#include <algorithm>

namespace suffuse {

/// Document time T, µs. It runs while a stroke is drawn or something still spreads, and stands still otherwise; opening
/// sets it to the end; undo never turns it back. In the past it stands, but for a stroke.
class PaintingClock : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    Microseconds time() const;
    /// The moment as it is shown: never after the end, from which on the picture stays the same, but for a stroke in
    /// hand. The clock itself stays where it is when the newest strokes go, so that they come back as dry as they were.
    Microseconds shown() const { return m_drawing ? time() : std::min(time(), m_end); }
    bool isRunning() const { return m_running; }
    /// The moment that was `late` ago; while the clock stands it is this one.
    Microseconds momentBefore(Microseconds late) const { return std::max(m_time, time() - late); }
    /// Starts it (a stroke began, `late` ago, at `momentBefore`); it stops by itself when this is called without
    /// `drawing` and all has dried.
    void hold(bool drawing, Microseconds late = 0);
    /// Looks at another moment; it goes on from there while something still spreads at it.
    void setTime(Microseconds time);
    /// Looks at another moment and stays there: the past. What is painted there takes its place in time and order, and
    /// the clock runs until that is dry. From the end on it is free again: the present. Does nothing while a stroke is
    /// drawn.
    void lookAt(Microseconds time);
    bool isInPast() const { return m_inPast; }
    bool isDrawing() const { return m_drawing; }
    /// With it the clock moves by `setTime` only, never by itself: for scripts and tests.
    void setManual(bool manual);
    bool isManual() const { return m_manual; }

    /// Another painting is there: stands at its end, in the present. `timeChanged` is left to the caller.
    void reset(Microseconds end);
    /// The painting was edited: all of it has dried by `end`.
    void setEnd(Microseconds end);
    /// Runs until all has dried, from now or, if that is later, from `earliest`.
    void runFrom(Microseconds earliest);
    /// What was painted into the past last: the clock runs until it has dried.
    void noteDrawn(const Segment &segment);

signals:
    void timeChanged();
    void pastChanged(); ///< from present to past, or back

protected:
    void timerEvent(QTimerEvent *event) override;

private:
    void tick();
    void start();
    void stop();
    void setInPast(bool past);
    /// When it stops.
    Microseconds runsUntil() const { return m_inPast ? m_dryAt : m_end; }

    Microseconds m_time = 0; ///< when it last stood
    Microseconds m_end = 0;  ///< when all has dried
    QElapsedTimer m_since;   ///< real time since then, while it runs
    bool m_running = false;
    bool m_drawing = false;
    bool m_manual = false;
    bool m_inPast = false;
    Microseconds m_drawnSince = 0; ///< when the last stroke was begun
    Microseconds m_dryAt = 0;      ///< when what was painted in the past has dried
    QBasicTimer m_timer;
};

} // namespace suffuse
