// One open document and what is being done with it: the part of the window that has no pixels.
#pragma once

#include "app/session/files/saved_step.h"
#include "app/session/files/saving.h"
#include "app/session/final_preview.h"
#include "app/session/gesture.h"
#include "app/session/gesture_desk.h"
#include "app/session/later_changes.h"
#include "app/session/painting_clock.h"
#include "app/session/value_entry.h"
#include "model/brush/brush.h"
#include "model/document/document.h"
#include "model/painting/stroke_values.h"
#include "model/result.h"
#include "undo/history/edit_command.h"
#include "undo/history/kept_history.h"

#include <QElapsedTimer>
#include <QObject>
#include <QUndoStack>

#include <memory>

namespace suffuse {

class ColourTarget;
class CurrentLayer;
class DrawingAids;
class TextLayout;
struct OpenedFile;

/// Holds document, undo stack, clock, file and brush; panels and tools talk to it, never to each other.
class Editor : public QObject {
    Q_OBJECT

public:
    explicit Editor(QObject *parent = nullptr);
    ~Editor() override;

    /// The document, as it is shown: what floats over it is put into it first. Whoever is being told of a change finds
    /// the document as it was changed: another change would follow else, and another.
    Document &document()
    {
        if (!m_laterChanges.isTelling())
            settle();
        return m_document;
    }
    /// Puts what floats into the document.
    void settle() { m_gestures.settle(); }
    /// The document, which may lack what floats over it. For whoever paints what floats, above all; what is selected is
    /// always right.
    const Document &unsettled() const { return m_document; }
    const Selection &selection() const { return m_document.selection(); }
    /// Of steps. `undo` and `redo` of this class commit an open gesture; the stack's own have it given up.
    QUndoStack &undoStack() { return m_undoStack; }
    /// The document's changes for whoever only shows them, panels above all.
    LaterChanges &laterChanges() { return m_laterChanges; }

    /// Does an edit, as a step with a translated name; an empty edit is ignored. What changes nothing is no step, and
    /// leaves the steps to be redone as they were. With an entry it is part of the entry's drag, or goes on with its
    /// step.
    void push(Edit edit, const QString &text, ValueEntry *entry = nullptr);
    /// Call it before an edit of a gesture that brings new paint; `push` does it by itself. Where that dries after all
    /// that there is, the clock forgets what was undone.
    void noteComing(const Edit &edit);
    /// Begins something that is not decided yet; `name` is its step's, translated. What was open is committed.
    /// With `steps`, which must outlive it, undo and redo go through the changes within it first.
    Gesture begin(const QString &name, GestureSteps *steps = nullptr);
    /// Whatever is open becomes a step.
    void commit() { m_gestures.commit(); }
    /// A gesture is open and in the hand: frames may be quick ones.
    bool isDragging() const { return m_gestures.isMoving(); }
    /// The hand does not move any more, though a gesture is open.
    void rest() { m_gestures.rest(); }
    /// A step has gone on a moment ago: a key is held down, or a wheel is turned.
    bool isStepping() const;
    /// The way back from what is shown and in no step yet; null: nothing is.
    const Edit *undecided() const { return m_gestures.undecided(); }

    /// An open gesture is a step for these.
    bool canUndo() const { return undecided() || m_undoStack.canUndo(); }
    bool canRedo() const { return stepsInHand(false) || (!undecided() && m_undoStack.canRedo()); }
    QString undoText() const;
    QString redoText() const;
    void undo();
    void redo();

    /// Who shows strokes afloat; null: nobody.
    void setFloatingView(FloatingView *view) { m_gestures.setFloatingView(view); }
    FloatingView *floatingView() const { return m_gestures.floatingView(); }

    /// What the next stroke is painted with; its colour is the current colour.
    const Brush &brush() const { return m_brush; }
    void setBrush(const Brush &brush);
    void setColour(const Colour &colour);
    /// Whose colour the colour dock changes: the brush's, or that of what is selected.
    ColourTarget &colourTarget() { return *m_colourTarget; }

    /// The group that what is painted goes into.
    CurrentLayer &layer() { return *m_layer; }
    const CurrentLayer &layer() const { return *m_layer; }

    /// Symmetry, guides and assistants.
    DrawingAids &aids() { return *m_aids; }
    const DrawingAids &aids() const { return *m_aids; }

    /// The moment that is looked at.
    PaintingClock &clock() { return m_clock; }
    const PaintingClock &clock() const { return m_clock; }

    /// Shows another painting instead of the document's until the document changes or null is set: a look back, in no
    /// undo step.
    void setCompared(PaintingPtr painting);
    const PaintingPtr &compared() const { return m_compared; }
    /// Shows what is wet as it will look when it has dried.
    void setFinalShown(bool shown);
    bool isFinalShown() const { return m_finalShown; }
    /// What the canvas shows: the compared painting, else the document's snapshot, the stroke in hand in its place.
    PaintingPtr shown();
    /// The same, which may lack what floats.
    PaintingPtr unsettledShown() const;

    const QString &filePath() const { return m_filePath; } ///< empty: untitled
    /// Title without the program's name: file name or "Untitled", translated.
    QString displayName() const;
    /// The name without what the program adds to it in its language; empty: untitled. Journals keep it.
    QString ownName() const;
    /// What is here differs from what is on disk, undo steps that are to be kept or left out included. Also while it is
    /// being saved.
    bool isModified() const;
    /// Where a painting that has no file of its own came from: a name to begin with when it is saved. May be empty.
    const QString &suggestedPath() const { return m_suggestedPath; }
    /// SHA-256 of the file as it was last read or written; empty: untitled.
    const QByteArray &fileHash() const { return m_fileHash; }

    /// What a new painting has where nothing else is asked for: a sheet of grainy paper.
    static Canvas usualCanvas();
    /// `resolution`: canvas units an inch of paper; 0: it is not said.
    void newPainting(const Canvas &canvas, double resolution = 0);
    /// Shows what was read of a file. Formats that cannot be saved (recordings) open untitled, and so do samples. So
    /// does a damaged file, modified, with what is whole of it; returns what is lost.
    std::vector<QString> open(OpenedFile file);
    /// Reads it first; one that cannot be read changes nothing.
    Result<std::vector<QString>> open(const QString &path);
    /// A painting that is in no file: untitled but for its name, modified.
    void openRecovered(Painting painting, const QString &name, const QString &suggestedPath, double resolution = 0);

    /// Writes the painting as it is now, on a thread of its own; it can be painted on. `saved` tells how it went.
    /// Unless `whatever` is there may be replaced, the document's own file must be as it was last read or written.
    void startSaving(const QString &path, bool whatever = false);
    /// Writes a copy of it elsewhere: the painting keeps its file, and what is to be saved to it.
    void startSavingCopy(const QString &path);
    bool isSaving() const { return m_saver.isBusy(); }
    /// Puts another state of the painting in place of this one: a step, which Undo takes back. Its end is looked at.
    void restore(const Painting &loaded, const QString &text);
    /// Restores what the file holds. Fails, and changes nothing, where it cannot be read or is damaged.
    Result<void> revert();
    /// What is beside the picture in the file.
    DocumentExtras &extras() { return m_extras; }
    const DocumentExtras &extras() const { return m_extras; }
    /// Canvas units an inch of paper; the usual number where the painting says none.
    double resolution() const;
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
    void dragEnded();       ///< `isDragging` is over: exact frames again
    void comparedChanged(); ///< something else is shown: the compared painting, or what is wet as it will look
    void fileChanged();     ///< path or modified state
    void opened();          ///< another painting is there, with its path, hash and modified state
    void edited();          ///< steps were done, undone or redone, or a gesture rests
    void saved(const suffuse::SaveOutcome &outcome);

private:
    /// The open gesture's own changes, where they can be gone through; null: there are none.
    GestureSteps *stepsInHand(bool back) const;
    void commitChanges();
    Edit placed(Edit edit);
    void pushDone(Edit back, const QString &text);
    bool goesOn(const ValueEntry &entry) const;
    void followStack();
    void followDocument(const Change &change);
    void tellModified();
    void noteDrawn(const Edit &edit);
    PaintingPtr snapshotInTime() const;
    /// `name`: of an untitled one. Modified: it is in no file.
    struct Origin {
        QString path, name, suggestedPath;
        QByteArray hash;
        QString leftOut;
        bool modified = false;
        bool recovered = false;
    };
    void show(PaintingPtr painting, const Origin &origin);
    void noteSaved(const SaveOutcome &outcome);
    SaveOrder orderFor(const QString &path);
    void tellFileChanged();
    void takeUpHistory(const QByteArray &bytes, bool modified);

    Document m_document;
    GestureDesk m_gestures{m_document,
                           {[this](Edit edit) { return placed(std::move(edit)); },
                            [this](Edit back, const QString &name) { pushDone(std::move(back), name); }}};
    LaterChanges m_laterChanges{m_document};
    QUndoStack m_undoStack;
    SavedStep m_savedStep{m_undoStack};
    bool m_wasModified = false;  ///< when it was told last
    quint64 m_lastSave = 0;      ///< number of the last save
    bool m_takesUpSteps = false; ///< of a file, or lets go those of one: nothing is done
    QElapsedTimer m_sinceStep;   ///< since one went on
    quint64 m_selection = 0;     ///< counts selections
    PaintingClock m_clock;
    StrokeValues<Microseconds> m_driesAt;
    PaintingPtr m_compared; ///< null: none
    Brush m_brush;
    std::unique_ptr<ColourTarget> m_colourTarget;
    std::unique_ptr<CurrentLayer> m_layer;
    std::unique_ptr<DrawingAids> m_aids;
    std::unique_ptr<TextLayout> m_layout; ///< for texts that follow strokes
    QString m_filePath;
    QString m_untitledName; ///< empty: "Untitled"
    bool m_isRecovered = false;
    QString m_suggestedPath;
    QByteArray m_fileHash;
    DocumentExtras m_extras; ///< but for the history, which is on the undo stack
    bool m_keepsHistory = false;
    bool m_historyIsSaved = false; ///< the file was last read or written with it
    qint64 m_historyBytes = 0;
    QString m_leftOut;
    Saver m_saver;
    bool m_finalShown = false;
    mutable FinalPreview m_finalPreview;
};

} // namespace suffuse
