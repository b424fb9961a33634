// Saving while the painting goes on, and other programs that write to the same file.
#pragma once

#include "app/session/files/saving.h"
#include "app/widgets/asking/save_name.h"
#include "app/window/workplace.h"

#include <QObject>

namespace suffuse {

class Editor;
class FileWatch;
enum class ConflictAnswer;

/// Saves a window's painting where its user wants it, says how it went, and asks about what another program has done to
/// its file.
class FileSaving : public QObject {
    Q_OBJECT

public:
    FileSaving(const Workplace &place, QObject *parent);

    QMainWindow &window() const { return m_window; }
    /// That of the window which shows this file, by whatever name and links it was opened; null: none does.
    static FileSaving *of(const QString &path);

    /// Saves and waits until it is on disk. False if it failed or was given up.
    bool save();
    /// Writes to the path, shows what went wrong, and waits until it is on disk.
    bool saveTo(const QString &path);
    /// False if the last attempt failed.
    bool waitForSaving();
    /// True if the painting may go: saved, discarded or never changed.
    bool maySwitch();
    /// What the file holds now is what was read or written here.
    void watchFile();

private:
    void addRows(Commands &table);
    QString withDraft(const QString &said) const;
    /// Starts to save, where it is to go; the user goes on painting. False if that was given up.
    bool startSaving();
    bool startSavingAs();
    void startSavingCopy();
    void startSavingTo(const QString &path, bool whatever = false);
    /// A file to save to that is open in no other window; empty: given up.
    QString askForFile(const QString &title, const QString &proposal, const QList<FileKind> &more = {});
    void writeDrawing(const QString &path);
    void showOutcome(const SaveOutcome &outcome);
    void fileChangedOutside(const QByteArray &hash);
    void answerConflict(ConflictAnswer answer, const QByteArray &hash);

    QMainWindow &m_window;
    Editor &m_editor;
    CanvasWidget &m_canvas;
    FileWatch *m_watch;
    bool m_savingWorked = true; ///< the last attempt
    bool m_leavesDraft = false; ///< something is in hand that was not saved with the rest
    bool m_asking = false;      ///< about a file that another program changed
};

} // namespace suffuse
