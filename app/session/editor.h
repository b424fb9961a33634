// One open document and what is being done with it: the part of the window that has no pixels.
#pragma once

#include "app/session/files/saved_step.h"
#include "app/session/files/saving.h"
#include "app/session/final_preview.h"
#include "app/session/later_changes.h"
#include "app/session/painting_clock.h"
#include "model/brush/brush.h"
#include "model/document/document.h"
#include "model/painting/stroke_values.h"
#include "model/result.h"
#include "undo/edit_command.h"
#include "undo/kept_history.h"

#include <QObject>
#include <QTimer>
#include <QUndoStack>

namespace suffuse {

/// Holds document, undo stack, clock, file and brush; panels and tools talk to it, never to each other.
class Editor : public QObject {
    Q_OBJECT

public:
    explicit Editor(QObject *parent = nullptr);
    ~Editor() override;

    Document &document() { return m_document; }
    QUndoStack &undoStack() { return m_undoStack; }
    /// The document's changes for whoever only shows them, panels above all.
    LaterChanges &laterChanges() { return m_laterChanges; }

    /// Pushes an edit under a translated name; an empty edit is ignored. Edits of one run (a drag) become one step.
    /// What comes to nothing, at once or when a run is back at its start, leaves the steps to be redone as they were.
    void push(Edit edit, const QString &text, EditRun run = 0);
    /// Takes a run back, if it is the last that was done: the painting and the steps, those to be redone too, are as
    /// they were before it.
    void giveUp(EditRun run);

    /// What the next stroke is painted with; its colour is the current colour.
    const Brush &brush() const { return m_brush; }
    void setBrush(const Brush &brush);
    void setColour(const Colour &colour);

    /// The moment that is looked at.
    PaintingClock &clock() { return m_clock; }
    const PaintingClock &clock() const { return m_clock; }

    /// A run of edits is coming in (a value is being dragged): frames may be quick ones. Over when button, pen or key is
    /// let go, and a moment after the last edit.
    bool isDragging() const { return m_dragEnd.isActive(); }
    /// It goes on, though its edit is not pushed yet.
    void keepDragging();

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
    /// What is here differs from what is on disk, undo steps that are to be kept or left out included. Also while it is
    /// being saved.
    bool isModified() const;
    /// Where a painting that has no file of its own came from: a name to begin with when it is saved. May be empty.
    const QString &suggestedPath() const { return m_suggestedPath; }
    /// SHA-256 of the file as it was last read or written; empty: untitled.
    const QByteArray &fileHash() const { return m_fileHash; }

    /// What a new painting has where nothing else is asked for: a sheet of grainy paper.
    static Canvas usualCanvas();
    void newPainting(const Canvas &canvas);
    /// Formats that cannot be saved (recordings) open untitled. So does a damaged file, modified, with what is whole of
    /// it; returns what is lost.
    Result<std::vector<QString>> open(const QString &path);
    /// A painting that is in no file: untitled but for its name, modified.
    void openRecovered(Painting painting, const QString &name, const QString &suggestedPath);

    /// Writes the painting as it is now, on a thread of its own; it can be painted on. `saved` tells how it went.
    /// Unless `whatever` is there may be replaced, the document's own file must be as it was last read or written.
    void startSaving(const QString &path, bool whatever = false);
    /// Writes a copy of it elsewhere: the painting keeps its file, and what is to be saved to it.
    void startSavingCopy(const QString &path);
    bool isSaving() const { return m_saver.isBusy(); }
    /// Puts another state of the painting in place of this one: a step, which Undo takes back. Its end is looked at.
    void restore(const Painting &state, const QString &text);
    /// Restores what the file holds. Fails, and changes nothing, where it cannot be read or is damaged.
    Result<void> revert();
    /// What is beside the picture in the file.
    DocumentExtras &extras() { return m_extras; }
    /// Undo steps go into the file, so that whoever opens it goes on undoing.
    bool keepsHistory() const { return m_keepsHistory; }
    void setKeepsHistory(bool keeps);
    /// What they take in the file as it was last read or written, bytes.
    qint64 historyBytes() const { return m_historyBytes; }
    /// Empty, or what of the file that was opened last was left out: its steps, or what a painting cannot hold.
    const QString &leftOut() const { return m_leftOut; }
    /// The file on disk is another one now, and what is here is to stay: modified, and the next save replaces that one.
    void keepMine(const QByteArray &hashOnDisk);

signals:
    void brushChanged();
    void dragEnded();       ///< exact frames again
    void comparedChanged(); ///< something else is shown: the compared painting, or what is wet as it will look
    void fileChanged();     ///< path or modified state
    void opened();          ///< another painting is there, with its path and modified state
    void edited();          ///< an edit was finished, undone or redone: not while a value is being dragged
    void saved(const suffuse::SaveOutcome &outcome);

protected:
    /// While a value is dragged: of the whole program.
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void endDrag();
    /// The steps that a run has dropped, if it has come to nothing.
    void putBackUndone();
    void noteDrawn(const Edit &edit);
    PaintingPtr snapshotInTime() const;
    /// `name`: of an untitled one. Modified: it is in no file.
    struct Origin {
        QString path, name, suggestedPath;
        QByteArray hash;
        bool modified = false;
    };
    void show(PaintingPtr painting, const Origin &origin);
    void noteChange(const Change &change);
    void noteSaved(const SaveOutcome &outcome);
    SaveOrder orderFor(const QString &path);
    void tellFileChanged();
    void takeUpHistory(const QByteArray &bytes, bool modified);

    Document m_document;
    LaterChanges m_laterChanges{m_document};
    QUndoStack m_undoStack;
    SavedStep m_savedStep{m_undoStack};
    bool m_wasModified = false; ///< when it was told last
    quint64 m_lastSave = 0;     ///< number of the last save
    UndoneSteps m_undone; ///< while a run may come to nothing
    PaintingClock m_clock;
    StrokeValues<Microseconds> m_driesAt;
    PaintingPtr m_compared; ///< null: none
    QTimer m_dragEnd;
    Brush m_brush;
    QString m_filePath;
    QString m_untitledName; ///< empty: "Untitled"
    QString m_suggestedPath;
    QByteArray m_fileHash;
    DocumentExtras m_extras; ///< but for the history, which is on the undo stack
    bool m_keepsHistory = false;
    bool m_historyIsSaved = false; ///< the file was last read or written with it
    qint64 m_historyBytes = 0;
    QString m_leftOut;
    Saver m_saver;
    bool m_pushingRun = false;
    bool m_unfinished = false; ///< edits of a run that `edited` has not told of
    bool m_finalShown = false;
    mutable FinalPreview m_finalPreview;
};

} // namespace suffuse
