// The brush's size and opacity, changed by steps and by dragging over the canvas.
#pragma once

#include "model/brush/brush.h"
#include "model/painting/geometry.h"

#include <QBasicTimer>
#include <QObject>

#include <optional>

namespace suffuse {

class Editor;

/// A drag across changes the size, one upwards the opacity. What the brush has now stands in a note for a while.
class BrushSizing : public QObject {
    Q_OBJECT

public:
    explicit BrushSizing(Editor &editor) : m_editor(editor) {}

    bool isActive() const { return m_drag.has_value(); }
    void begin(Point pixel);
    /// Device pixels, and how many of them are a logical one.
    void moveTo(Point pixel, double dpr);
    void end();
    /// The brush is what it was.
    void giveUp();

    void stepSize(int steps);
    void stepOpacity(int steps);

    /// Empty: there is none.
    const QString &note() const { return m_note; }

signals:
    void noteChanged();

protected:
    void timerEvent(QTimerEvent *event) override;

private:
    /// From where the brush was.
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
