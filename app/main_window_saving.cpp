// Saving while the painting goes on, and other programs that write to the same file.
#include "app/canvas/canvas_widget.h"
#include "app/journal.h"
#include "app/main_window.h"
#include "app/messages.h"
#include "app/saving_watch.h"
#include "app/settings.h"
#include "app/workspace_view.h"

#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QProgressDialog>
#include <QStatusBar>
#include <QTimer>

namespace suffuse {

namespace {

constexpr int quietMs = 300; ///< of waiting before it is said
constexpr int shownMs = 6'000;
constexpr int laterMs = 500;

} // namespace

void MainWindow::connectSaving()
{
    m_journal = new Journal(m_editor, this);
    connect(m_journal, &Journal::failed, this, [this](const QString &message) {
        showNotice(this,
                   tr("What you paint now would not survive a crash: %1. Painting goes on; save from time to time.")
                       .arg(message));
    });
    m_watch = new FileWatch(this);
    const auto follow = [this] { m_watch->watch(m_editor.filePath(), m_editor.fileHash()); };
    connect(&m_editor, &Editor::opened, m_watch, follow);
    connect(&m_editor, &Editor::saved, m_watch, [follow](const SaveOutcome &outcome) {
        if (outcome.isSaved())
            follow();
    });
    connect(&m_editor, &Editor::saved, this, &MainWindow::showOutcome);
    QAction &keepHistory = action(Command::KeepHistory);
    connect(&keepHistory, &QAction::triggered, &m_editor, &Editor::setKeepsHistory);
    connect(&m_editor, &Editor::fileChanged, this, [this, &keepHistory] {
        const qint64 bytes = m_editor.historyBytes();
        keepHistory.setChecked(m_editor.keepsHistory());
        keepHistory.setText(bytes > 0 ? tr("Keep Undo &History in the File (%1)").arg(locale().formattedDataSize(bytes))
                                      : tr("Keep Undo &History in the File"));
    });
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
    const QString origin =
        m_editor.suggestedPath().isEmpty() ? settings::recentFiles().value(0) : m_editor.suggestedPath();
    QFileDialog dialog(this, tr("Save As"), origin.isEmpty() ? QString() : QFileInfo(origin).absolutePath());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters({tr("Suffuse painting (*.suffuse)"), tr("Text form (*.json)")});
    dialog.setDefaultSuffix("suffuse");
    connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString &filter) {
        dialog.setDefaultSuffix(filter.contains("*.json") ? "json" : "suffuse");
    });
    const QString name = m_editor.suggestedPath().isEmpty() ? m_editor.displayName() + ".suffuse"
                                                            : QFileInfo(m_editor.suggestedPath()).fileName();
    if (name.endsWith(".json", Qt::CaseInsensitive))
        dialog.selectNameFilter(dialog.nameFilters().last());
    dialog.selectFile(name);
    if (dialog.exec() != QDialog::Accepted)
        return false;
    startSavingTo(dialog.selectedFiles().value(0), true); // the dialog has asked whether it may be replaced
    return true;
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
    m_savingWorked = outcome.isSaved();
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
        QTimer::singleShot(laterMs, this, [this, hash] { fileChangedOutside(hash); });
        return;
    }
    m_asking = true;
    const ConflictAnswer answer = askAboutConflict(this, m_editor.displayName(), m_editor.isModified(), false);
    m_asking = false;
    answerConflict(answer, hash);
}

void MainWindow::answerConflict(ConflictAnswer answer, const QByteArray &hash)
{
    const QString path = m_editor.filePath();
    switch (answer) {
    case ConflictAnswer::KeepMine:
        m_editor.keepMine(hash);
        break;
    case ConflictAnswer::Reload:
        if (const auto losses = m_editor.open(path); !losses)
            showError(this, losses.error());
        break;
    case ConflictAnswer::SaveAs:
        m_editor.keepMine(hash);
        startSavingAs();
        break;
    case ConflictAnswer::Cancel:
        break;
    }
}

} // namespace suffuse
