#pragma once

#include "model/document/timelapse.h"

#include <QBasicTimer>
#include <QElapsedTimer>
#include <QObject>

#include <optional>

namespace suffuse {

class Editor;

/// Plays how the painting was painted, and goes to moments of it. It only sets the moment that is looked at: the
/// picture there is the same however it was reached.
class Playback : public QObject {
    Q_OBJECT

public:
    static constexpr double slowest = 0.1, fastest = 1000;

    explicit Playback(Editor &editor, QObject *parent = nullptr);

    bool isPlaying() const { return m_timer.isActive(); }
    /// Plays on from the moment that is looked at, or from the beginning if that moment is the end.
    void play();
    void pause();
    void toggle();
    /// Plays on by this much real time. The timer calls it.
    void advance(Microseconds real);

    double speed() const { return m_speed; }
    void setSpeed(double speed); ///< cut to [slowest, fastest]
    bool loops() const { return m_loops; }
    void setLoops(bool loops);
    /// Whether pauses in which nothing is drawn or spreads are cut to half a second.
    bool skipsPauses() const { return m_skipsPauses; }
    void setSkipsPauses(bool skips);

    Microseconds begin() const { return span().begin; } ///< when the first stroke begins
    Microseconds end() const { return span().end; }     ///< when all has dried

    /// Pauses and looks at the moment.
    void seek(Microseconds time);
    /// These go to the moments at which strokes begin.
    void toNextStroke();
    void toPreviousStroke();

signals:
    void stateChanged(); ///< playing, speed, loop or pauses

protected:
    void timerEvent(QTimerEvent *event) override;

private:
    Microseconds after(Microseconds time, Microseconds played) const;

    Editor &m_editor;
    QBasicTimer m_timer;
    QElapsedTimer m_since; ///< real time since the last step
    double m_rest = 0;     ///< microseconds that the last step was too short to play
    double m_speed = 1;
    bool m_loops = false;
    bool m_skipsPauses = true;

    /// Figures of one painting, kept until the painting changes.
    struct Measured {
        PaintingPtr painting;
        TimeSpan span;
        std::optional<FilmClock> film;
    };
    const TimeSpan &span() const;
    const FilmClock &film() const;
    mutable Measured m_measured;
};

} // namespace suffuse
