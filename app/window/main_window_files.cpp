// Opening, saving, closing, the clipboard: the part of the window that deals with what comes from outside.
#include "app/canvas/canvas_widget.h"
#include "app/dialogs/new_dialog.h"
#include "app/session/commands/underlay_commands.h"
#include "app/session/files/clipboard.h"
#include "app/session/files/import_strokes.h"
#include "app/session/files/journal.h"
#include "app/session/settings/settings.h"
#include "app/widgets/at_next_change.h"
#include "app/widgets/messages.h"
#include "app/widgets/place_beside.h"
#include "app/widgets/save_name.h"
#include "app/window/clipboard_drops.h"
#include "app/window/main_window.h"
#include "app/window/window_layout.h"
#include "app/window/workspace_view.h"
#include "model/formats/atomic_save.h"
#include "model/formats/files.h"
#include "model/journal/recovery.h"

#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QCursor>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMenu>
#include <QMimeData>
#include <QStatusBar>

namespace suffuse {

namespace {

QStringList localFiles(const QMimeData *data)
{
    QStringList files;
    for (const QUrl &url : data->urls())
        if (url.isLocalFile())
            files << url.toLocalFile();
    return files;
}

QString openFilter()
{
    return MainWindow::tr("All that can be opened (*.suffuse *.json *.csv *.excalidraw *.dat *.svg *.xml)") + ";;" +
           MainWindow::tr("Suffuse paintings (*.suffuse *.json)") + ";;" +
           MainWindow::tr("Backups of paintings (*.suffuse~* *.json~*)") + ";;" +
           MainWindow::tr("Pen recordings (*.csv *.json *.excalidraw *.dat)") + ";;" +
           MainWindow::tr("SVG drawings (*.svg)") + ";;" + MainWindow::tr("Diffusion curves (*.xml)") + ";;" +
           MainWindow::tr("All files (*)");
}

/// Where the painting lies, or the one that was opened last.
QString folderNear(const Editor &editor)
{
    const QString near = editor.filePath().isEmpty() ? settings::recentFiles().value(0) : editor.filePath();
    return near.isEmpty() ? QString() : QFileInfo(near).absolutePath();
}

/// That shows this file, by whatever name and links it was opened.
MainWindow *windowWith(const QString &path)
{
    const QString file = QFileInfo(path).canonicalFilePath();
    if (file.isEmpty())
        return nullptr;
    for (QWidget *widget : QApplication::topLevelWidgets())
        if (auto *window = qobject_cast<MainWindow *>(widget);
            window && window->isVisible() && QFileInfo(window->editor().filePath()).canonicalFilePath() == file)
            return window;
    return nullptr;
}

} // namespace

bool MainWindow::isUntouched()
{
    return m_editor.filePath().isEmpty() && m_editor.undoStack().count() == 0 && !m_editor.isModified() &&
           m_editor.document().painting()->strokes.empty();
}

MainWindow *MainWindow::openWindow()
{
    keepBrush();
    auto *window = new MainWindow;
    window->setAttribute(Qt::WA_DeleteOnClose);
    showLike(*window, *this);
    return window;
}

void MainWindow::newWindow()
{
    const std::optional<Canvas> canvas = NewDialog::ask(this);
    if (!canvas)
        return;
    MainWindow *window = isUntouched() ? this : openWindow();
    window->m_editor.newPainting(*canvas);
}

void MainWindow::chooseFileToOpen()
{
    const QStringList files = QFileDialog::getOpenFileNames(this, tr("Open"), folderNear(m_editor), openFilter());
    MainWindow *window = this;
    for (const QString &file : files)
        if (MainWindow *opened = window->openFile(file))
            window = opened;
}

MainWindow *MainWindow::openFile(const QString &path)
{
    if (MainWindow *window = windowWith(path)) { // twice would be as if another program changed it
        window->setWindowState(window->windowState() & ~Qt::WindowMinimized);
        window->raise();
        window->activateWindow();
        window->statusBar()->showMessage(tr("“%1” is open already.").arg(QFileInfo(path).fileName()), 8'000);
        return window;
    }
    if (formatForSaving(backedUpFile(path)) != FileFormat::Unknown)
        return openBackup(path);
    // Into an editor of its own first, so that a file that cannot be read opens no window.
    MainWindow *window = this;
    std::unique_ptr<MainWindow> made;
    if (!isUntouched()) {
        keepBrush();
        made = std::make_unique<MainWindow>();
        window = made.get();
    }
    const Result<std::vector<QString>> losses = window->m_editor.open(path);
    if (!losses) {
        showError(this, losses.error());
        return nullptr;
    }
    settings::addRecentFile(QFileInfo(path).absoluteFilePath());
    if (made) {
        made->setAttribute(Qt::WA_DeleteOnClose);
        showLike(*made.release(), *this);
    }
    if (const auto &view = window->m_editor.extras().view)
        showWorkspace(*view, *window->m_canvas, window->m_editor);
    if (const QString &leftOut = window->m_editor.leftOut(); !leftOut.isEmpty() && losses->empty())
        sayUntilChange(*window->statusBar(), window->m_editor.document(), leftOut);
    if (!losses->empty())
        showNotice(window,
                   tr("“%1” is damaged. What is whole of it was opened; the file itself is left as it is.")
                       .arg(QFileInfo(path).fileName()),
                   QStringList(losses->begin(), losses->end()).join('\n'));
    return window;
}

/// Opens its painting, and puts the backup in place of what is there: saving saves the painting.
MainWindow *MainWindow::openBackup(const QString &backup)
{
    Result<LoadedDocument> state = loadDocument(backup);
    if (!state) {
        showError(this, state.error());
        return nullptr;
    }
    const QFileInfo painting(backedUpFile(backup));
    if (MainWindow *window = painting.isFile() ? openFile(painting.filePath()) : nullptr) {
        window->restoreFrom(backup);
        return window;
    }
    MainWindow *window = isUntouched() ? this : openWindow();
    window->m_editor.openRecovered(std::move(state->painting), painting.fileName(), painting.absoluteFilePath());
    return window;
}

QString MainWindow::askForFile(const QString &title, const QString &proposal)
{
    const QList<FileKind> kinds{{tr("Suffuse painting"), {"suffuse"}}, {tr("Text form"), {"json"}}};
    for (QString path = proposal;;) {
        path = chooseFileToSave(this, title, path, kinds);
        const MainWindow *other = path.isEmpty() ? nullptr : windowWith(path);
        if (!other || other == this)
            return path;
        showError(this, tr("“%1” is open in another window. Choose another name, or close that window first.")
                            .arg(QFileInfo(path).fileName()));
    }
}

void MainWindow::chooseStrokesToImport()
{
    if (m_canvas->tool() && m_canvas->tool()->isBusy())
        return;
    const QString path = QFileDialog::getOpenFileName(this, tr("Import Strokes"), folderNear(m_editor), openFilter());
    if (!path.isEmpty())
        importStrokes(path);
}

void MainWindow::importStrokes(const QString &path)
{
    const View &view = m_canvas->view();
    const Point middle = view.toCanvas({0.5 * view.width, 0.5 * view.height});
    const Result<ImportReport> report = suffuse::importStrokes(m_editor, path, middle);
    if (!report) {
        showError(this, report.error());
        return;
    }
    action(Command::Select).setChecked(true); // it is to be put where it belongs
    if (!report->leftOut.isEmpty())
        sayUntilChange(*statusBar(), m_editor.document(), report->leftOut);
    if (!report->losses.empty())
        showNotice(this, tr("“%1” is damaged. What is whole of it was imported.").arg(QFileInfo(path).fileName()),
                   QStringList(report->losses.begin(), report->losses.end()).join('\n'));
}

MainWindow *MainWindow::openRecovered(LostDocument document)
{
    MainWindow *window = isUntouched() ? this : openWindow();
    window->m_journal->replaceNext(std::move(document.file));
    window->m_editor.openRecovered(std::move(document.content.painting), document.content.head.name,
                                   document.content.head.path);
    return window;
}

bool MainWindow::maySwitch()
{
    if (m_editor.isSaving())
        waitForSaving();
    if (!m_editor.isModified())
        return true;
    switch (askToSave(this, m_editor.displayName())) {
    case SaveAnswer::Save:
        return save();
    case SaveAnswer::Discard:
        return true;
    case SaveAnswer::Cancel:
        break;
    }
    return false;
}

void MainWindow::fillRecentMenu()
{
    QMenu *menu = m_recentMenu;
    menu->clear();
    const QStringList files = settings::recentFiles();
    for (const QString &path : files) {
        QString text = QFileInfo(path).fileName();
        QAction *entry = menu->addAction(text.replace('&', "&&"));
        entry->setToolTip(path);
        connect(entry, &QAction::triggered, this, [this, path] { openFile(path); });
    }
    menu->setToolTipsVisible(true);
    menu->addSeparator();
    QAction *clear = menu->addAction(tr("&Clear the List"));
    clear->setEnabled(!files.isEmpty());
    connect(clear, &QAction::triggered, this, [] { settings::clearRecentFiles(); });
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (m_canvas->tool())
        m_canvas->tool()->cancel();
    if (!maySwitch()) {
        event->ignore();
        return;
    }
    if (action(Command::HideDocks).isChecked()) // they are to come back next time
        action(Command::HideDocks).trigger();
    window_layout::save(*this);
    if (m_brushChanged.isActive())
        keepBrush();
    m_journal->remove();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent *event)
{
    if (!localFiles(event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent *event)
{
    event->acceptProposedAction();
    MainWindow *window = this;
    for (const QString &file : localFiles(event->mimeData())) {
        if (underlay::isPicture(file))
            window->importUnderlay(file);
        else if (MainWindow *opened = window->openFile(file))
            window = opened;
    }
}

void MainWindow::addClipboardRows()
{
    using enum Command;
    m_commands
        ->add(Paste, "paste", Commands::tr("&Paste"), "paste", QKeySequence::keyBindings(QKeySequence::Paste),
              Commands::tr("Paste strokes or SVG paths at the pointer; a colour becomes the current one"))
        .when([this] { return m_canPaste; })
        .runs([this] {
            // At the pointer, as in Inkscape; in the middle where it is elsewhere.
            const QPointF at = m_canvas->mapFromGlobal(QPointF(QCursor::pos()));
            const View &view = m_canvas->view();
            const double dpr = m_canvas->devicePixelRatioF();
            const bool inside = QRectF(m_canvas->rect()).contains(at);
            const Point middle{0.5 * view.width, 0.5 * view.height};
            pasteAt(view.toCanvas(inside ? Point{at.x() * dpr, at.y() * dpr} : middle));
        });
    m_commands
        ->add(PasteInPlace, "pasteInPlace", Commands::tr("Paste &in Place"), "",
              {QKeySequence(Commands::tr("Ctrl+Alt+V"))}, Commands::tr("Paste strokes where they were"))
        .when([this] { return m_canPaste; })
        .runs([this] { pasteAt({}); });
    connect(new CanvasDrops(*m_canvas), &CanvasDrops::leftOut, this,
            [this](const QString &problem) { emit m_commands->said(problem, 8'000); });
    const auto follow = [this] {
        m_canPaste = clipboard::canPaste(QGuiApplication::clipboard()->mimeData());
        m_commands->update(Paste);
        m_commands->update(PasteInPlace);
    };
    connect(QGuiApplication::clipboard(), &QClipboard::dataChanged, this, follow);
    follow();
}

void MainWindow::pasteAt(std::optional<Point> centre)
{
    if (m_canvas->tool() && m_canvas->tool()->isBusy())
        return; // first things first
    const QMimeData *data = QGuiApplication::clipboard()->mimeData();
    if (const QString problem = data ? clipboard::paste(m_editor, *data, centre) : QString(); !problem.isEmpty())
        sayUntilChange(*statusBar(), m_editor.document(), problem, 8'000);
}

} // namespace suffuse
