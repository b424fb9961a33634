// Changes the brush's size and opacity, by steps and by dragging over the canvas.
#pragma once

#include "model/brush/brush.h"
#include "model/geometry/geometry.h"

#include <QBasicTimer>
#include <QObject>

#include <optional>

namespace suffuse {

class Editor;

/// A drag across changes the size, and a drag upwards the opacity. For a while a note says what the brush has now.
class BrushSizing : public QObject {
    Q_OBJECT

public:
    explicit BrushSizing(Editor &editor) : m_editor(editor) {}

    bool isActive() const { return m_drag.has_value(); }
    /// Starts a drag at a pixel of the canvas (device pixels).
    void begin(Point pixel);
    /// Goes on with the drag; `pixel` is in device pixels, of which `dpr` are a logical one.
    void moveTo(Point pixel, double dpr);
    /// Ends the drag; the brush keeps what it has now.
    void end();
    /// Gives the drag up: the brush is again what it was before.
    void giveUp();

    /// Makes the brush larger (positive) or smaller by steps of a fourth of an octave.
    void stepSize(int steps);
    /// Raises (positive) or lowers the opacity by steps.
    void stepOpacity(int steps);

    /// What is said beside the pointer; empty where nothing is.
    const QString &note() const { return m_note; }

signals:
    void noteChanged();

protected:
    void timerEvent(QTimerEvent *event) override;

private:
    /// A drag, which always counts from the brush that there was at its beginning.
    struct Drag {
        Brush brush;
        Point pixel;
        enum { Undecided, Size, Opacity } what = Undecided;
    };

    void scaleSize(double factor);
    void addOpacity(double difference);
    void showNote(const QString &note, bool stays);

    Editor &m_editor;
    std::optional<Drag> m_drag;
    QString m_note;
    QBasicTimer m_noteTimer;
};

} // namespace suffuse
