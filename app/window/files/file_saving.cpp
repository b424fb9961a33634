#include "app/window/files/file_saving.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/commands/commands.h"
#include "app/session/files/saving_watch.h"
#include "app/session/files/svg_strokes.h"
#include "app/session/open_painting.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/habits/at_next_change.h"
#include "app/window/files/save_place.h"
#include "app/window/layout/workspace_view.h"
#include "model/formats/files.h"
#include "model/formats/messages.h"

#include <QApplication>
#include <QEventLoop>
#include <QFileInfo>
#include <QMainWindow>
#include <QProgressDialog>
#include <QStatusBar>
#include <QTimer>
#include <QWindow>

namespace suffuse {

namespace {

constexpr int quietMs = 300; ///< of waiting before it is said
constexpr int shownMs = 6'000;
constexpr int saveLaterMs = 500;

} // namespace

FileSaving::FileSaving(const Workplace &place, QObject *parent)
    : QObject(parent), m_window(place.window), m_editor(place.open.editor), m_canvas(place.canvas),
      m_watch(new FileWatch(this))
{
    addRows(place.commands);
    connect(&place.open.journal, &Journal::failed, this, [this](const QString &message) {
        showNotice(&m_window,
                   tr("What you paint now would not survive a crash: %1. Painting goes on; save from time to time.")
                       .arg(message));
    });
    watchFile();
    connect(&m_editor, &Editor::opened, this, &FileSaving::watchFile);
    connect(&m_editor, &Editor::saved, this, [this](const SaveOutcome &outcome) {
        if (outcome.isSaved())
            watchFile();
    });
    connect(&m_editor, &Editor::saved, this, &FileSaving::showOutcome);
    connect(m_watch, &FileWatch::changed, this, &FileSaving::fileChangedOutside);
    connect(m_watch, &FileWatch::removed, this, [this] {
        if (m_editor.isSaving())
            return;
        m_editor.keepMine({});
        m_window.statusBar()->showMessage(
            tr("“%1” is gone from its folder. Save to put it back.").arg(m_editor.displayName()));
    });
}

FileSaving *FileSaving::of(const QString &path)
{
    const QString file = QFileInfo(path).canonicalFilePath();
    if (file.isEmpty())
        return nullptr;
    for (const QWidget *window : QApplication::topLevelWidgets())
        if (auto *saving = window->findChild<FileSaving *>();
            saving && window->isVisible() && QFileInfo(saving->m_editor.filePath()).canonicalFilePath() == file)
            return saving;
    return nullptr;
}

void FileSaving::addRows(Commands &table)
{
    using enum Command;
    table.add(Save, "save", Commands::tr("&Save"), "save", QKeySequence::keyBindings(QKeySequence::Save)).runs([this] {
        startSaving();
    });
    table.add(SaveAs, "saveAs", Commands::tr("Save &As…"), "", {QKeySequence(Commands::tr("Ctrl+Shift+S"))})
        .runs([this] { startSavingAs(); });
    table
        .add(SaveCopy, "saveCopy", Commands::tr("Save a Cop&y…"), "", {QKeySequence(Commands::tr("Ctrl+Alt+Shift+S"))},
             Commands::tr("Into another file; you go on painting in this one"))
        .runs([this] { startSavingCopy(); });
}

bool FileSaving::startSaving()
{
    if (m_editor.filePath().isEmpty())
        return startSavingAs();
    startSavingTo(m_editor.filePath());
    return true;
}

bool FileSaving::startSavingAs()
{
    const QString suggested = QFileInfo(m_editor.suggestedPath()).fileName();
    const QString name = suggested.isEmpty() ? m_editor.displayName() + ".suffuse" : suggested;
    const QString path = askForFile(tr("Save As"), placeToSave(m_editor, name));
    if (path.isEmpty())
        return false;
    startSavingTo(path, true); // it was asked whether it may be replaced
    return true;
}

void FileSaving::startSavingCopy()
{
    m_canvas.settleWritten();
    m_leavesDraft = m_editor.document().draft() != nullptr;
    const QFileInfo origin(m_editor.suggestedPath().isEmpty() ? m_editor.displayName() + ".suffuse"
                                                              : m_editor.suggestedPath());
    //: name of the file that a copy is saved to, beside that of the painting
    const QString name = tr("%1 copy").arg(origin.completeBaseName()) + '.' + origin.suffix();
    const FileKind drawing{tr("SVG drawing"), {"svg"}};
    const QString path = askForFile(tr("Save a Copy"), placeToSave(m_editor, name), {drawing});
    if (path.isEmpty())
        return;
    if (path.endsWith(QStringLiteral(".svg"), Qt::CaseInsensitive))
        return writeDrawing(path);
    const QString own = QFileInfo(m_editor.filePath()).canonicalFilePath();
    if (!own.isEmpty() && QFileInfo(path).canonicalFilePath() == own) {
        startSavingTo(path, true); // then it is no copy
        return;
    }
    m_editor.extras().view = workspaceOf(m_canvas, m_editor);
    m_editor.startSavingCopy(path);
}

/// What other programs understand of the painting: lines as wide as they are seen, and areas. It is no document of this
/// one, so it can only be a copy.
void FileSaving::writeDrawing(const QString &path)
{
    const Painting &painting = *m_editor.document().painting();
    const SvgStrokes svg = svgOf(painting, painting.canvas.area());
    if (const Result<void> written = writeFileAtomically(path, svg.bytes); !written) {
        if (askAfterFailedSave(&m_window, written.error()))
            startSavingCopy();
        return;
    }
    const QString said =
        tr("“%1” has plain lines and areas, for other programs. Export Drawing keeps soft and dark edges.")
            .arg(QFileInfo(path).fileName());
    m_window.statusBar()->showMessage(joinedSentences({withDraft(said), leftOutOf(svg)}), shownMs);
}

void FileSaving::startSavingTo(const QString &path, bool whatever)
{
    m_savingWorked = true;
    m_canvas.settleWritten();
    m_leavesDraft = m_editor.document().draft() != nullptr;
    m_editor.extras().view = workspaceOf(m_canvas, m_editor);
    m_editor.startSaving(path, whatever);
    m_window.statusBar()->showMessage(tr("Saving “%1”…").arg(QFileInfo(path).fileName()));
}

bool FileSaving::waitForSaving()
{
    QProgressDialog box(tr("Saving “%1”…").arg(m_editor.displayName()), QString(), 0, 0, &m_window);
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

bool FileSaving::save()
{
    return startSaving() && waitForSaving();
}

bool FileSaving::saveTo(const QString &path)
{
    startSavingTo(path);
    return waitForSaving();
}

/// What is drawn and not let go is seen like paint, and is not in the file.
QString FileSaving::withDraft(const QString &said) const
{
    return m_leavesDraft ? tr("%1 (without what is still being drawn)").arg(said) : said;
}

void FileSaving::showOutcome(const SaveOutcome &outcome)
{
    const QString name = QFileInfo(outcome.path).fileName();
    if (outcome.isCopy) {
        if (outcome.isSaved())
            m_window.statusBar()->showMessage(withDraft(tr("A copy is saved as “%1”.").arg(name)), shownMs);
        else if (askAfterFailedSave(&m_window, outcome.message))
            startSavingCopy();
        return;
    }
    m_savingWorked = outcome.isSaved();
    if (outcome.wasThere) {
        sayUntilChange(*m_window.statusBar(), m_editor.document(), withDraft(tr("“%1” is saved already.").arg(name)),
                       shownMs);
        return;
    }
    if (outcome.isSaved()) {
        settings::addRecentFile(outcome.path);
        m_window.statusBar()->showMessage(
            outcome.message.isEmpty()
                ? withDraft(tr("Saved “%1”, %2").arg(name, m_window.locale().formattedDataSize(outcome.bytes)))
                : tr("Saved “%1”, but %2").arg(name, outcome.message),
            shownMs);
        return;
    }
    m_window.statusBar()->showMessage(tr("“%1” is not saved.").arg(name), shownMs);
    if (outcome.kind == SaveOutcome::Kind::ChangedOutside) {
        m_watch->watch(m_editor.filePath(), outcome.hash); // it is asked about here
        m_asking = true;
        const ConflictAnswer answer = askAboutConflict(&m_window, name, true, true);
        m_asking = false;
        if (answer == ConflictAnswer::KeepMine)
            startSavingTo(outcome.path, true);
        else
            answerConflict(answer, outcome.hash);
    } else if (askAfterFailedSave(&m_window, outcome.message)) {
        startSavingAs();
    }
}

void FileSaving::fileChangedOutside(const QByteArray &hash)
{
    if (m_asking || m_editor.isSaving() || hash == m_editor.fileHash())
        return;                                         // saving looks for itself
    if (m_canvas.tool() && m_canvas.tool()->isBusy()) { // not in the middle of a stroke
        QTimer::singleShot(saveLaterMs, this, [this, hash] { fileChangedOutside(hash); });
        return;
    }
    const QString said =
        QCoreApplication::translate("Messages", "Another program has changed “%1”.").arg(m_editor.displayName());
    if (!m_window.isActiveWindow()) { // A question would take the keys that are meant for another window.
        m_window.statusBar()->showMessage(said);
        QApplication::alert(&m_window);
        connect(
            qApp, &QGuiApplication::focusWindowChanged, this, [this, hash] { fileChangedOutside(hash); },
            Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection));
        return;
    }
    if (m_window.statusBar()->currentMessage() == said)
        m_window.statusBar()->clearMessage();
    m_asking = true;
    const ConflictAnswer answer = askAboutConflict(&m_window, m_editor.displayName(), m_editor.isModified(), false);
    m_asking = false;
    answerConflict(answer, hash);
}

void FileSaving::answerConflict(ConflictAnswer answer, const QByteArray &hash)
{
    switch (answer) {
    case ConflictAnswer::KeepMine:
        m_editor.keepMine(hash);
        break;
    case ConflictAnswer::Reload:
        if (const Result<void> reverted = m_editor.revert(); !reverted) {
            m_editor.keepMine(hash);
            showError(&m_window, reverted.error());
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

void FileSaving::watchFile()
{
    m_watch->watch(m_editor.filePath(), m_editor.fileHash());
}

bool FileSaving::maySwitch()
{
    if (m_editor.isSaving())
        waitForSaving();
    if (!m_editor.isModified())
        return true;
    switch (askToSave(&m_window, m_editor.displayName())) {
    case SaveAnswer::Save:
        return save();
    case SaveAnswer::Discard:
        return true;
    case SaveAnswer::Cancel:
        break;
    }
    return false;
}

QString FileSaving::askForFile(const QString &title, const QString &proposal, const QList<FileKind> &more)
{
    const QList<FileKind> kinds =
        QList<FileKind>{{tr("Suffuse painting"), {"suffuse"}}, {tr("Text form"), {"json"}}} + more;
    for (QString path = proposal;;) {
        path = chooseFileToSave(&m_window, title, path, kinds);
        const FileSaving *other = path.isEmpty() ? nullptr : of(path);
        if (!other || other == this)
            return path;
        showError(&m_window, tr("“%1” is open in another window. Choose another name, or close that window first.")
                                 .arg(QFileInfo(path).fileName()));
    }
}

} // namespace suffuse
