#include "app/window/files/file_opening.h"

#include "app/canvas/canvas_widget.h"
#include "app/dialogs/new_dialog.h"
#include "app/session/commands/commands.h"
#include "app/session/files/opened_file.h"
#include "app/session/open_painting.h"
#include "app/session/settings/kept_brush.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/habits/at_next_change.h"
#include "app/widgets/habits/place_beside.h"
#include "app/window/files/file_choice.h"
#include "app/window/files/file_restoring.h"
#include "app/window/files/file_saving.h"
#include "app/window/files/save_place.h"
#include "app/window/layout/workspace_view.h"
#include "model/formats/atomic_save.h"
#include "model/journal/recovery.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHash>
#include <QMainWindow>
#include <QMenu>
#include <QStatusBar>

namespace suffuse {

FileOpening::FileOpening(const Workplace &place, FileRestoring &restoring, KeptBrush &brush, MakeWindow make,
                         QObject *parent)
    : QObject(parent), m_place(place), m_restoring(restoring), m_brush(brush), m_make(std::move(make))
{
    using enum Command;
    const auto keys = [](QKeySequence::StandardKey key) { return QKeySequence::keyBindings(key); };
    place.commands.add(New, "new", Commands::tr("&New…"), "new", keys(QKeySequence::New)).runs([this] {
        newPainting();
    });
    place.commands.add(Open, "open", Commands::tr("&Open…"), "open", keys(QKeySequence::Open)).runs([this] {
        chooseFiles();
    });
}

bool FileOpening::isUntouched() const
{
    Editor &editor = m_place.open.editor;
    return editor.filePath().isEmpty() && editor.undoStack().count() == 0 && !editor.isModified() &&
           editor.document().painting()->strokes.empty();
}

FileOpening *FileOpening::show(const std::function<void(OpenPainting &open)> &fill)
{
    if (isUntouched()) {
        fill(m_place.open);
        return this;
    }
    m_brush.keep();
    auto open = std::make_unique<OpenPainting>();
    open->editor.setBrush(settings::brush());
    fill(*open);
    FileOpening *other = m_make(std::move(open));
    other->window().setAttribute(Qt::WA_DeleteOnClose);
    showLike(other->window(), window());
    return other;
}

void FileOpening::newPainting()
{
    if (const std::optional<NewSheet> sheet = NewDialog::ask(&window()))
        begin(sheet->canvas, sheet->resolution);
}

FileOpening *FileOpening::begin(const Canvas &canvas, double resolution)
{
    return show([&](OpenPainting &open) { open.editor.newPainting(canvas, resolution); });
}

void FileOpening::chooseFiles()
{
    const QStringList files =
        QFileDialog::getOpenFileNames(&window(), tr("Open"), folderNear(m_place.open.editor), openFilter());
    FileOpening *last = this;
    for (const QString &file : files)
        if (FileOpening *opened = last->open(file))
            last = opened;
}

FileOpening *FileOpening::open(const QString &path)
{
    if (const FileSaving *shown = FileSaving::of(path)) { // twice would be as if another program changed it
        QMainWindow &other = shown->window();
        other.setWindowState(other.windowState() & ~Qt::WindowMinimized);
        other.raise();
        other.activateWindow();
        other.statusBar()->showMessage(tr("“%1” is open already.").arg(QFileInfo(path).fileName()), 8'000);
        return other.findChild<FileOpening *>();
    }
    if (formatForSaving(backedUpFile(path)) != FileFormat::Unknown)
        return openBackup(path);
    Result<OpenedFile> file = readOpenedFile(path);
    if (!file) {
        showError(&window(), file.error());
        return nullptr;
    }
    return showFile(std::move(*file));
}

FileOpening *FileOpening::showFile(OpenedFile file)
{
    if (!file.isSample)
        settings::addRecentFile(file.path);
    const QString name = QFileInfo(file.path).fileName();
    std::vector<QString> losses;
    FileOpening *shown = show([&](OpenPainting &open) { losses = open.editor.open(std::move(file)); });
    const Workplace &place = shown->m_place;
    Editor &editor = place.open.editor;
    if (const auto &view = editor.extras().view)
        showWorkspace(*view, place.canvas, editor);
    if (const QString &leftOut = editor.leftOut(); !leftOut.isEmpty() && losses.empty())
        sayUntilChange(*place.window.statusBar(), editor.document(), leftOut);
    if (!losses.empty())
        showNotice(&place.window,
                   tr("“%1” is damaged. What is whole of it was opened; the file itself is left as it is.").arg(name),
                   QStringList(losses.begin(), losses.end()).join('\n'));
    return shown;
}

FileOpening *FileOpening::openBackup(const QString &backup)
{
    Result<LoadedDocument> state = loadDocument(backup);
    if (!state) {
        showError(&window(), state.error());
        return nullptr;
    }
    const QFileInfo painting(backedUpFile(backup));
    if (FileOpening *opened = painting.isFile() ? open(painting.filePath()) : nullptr) {
        opened->m_restoring.restoreFrom(backup);
        return opened;
    }
    return show([&](OpenPainting &open) {
        open.editor.openRecovered(std::move(state->painting), painting.fileName(), painting.absoluteFilePath(),
                                  state->extras.resolution);
    });
}

FileOpening *FileOpening::openRecovered(LostDocument document)
{
    return show([&](OpenPainting &open) {
        open.journal.replaceNext(std::move(document.file));
        open.editor.openRecovered(std::move(document.content.painting), document.content.head.name,
                                  document.content.head.path, document.content.head.resolution);
    });
}

void FileOpening::fillRecentMenu(QMenu &menu)
{
    menu.clear();
    const QStringList files = settings::recentFiles();
    QHash<QString, int> named;
    for (const QString &path : files)
        ++named[QFileInfo(path).fileName()];
    for (const QString &path : files) {
        const QFileInfo file(path);
        QString text = file.fileName();
        if (named.value(text) > 1) // Those of one name are told apart by their folders.
            text += QStringLiteral(" — ") + file.dir().dirName();
        QAction *entry = menu.addAction(text.replace('&', "&&"));
        entry->setToolTip(path);
        connect(entry, &QAction::triggered, this, [this, path] { open(path); });
    }
    menu.setToolTipsVisible(true);
    menu.addSeparator();
    QAction *clear = menu.addAction(tr("&Clear the List"));
    clear->setEnabled(!files.isEmpty());
    connect(clear, &QAction::triggered, this, [] { settings::clearRecentFiles(); });
}

} // namespace suffuse
