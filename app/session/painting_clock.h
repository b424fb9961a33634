// The clock that says which moment of the painting is looked at, and when that moment goes on by itself.
#pragma once

#include "model/painting/segment.h"

#include <QBasicTimer>
#include <QElapsedTimer>
#include <QObject>

#include <algorithm>

namespace suffuse {

/// Keeps the document time T, in µs. In the present it runs while a stroke is drawn or paint still spreads, and stands
/// still otherwise. Opening a document sets it to the end. In the past it stands still, except while a stroke is drawn
/// and dries.
class PaintingClock : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// The moment that is looked at. It is never after the end, from which on the picture stays the same, except while
    /// a stroke is drawn. When the newest strokes are undone, it is that of the new end, where the next stroke then
    /// begins. The clock remembers where it was, so that a redo brings them back as dry as they were.
    Microseconds time() const { return m_drawing || m_manual ? reached() : std::min(reached(), m_end); }
    /// The same, and not after the end where a manual clock is, or a stroke in hand that waits and has dried.
    Microseconds shown() const { return std::min(time(), end()); }
    /// When all has dried, the stroke in hand included.
    Microseconds end() const { return m_drawing ? std::max(m_end, m_draftEnd) : m_end; }
    bool isRunning() const { return m_running; }
    /// The moment that was `late` ago. While the clock stands still, this is the present moment.
    Microseconds momentBefore(Microseconds late) const
    {
        const Microseconds now = time();
        return std::max(std::min(m_time, now), now - late);
    }
    /// With `drawing`, a stroke began `late` ago, at `momentBefore(late)`: starts the clock. Without `drawing`, the
    /// stroke has ended: the clock stops by itself when all has dried.
    void hold(bool drawing, Microseconds late = 0);
    /// Looks at another moment. The clock goes on from there if paint still spreads at that moment.
    void setTime(Microseconds time);
    /// Looks at a moment of the past and stays there. A stroke that is painted then gets its place in time and in the
    /// order, and the clock runs until it is dry. A moment at the end or later is the present, and sets the clock free
    /// again. Does nothing while a stroke is drawn.
    void lookAt(Microseconds time);
    bool isInPast() const { return m_inPast; }
    bool isDrawing() const { return m_drawing; }
    /// A manual clock moves only by `setTime`, never by itself. Scripts and tests use it.
    void setManual(bool manual);
    bool isManual() const { return m_manual; }

    /// Call it when another painting is there: the clock stands at that painting's end, in the present. Telling
    /// `timeChanged` is left to the caller.
    void reset(Microseconds end);
    /// Call it after an edit: all paint has dried by `end`.
    void setEnd(Microseconds end);
    /// Call it for the stroke in hand: its paint has dried by `end`.
    void setDraftEnd(Microseconds end) { m_draftEnd = end; }
    /// Call it before paint comes that dries after the end and is no redo: the clock goes on from the moment that is
    /// looked at, and forgets how far it was before something was undone. Otherwise it would have seen the new paint
    /// dry already, and jump to its end.
    void forgetUndone();
    /// Runs until all has dried, from now on or, if that is later, from `earliest`.
    void runFrom(Microseconds earliest);
    /// Call it for a segment that was painted into the past: the clock runs until it has dried.
    void noteDrawn(const Segment &segment);
    /// Call it for paint that came all at once, at the moment of the past that is looked at: the clock runs until it
    /// has dried, as after a stroke.
    void runUntil(Microseconds dryAt);

signals:
    void timeChanged();
    void pastChanged(); ///< from present to past, or back

protected:
    void timerEvent(QTimerEvent *event) override;

private:
    /// How far it has gone, whatever has been undone.
    Microseconds reached() const;
    void tick();
    void start();
    void stop();
    void setInPast(bool past);
    /// The moment at which the clock stops by itself.
    Microseconds runsUntil() const { return m_inPast ? m_dryAt : m_end; }

    Microseconds m_time = 0;     ///< the time when it stood still last
    Microseconds m_end = 0;      ///< when all has dried
    Microseconds m_draftEnd = 0; ///< when the stroke in hand has dried; 0: there is none
    QElapsedTimer m_since;       ///< real time since then, while the clock runs
    bool m_running = false;
    bool m_drawing = false;
    bool m_manual = false;
    bool m_inPast = false;
    Microseconds m_drawnSince = 0; ///< when the last stroke was begun
    Microseconds m_dryAt = 0;      ///< when the paint of the last stroke in the past has dried
    QBasicTimer m_timer;
};

} // namespace suffuse
