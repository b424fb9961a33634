#include "app/window/files/file_restoring.h"

#include "app/canvas/canvas_widget.h"
#include "app/dialogs/backups_dialog.h"
#include "app/session/commands/commands.h"
#include "app/session/open_painting.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/habits/at_next_change.h"
#include "app/window/files/file_saving.h"

#include <QDateTime>
#include <QFileInfo>
#include <QMainWindow>
#include <QStatusBar>

namespace suffuse {

FileRestoring::FileRestoring(const Workplace &place, FileSaving &saving, QObject *parent)
    : QObject(parent), m_place(place), m_saving(saving)
{
    using enum Command;
    const auto hasFile = [&editor = place.open.editor] { return !editor.filePath().isEmpty(); };
    place.commands
        .add(Revert, "revert", Commands::tr("Re&vert…"), "", {},
             Commands::tr("Back to what the file holds; Undo takes it back"))
        .when(hasFile, Commands::tr("The painting has no file yet: save it first."))
        .runs([this] { revert(); });
    place.commands
        .add(RestoreBackup, "restoreBackup", Commands::tr("Restore &Backup…"), "", {},
             Commands::tr("Back to an earlier version of the file"))
        .when(hasFile, Commands::tr("The painting has no file yet: save it first."))
        .runs([this] { chooseBackup(); });
}

void FileRestoring::giveUpWhatIsInHand()
{
    m_place.canvas.settleTool(); // Undo brings it back.
    if (Tool *tool = m_place.canvas.tool(); tool->isBusy())
        tool->cancel();
}

void FileRestoring::revert()
{
    Editor &editor = m_place.open.editor;
    giveUpWhatIsInHand();
    if (editor.isSaving())
        m_saving.waitForSaving();
    if (editor.isModified() &&
        !confirm(&m_place.window, tr("Revert “%1” to what the file holds?").arg(editor.displayName()),
                 tr("What was painted since the last save goes; Undo brings it back."), tr("&Revert")))
        return;
    if (const Result<void> reverted = editor.revert(); !reverted)
        showError(&m_place.window, reverted.error());
    m_saving.watchFile();
}

void FileRestoring::chooseBackup()
{
    BackupsDialog dialog(m_place.open.editor.filePath(), &m_place.window);
    if (dialog.exec() == QDialog::Accepted && !dialog.chosen().isEmpty())
        restoreFrom(dialog.chosen());
}

void FileRestoring::restoreFrom(const QString &backup)
{
    Editor &editor = m_place.open.editor;
    giveUpWhatIsInHand();
    const Result<LoadedDocument> document = loadDocument(backup);
    if (!document) {
        showError(&m_place.window, document.error());
        return;
    }
    const QString when = m_place.window.locale().toString(QFileInfo(backup).lastModified(), QLocale::ShortFormat);
    if (*editor.document().painting() == document->painting) {
        sayUntilChange(*m_place.window.statusBar(), editor.document(),
                       tr("The backup of %1 is what you see: nothing has changed.").arg(when));
        return;
    }
    editor.restore(document->painting, tr("Restore backup of %1").arg(when));
    sayUntilChange(*m_place.window.statusBar(), editor.document(),
                   tr("The backup of %1 is back. Undo takes it away again; no file changes until you save.").arg(when));
    if (!document->losses.empty())
        showNotice(&m_place.window, tr("The backup is damaged. What is whole of it was restored."),
                   QStringList(document->losses.begin(), document->losses.end()).join('\n'));
}

} // namespace suffuse
