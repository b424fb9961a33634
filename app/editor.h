// One open document and what is being done with it: the part of the window that has no pixels.
#pragma once

#include "app/final_preview.h"
#include "model/brush.h"
#include "model/document.h"
#include "model/result.h"
#include "undo/edit_command.h"

#include <QBasicTimer>
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <QUndoStack>

namespace suffuse {

/// Holds document, undo stack, file, brush and painting clock; panels and tools talk to it, never to each other.
class Editor : public QObject {
    Q_OBJECT

public:
    explicit Editor(QObject *parent = nullptr);

    Document &document() { return m_document; }
    QUndoStack &undoStack() { return m_undoStack; }

    /// Pushes an edit under a translated name; an empty edit is ignored. Edits of one run (a drag) become one step.
    void push(Edit edit, const QString &text, EditRun run = 0);

    /// What the next stroke is painted with; its colour is the current colour.
    const Brush &brush() const { return m_brush; }
    void setBrush(const Brush &brush);
    void setColour(const Colour &colour);

    /// Document time T that is looked at. It runs while a stroke is drawn or something still spreads, and stands still
    /// otherwise; opening sets it to the end; undo never turns it back. In the past it stands, but for a stroke.
    Microseconds time() const;
    bool isRunning() const { return m_running; }
    /// Starts the clock (a stroke begins); it stops by itself when `holdClock` is over and all has dried.
    void holdClock(bool drawing);
    /// Looks at another moment; the clock goes on from there while something still spreads at it.
    void setTime(Microseconds time);
    /// Looks at another moment and stays there: the past. What is painted there takes its place in time and order, and
    /// the clock runs until that is dry. From the end on it is free again: the present. Does nothing while a stroke is
    /// drawn.
    void lookAt(Microseconds time);
    bool isInPast() const { return m_inPast; }
    bool isDrawing() const { return m_drawing; }
    /// With it the clock moves by `setTime` only, never by itself: for scripts and tests.
    void setManualClock(bool manual);
    bool hasManualClock() const { return m_manual; }

    /// A run of edits is coming in (a value is being dragged): frames may be quick ones. Over a moment after the last.
    bool isDragging() const { return m_dragEnd.isActive(); }

    /// Shows another painting instead of the document's until the document changes or null is set: a look back, in no
    /// undo step.
    void setCompared(PaintingPtr painting);
    const PaintingPtr &compared() const { return m_compared; }
    /// Shows what is wet as it will look when it has dried.
    void setFinalShown(bool shown);
    bool isFinalShown() const { return m_finalShown; }
    /// What the canvas shows: the compared painting, else the document's snapshot, the stroke in hand in its place.
    PaintingPtr shown() const;

    const QString &filePath() const { return m_filePath; } ///< empty: untitled
    /// Title without the program's name: file name or "Untitled", translated.
    QString displayName() const;
    bool isModified() const { return !m_undoStack.isClean(); }

    /// What a new painting has where nothing else is asked for: a sheet of grainy paper.
    static Canvas usualCanvas();
    void newPainting(const Canvas &canvas);
    /// Formats that cannot be saved (recordings) open untitled.
    Result<void> open(const QString &path);
    Result<void> save(const QString &path);

signals:
    void brushChanged();
    void timeChanged();
    void pastChanged(); ///< from present to past, or back
    void dragEnded(); ///< exact frames again
    void comparedChanged(); ///< something else is shown: the compared painting, or what is wet as it will look
    void fileChanged(); ///< path or modified state

protected:
    void timerEvent(QTimerEvent *event) override;

private:
    void tick();
    void startClock();
    void stopClock();
    void setInPast(bool past);
    /// When the clock stops.
    Microseconds runsUntil() const { return m_inPast ? m_dryAt : m_end; }
    void noteDrawn(const Edit &edit);
    PaintingPtr snapshotInTime() const;
    void show(PaintingPtr painting, const QString &path);

    Document m_document;
    QUndoStack m_undoStack;
    PaintingPtr m_compared; ///< null: none
    QTimer m_dragEnd;
    Brush m_brush;
    QString m_filePath;
    Microseconds m_time = 0;        ///< when the clock last stood
    Microseconds m_end = 0;         ///< when all has dried
    QElapsedTimer m_since;          ///< real time since then, while it runs
    bool m_running = false;
    bool m_drawing = false;
    bool m_manual = false;
    bool m_inPast = false;
    Microseconds m_drawnSince = 0; ///< when the last stroke was begun
    Microseconds m_dryAt = 0;      ///< when what was painted in the past has dried
    bool m_finalShown = false;
    mutable FinalPreview m_finalPreview;
    QBasicTimer m_timer;
};

} // namespace suffuse
