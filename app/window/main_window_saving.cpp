// Saving while the painting goes on, and other programs that write to the same file.
#include "app/canvas/canvas_widget.h"
#include "app/dialogs/backups_dialog.h"
#include "app/session/files/journal.h"
#include "app/session/files/saving_watch.h"
#include "app/session/settings/settings.h"
#include "app/widgets/at_next_change.h"
#include "app/widgets/messages.h"
#include "app/window/main_window.h"
#include "app/window/workspace_view.h"

#include <QDateTime>
#include <QDir>
#include <QEventLoop>
#include <QFileInfo>
#include <QProgressDialog>
#include <QStatusBar>
#include <QTimer>

namespace suffuse {

namespace {

constexpr int quietMs = 300; ///< of waiting before it is said
constexpr int shownMs = 6'000;
constexpr int saveLaterMs = 500;

} // namespace

void MainWindow::addSavingRows()
{
    using enum Command;
    const auto hasFile = [this] { return !m_editor.filePath().isEmpty(); };
    m_commands->add(Save, "save", Commands::tr("&Save"), "save", QKeySequence::keyBindings(QKeySequence::Save))
        .runs([this] { startSaving(); });
    m_commands->add(SaveAs, "saveAs", Commands::tr("Save &As…"), "", {QKeySequence(Commands::tr("Ctrl+Shift+S"))})
        .runs([this] { startSavingAs(); });
    m_commands
        ->add(SaveCopy, "saveCopy", Commands::tr("Save a Cop&y…"), "", {QKeySequence(Commands::tr("Ctrl+Alt+Shift+S"))},
              Commands::tr("Into another file; you go on painting in this one"))
        .runs([this] { startSavingCopy(); });
    m_commands
        ->add(Revert, "revert", Commands::tr("Re&vert…"), "", {},
              Commands::tr("Back to what the file holds; Undo takes it back"))
        .when(hasFile)
        .runs([this] { revert(); });
    m_commands
        ->add(RestoreBackup, "restoreBackup", Commands::tr("Restore &Backup…"), "", {},
              Commands::tr("Back to an earlier version of the file"))
        .when(hasFile)
        .runs([this] { restoreBackup(); });
}

void MainWindow::connectSaving()
{
    connect(m_journal, &Journal::failed, this, [this](const QString &message) {
        showNotice(this,
                   tr("What you paint now would not survive a crash: %1. Painting goes on; save from time to time.")
                       .arg(message));
    });
    m_watch = new FileWatch(this);
    watchFile();
    connect(&m_editor, &Editor::opened, this, &MainWindow::watchFile);
    connect(&m_editor, &Editor::saved, this, [this](const SaveOutcome &outcome) {
        if (outcome.isSaved())
            watchFile();
    });
    connect(&m_editor, &Editor::saved, this, &MainWindow::showOutcome);
    connect(m_watch, &FileWatch::changed, this, &MainWindow::fileChangedOutside);
    connect(m_watch, &FileWatch::removed, this, [this] {
        if (m_editor.isSaving())
            return;
        m_editor.keepMine({});
        statusBar()->showMessage(tr("“%1” is gone from its folder. Save to put it back.").arg(m_editor.displayName()));
    });
}

bool MainWindow::startSaving()
{
    if (m_editor.filePath().isEmpty())
        return startSavingAs();
    startSavingTo(m_editor.filePath());
    return true;
}

bool MainWindow::startSavingAs()
{
    QString proposal = m_editor.suggestedPath();
    if (proposal.isEmpty()) {
        const QString recent = settings::recentFiles().value(0);
        proposal = m_editor.displayName() + ".suffuse";
        if (!recent.isEmpty())
            proposal = QFileInfo(recent).dir().filePath(proposal);
    }
    const QString path = askForFile(tr("Save As"), proposal);
    if (path.isEmpty())
        return false;
    startSavingTo(path, true); // it was asked whether it may be replaced
    return true;
}

void MainWindow::startSavingCopy()
{
    const QFileInfo origin(m_editor.suggestedPath().isEmpty() ? m_editor.displayName() + ".suffuse"
                                                              : m_editor.suggestedPath());
    //: name of the file that a copy is saved to, beside that of the painting
    QString proposal = tr("%1 copy").arg(origin.completeBaseName()) + '.' + origin.suffix();
    if (!m_editor.suggestedPath().isEmpty())
        proposal = origin.dir().filePath(proposal);
    const QString path = askForFile(tr("Save a Copy"), proposal);
    if (path.isEmpty())
        return;
    const QString own = QFileInfo(m_editor.filePath()).canonicalFilePath();
    if (!own.isEmpty() && QFileInfo(path).canonicalFilePath() == own) {
        startSavingTo(path, true); // then it is no copy
        return;
    }
    m_editor.extras().view = workspaceOf(*m_canvas, m_editor);
    m_editor.startSavingCopy(path);
}

void MainWindow::startSavingTo(const QString &path, bool whatever)
{
    m_savingWorked = true;
    m_editor.extras().view = workspaceOf(*m_canvas, m_editor);
    m_editor.startSaving(path, whatever);
    statusBar()->showMessage(tr("Saving “%1”…").arg(QFileInfo(path).fileName()));
}

bool MainWindow::waitForSaving()
{
    QProgressDialog box(tr("Saving “%1”…").arg(m_editor.displayName()), QString(), 0, 0, this);
    box.setWindowTitle(QStringLiteral("Suffuse"));
    box.setWindowModality(Qt::WindowModal);
    box.reset(); // it would come by itself
    QTimer quiet;
    quiet.setSingleShot(true);
    connect(&quiet, &QTimer::timeout, &box, &QWidget::show);
    quiet.start(quietMs);
    connect(&m_editor, &Editor::fileChanged, &box, [&] { // before anything is asked
        if (m_editor.isSaving())
            return;
        quiet.stop();
        box.hide();
    });
    while (m_editor.isSaving()) {
        QEventLoop loop;
        connect(&m_editor, &Editor::saved, &loop, &QEventLoop::quit);
        loop.exec(QEventLoop::ExcludeUserInputEvents); // the answer to a question has its own loop
    }
    return m_savingWorked;
}

bool MainWindow::save()
{
    return startSaving() && waitForSaving();
}

bool MainWindow::saveTo(const QString &path)
{
    startSavingTo(path);
    return waitForSaving();
}

void MainWindow::showOutcome(const SaveOutcome &outcome)
{
    const QString name = QFileInfo(outcome.path).fileName();
    if (outcome.isCopy) {
        if (outcome.isSaved())
            statusBar()->showMessage(tr("A copy is saved as “%1”.").arg(name), shownMs);
        else if (askAfterFailedSave(this, outcome.message))
            startSavingCopy();
        return;
    }
    m_savingWorked = outcome.isSaved();
    if (outcome.wasThere) {
        sayUntilChange(*statusBar(), m_editor.document(), tr("“%1” is saved already.").arg(name), shownMs);
        return;
    }
    if (outcome.isSaved()) {
        settings::addRecentFile(outcome.path);
        statusBar()->showMessage(outcome.message.isEmpty()
                                     ? tr("Saved “%1”, %2").arg(name, locale().formattedDataSize(outcome.bytes))
                                     : tr("Saved “%1”, but %2").arg(name, outcome.message),
                                 shownMs);
        return;
    }
    statusBar()->showMessage(tr("“%1” is not saved.").arg(name), shownMs);
    if (outcome.kind == SaveOutcome::Kind::ChangedOutside) {
        m_watch->watch(m_editor.filePath(), outcome.hash); // it is asked about here
        m_asking = true;
        const ConflictAnswer answer = askAboutConflict(this, name, true, true);
        m_asking = false;
        if (answer == ConflictAnswer::KeepMine)
            startSavingTo(outcome.path, true);
        else
            answerConflict(answer, outcome.hash);
    } else if (askAfterFailedSave(this, outcome.message)) {
        startSavingAs();
    }
}

void MainWindow::fileChangedOutside(const QByteArray &hash)
{
    if (m_asking || m_editor.isSaving() || hash == m_editor.fileHash())
        return;                                           // saving looks for itself
    if (m_canvas->tool() && m_canvas->tool()->isBusy()) { // not in the middle of a stroke
        QTimer::singleShot(saveLaterMs, this, [this, hash] { fileChangedOutside(hash); });
        return;
    }
    m_asking = true;
    const ConflictAnswer answer = askAboutConflict(this, m_editor.displayName(), m_editor.isModified(), false);
    m_asking = false;
    answerConflict(answer, hash);
}

void MainWindow::answerConflict(ConflictAnswer answer, const QByteArray &hash)
{
    switch (answer) {
    case ConflictAnswer::KeepMine:
        m_editor.keepMine(hash);
        break;
    case ConflictAnswer::Reload:
        if (const Result<void> reverted = m_editor.revert(); !reverted) {
            m_editor.keepMine(hash);
            showError(this, reverted.error());
        }
        watchFile();
        break;
    case ConflictAnswer::SaveAs:
        m_editor.keepMine(hash);
        startSavingAs();
        break;
    case ConflictAnswer::Cancel:
        break;
    }
}

void MainWindow::watchFile()
{
    m_watch->watch(m_editor.filePath(), m_editor.fileHash());
}

void MainWindow::revert()
{
    if (m_canvas->tool()->isBusy())
        m_canvas->tool()->cancel();
    if (m_editor.isSaving())
        waitForSaving();
    if (m_editor.isModified() &&
        !confirm(this, tr("Revert “%1” to what the file holds?").arg(m_editor.displayName()),
                 tr("What was painted since the last save goes; Undo brings it back."), tr("&Revert")))
        return;
    if (const Result<void> reverted = m_editor.revert(); !reverted)
        showError(this, reverted.error());
    watchFile();
}

void MainWindow::restoreBackup()
{
    BackupsDialog dialog(m_editor.filePath(), this);
    if (dialog.exec() == QDialog::Accepted && !dialog.chosen().isEmpty())
        restoreFrom(dialog.chosen());
}

void MainWindow::restoreFrom(const QString &backup)
{
    if (m_canvas->tool()->isBusy())
        m_canvas->tool()->cancel();
    const Result<LoadedDocument> document = loadDocument(backup);
    if (!document) {
        showError(this, document.error());
        return;
    }
    const QString when = locale().toString(QFileInfo(backup).lastModified(), QLocale::ShortFormat);
    m_editor.restore(document->painting, tr("Restore backup of %1").arg(when));
    sayUntilChange(*statusBar(), m_editor.document(),
                   tr("The backup of %1 is back. Undo takes it away again; no file changes until you save.").arg(when));
    if (!document->losses.empty())
        showNotice(this, tr("The backup is damaged. What is whole of it was restored."),
                   QStringList(document->losses.begin(), document->losses.end()).join('\n'));
}

} // namespace suffuse
