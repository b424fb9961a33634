#include "app/window/actions.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/commands/selection_commands.h"
#include "app/session/editor.h"
#include "app/session/files/clipboard.h"
#include "app/widgets/icons.h"

#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QToolBar>
#include <QToolButton>

namespace suffuse {

QString plainTitle(QString title)
{
    static const QRegularExpression mnemonic(QStringLiteral("\\(&.\\)"));
    title.remove(mnemonic).remove('&');
    while (title.endsWith('.') || title.endsWith(QStringLiteral("…")) || title.endsWith(' '))
        title.chop(1);
    return title;
}

namespace {

/// The menu that an action is in; none: null. An action may be in tool bars, too, and in the nameless menu that a menu
/// bar without room has at its end.
const QMenu *menuOf(const QAction &action)
{
    for (const QObject *place : action.associatedObjects())
        if (const auto *menu = qobject_cast<const QMenu *>(place); menu && !menu->title().isEmpty())
            return menu;
    return nullptr;
}

constexpr double zoomStep = 1.4142135623730951;
constexpr double turnStep = 15; ///< degrees

/// A drag belongs to no step yet.
bool isBusy(const CommandTarget &target)
{
    return target.canvas.tool() && target.canvas.tool()->isBusy();
}

/// Undo gives up what is in hand instead, as in Krita. False: nothing was.
bool givesUp(const CommandTarget &target)
{
    if (!isBusy(target))
        return false;
    target.canvas.tool()->cancel();
    return true;
}

} // namespace

QString titleWithMenus(const QAction &action)
{
    QString title = plainTitle(action.iconText());
    for (const QMenu *menu = menuOf(action); menu; menu = menuOf(*menu->menuAction()))
        title.prepend(plainTitle(menu->title()) + QStringLiteral(" ▸ "));
    return title;
}

bool anySelected(const CommandTarget &target)
{
    return !target.editor.document().selection().isEmpty();
}

bool anyStrokes(const CommandTarget &target)
{
    return !target.editor.document().painting()->strokes.empty();
}

Actions::Actions(QMainWindow &window) : QObject(&window), m_window(window)
{
    addFileAndEdit();
    addTools();
    addNodeCommands();
    addObjects();
    addTime();
    addFavourites();
    addToolKeys();
    addViewAndHelp();
}

CommandRow &Actions::add(Command command, const QString &id, const QString &text, const char *iconName,
                         const QList<QKeySequence> &keys, const QString &tip)
{
    auto *action = new QAction(text, this);
    if (*iconName)
        action->setIcon(icon(QString::fromLatin1(iconName)));
    action->setObjectName(id);
    action->setIconText(plainTitle(text)); // stays when the text names the step that is undone
    action->setShortcuts(keys);
    const auto showKey = [action, tip] {
        const QString key = action->shortcut().toString(QKeySequence::NativeText);
        const QString what = tip.isEmpty() ? plainTitle(action->text()) : tip;
        action->setToolTip(key.isEmpty() ? what : QStringLiteral("%1 (%2)").arg(what, key));
    };
    showKey();
    connect(action, &QAction::changed, this, showKey);
    m_actions[command] = action;
    m_window.addAction(action); // keys work with the menu bar hidden, too
    return m_rows[command];
}

void Actions::serve(const CommandTarget &target)
{
    m_target.emplace(target);
    for (const auto &[command, row] : m_rows) {
        QAction *action = m_actions.at(command);
        if (row.run)
            connect(action, &QAction::triggered, this, [this, run = row.run] {
                run(*m_target);
                update();
            });
        if (row.toggled)
            connect(action, &QAction::toggled, this,
                    [this, toggled = row.toggled](bool on) { toggled(*m_target, on); });
    }
    update();
}

void Actions::update()
{
    if (!m_target)
        return;
    for (const auto &[command, row] : m_rows) {
        QAction *action = m_actions.at(command);
        if (row.enabled)
            action->setEnabled(row.enabled(*m_target));
        if (row.checked)
            action->setChecked(row.checked(*m_target));
        if (row.text)
            action->setText(row.text(*m_target));
        if (row.icon)
            action->setIcon(icon(row.icon(*m_target)));
    }
}

void Actions::addFileAndEdit()
{
    const auto keys = [](QKeySequence::StandardKey key) { return QKeySequence::keyBindings(key); };
    add(Command::New, "new", tr("&New…"), "new", keys(QKeySequence::New));
    add(Command::Open, "open", tr("&Open…"), "open", keys(QKeySequence::Open));
    add(Command::Save, "save", tr("&Save"), "save", keys(QKeySequence::Save));
    add(Command::SaveAs, "saveAs", tr("Save &As…"), "", {QKeySequence(tr("Ctrl+Shift+S"))});
    add(Command::SaveCopy, "saveCopy", tr("Save a Cop&y…"), "", {QKeySequence(tr("Ctrl+Alt+Shift+S"))},
        tr("Into another file; you go on painting in this one"));
    add(Command::Revert, "revert", tr("Re&vert…"), "", {}, tr("Back to what the file holds; Undo takes it back"));
    add(Command::RestoreBackup, "restoreBackup", tr("Restore &Backup…"), "", {},
        tr("Back to an earlier version of the file"));
    add(Command::KeepHistory, "keepHistory", tr("Keep Undo &History in the File"), "", {},
        tr("Whoever opens the file can go on undoing. Take it out before you give a file away"));
    m_actions[Command::KeepHistory]->setCheckable(true);
    add(Command::ImportStrokes, "importStrokes", tr("&Import Strokes…"), "", {},
        tr("Drawings, recordings and the strokes of other paintings, into this one"));
    add(Command::ImportUnderlay, "importUnderlay", tr("Import &Underlay…"), "", {},
        tr("A picture to paint over, which shows on the canvas only"));
    add(Command::Export, "export", tr("&Export…"), "export", {QKeySequence(tr("Ctrl+Shift+E"))});
    add(Command::ExportAgain, "exportAgain", tr("Export A&gain"), "", {QKeySequence(tr("Ctrl+E"))},
        tr("To the same file, with the same settings"));
    add(Command::Close, "close", tr("&Close Window"), "", keys(QKeySequence::Close));
    add(Command::Quit, "quit", tr("&Quit"), "", {QKeySequence(tr("Ctrl+Q"))});
    m_actions[Command::Quit]->setMenuRole(QAction::QuitRole);
    add(Command::Undo, "undo", tr("&Undo"), "undo", keys(QKeySequence::Undo))
        .when([](const CommandTarget &t) { return t.editor.document().draft() || isBusy(t) || t.editor.canUndo(); })
        .named([](const CommandTarget &t) {
            const bool strokeInHand = t.editor.document().draft() != nullptr;
            const QString step = strokeInHand ? QString() : t.editor.undoText();
            return step.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(step);
        })
        .runs([](const CommandTarget &t) {
            if (!givesUp(t))
                t.editor.undo();
        });
    add(Command::Redo, "redo", tr("&Redo"), "redo", {QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))})
        .when([](const CommandTarget &t) { return t.editor.canRedo(); })
        .named([](const CommandTarget &t) {
            const QString step = t.editor.redoText();
            return step.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(step);
        })
        .runs([](const CommandTarget &t) {
            if (!givesUp(t))
                t.editor.redo();
        });
    add(Command::Cut, "cut", tr("Cu&t"), "cut", keys(QKeySequence::Cut))
        .when(anySelected)
        .runs([](const CommandTarget &t) { clipboard::cut(t.editor); });
    add(Command::Copy, "copy", tr("&Copy"), "copy", keys(QKeySequence::Copy))
        .when(anySelected)
        .runs([](const CommandTarget &t) { clipboard::copy(t.editor); });
    add(Command::Paste, "paste", tr("&Paste"), "paste", keys(QKeySequence::Paste),
        tr("Paste strokes or SVG paths at the pointer; a colour becomes the current one"));
    add(Command::PasteInPlace, "pasteInPlace", tr("Paste &in Place"), "", {QKeySequence(tr("Ctrl+Alt+V"))},
        tr("Paste strokes where they were"));
    add(Command::Delete, "delete", tr("&Delete"), "delete", {QKeySequence(Qt::Key_Delete)})
        .when(anySelected)
        .runs([](const CommandTarget &t) {
            if (!givesUp(t) && !t.canvas.tool()->deleteSelected())
                commands::deleteSelected(t.editor);
        });
    add(Command::Duplicate, "duplicate", tr("Dup&licate"), "duplicate", {QKeySequence(tr("Ctrl+D"))})
        .when(anySelected)
        .runs([](const CommandTarget &t) { commands::duplicateSelected(t.editor); });
    add(Command::SelectAll, "selectAll", tr("Select &All"), "", keys(QKeySequence::SelectAll));
    add(Command::Deselect, "deselect", tr("D&eselect"), "", {QKeySequence(tr("Ctrl+Shift+A"))})
        .when(anySelected)
        .runs([](const CommandTarget &t) { t.editor.document().setSelection({}); });
    add(Command::Settings, "settings", tr("Settin&gs…"), "", {QKeySequence(tr("Ctrl+,"))});
    m_actions[Command::Settings]->setMenuRole(QAction::PreferencesRole);
}

void Actions::addViewAndHelp()
{
    // "=" is the unshifted "+" on many keyboards.
    add(Command::ZoomIn, "zoomIn", tr("Zoom &In"), "zoom-in",
        {QKeySequence(Qt::Key_Plus), QKeySequence(Qt::Key_Equal), QKeySequence(QKeySequence::ZoomIn)})
        .runs([](const CommandTarget &t) { t.canvas.zoomBy(zoomStep); });
    add(Command::ZoomOut, "zoomOut", tr("Zoom &Out"), "zoom-out",
        {QKeySequence(Qt::Key_Minus), QKeySequence(QKeySequence::ZoomOut)})
        .runs([](const CommandTarget &t) { t.canvas.zoomBy(1 / zoomStep); });
    add(Command::Zoom100, "zoom100", tr("&100 %"), "", {QKeySequence(tr("Ctrl+1"))}).runs([](const CommandTarget &t) {
        t.canvas.setZoom(1);
    });
    add(Command::Fit, "fit", tr("&Fit the Canvas"), "fit", {QKeySequence(Qt::Key_0)}).runs([](const CommandTarget &t) {
        t.canvas.fit();
    });
    add(Command::RotateLeft, "rotateLeft", tr("Turn &Left"), "", {QKeySequence(tr("Ctrl+4"))})
        .runs([](const CommandTarget &t) { t.canvas.rotateBy(-turnStep); });
    add(Command::RotateRight, "rotateRight", tr("Turn &Right"), "", {QKeySequence(tr("Ctrl+6"))})
        .runs([](const CommandTarget &t) { t.canvas.rotateBy(turnStep); });
    add(Command::ResetRotation, "resetRotation", tr("&Upright"), "", {QKeySequence(tr("Ctrl+5"))})
        .runs([](const CommandTarget &t) { t.canvas.resetRotation(); });
    add(Command::Mirror, "mirror", tr("&Mirror"), "", {QKeySequence(Qt::Key_M)}).runs([](const CommandTarget &t) {
        t.canvas.mirror();
    });
    add(Command::HideDocks, "hideDocks", tr("&Hide the Docks"), "", {QKeySequence(Qt::Key_Tab)});
    add(Command::NextPanel, "nextPanel", tr("Ne&xt Panel"), "", {QKeySequence(Qt::Key_F6)},
        tr("The keyboard goes from the canvas to the docks and tool bars in turn"));
    add(Command::PreviousPanel, "previousPanel", tr("&Previous Panel"), "", {QKeySequence(Qt::SHIFT | Qt::Key_F6)},
        tr("The keyboard goes back from panel to panel"));
    add(Command::FullScreen, "fullScreen", tr("Full S&creen"), "", {QKeySequence(Qt::Key_F11)});
    m_actions[Command::Mirror]->setCheckable(true);
    m_actions[Command::HideDocks]->setCheckable(true);
    m_actions[Command::FullScreen]->setCheckable(true);
    add(Command::FindCommand, "findCommand", tr("&Find a Command…"), "", {QKeySequence(tr("Ctrl+K"))},
        tr("Commands, brushes, docks and recent files by their names"));
    add(Command::Shortcuts, "shortcuts", tr("&Keyboard Shortcuts…"), "", {QKeySequence(Qt::Key_F1)});
    add(Command::About, "about", tr("&About Suffuse…"), "", {});
    m_actions[Command::About]->setMenuRole(QAction::AboutRole);
}

QList<QAction *> Actions::all() const
{
    QList<QAction *> list;
    for (const auto &[command, action] : m_actions)
        list << action;
    return list;
}

QList<QAction *> Actions::runnable() const
{
    QList<QAction *> list;
    for (const auto &[command, action] : m_actions)
        if (!m_rows.at(command).isHeld)
            list << action;
    return list;
}

QMenu *Actions::addMenu(const QString &title, const QList<Command> &commands)
{
    QMenu *menu = m_window.menuBar()->addMenu(title);
    for (const Command command : commands)
        menu->addAction(m_actions.at(command));
    return menu;
}

void Actions::fillMenus()
{
    using enum Command;
    QMenu *file =
        addMenu(tr("&File"), {New, Open, Save, SaveAs, SaveCopy, KeepHistory, Revert, RestoreBackup, ImportStrokes,
                              ImportUnderlay, Export, ExportAgain, ExportTimelapse, Close, Quit});
    m_recentMenu = new QMenu(tr("Open &Recent"), file);
    file->insertMenu(m_actions[Save], m_recentMenu);
    file->insertSeparator(m_actions[Save]);
    file->insertSeparator(m_actions[Revert]);
    file->insertSeparator(m_actions[ImportStrokes]);
    file->insertSeparator(m_actions[Close]);
    QMenu *edit = addMenu(tr("&Edit"), {Undo, Redo, Cut, Copy, Paste, PasteInPlace, Delete, Duplicate, SelectAll,
                                        SelectFound, Deselect, Settings});
    edit->insertSeparator(m_actions[Cut]);
    edit->insertSeparator(m_actions[Delete]);
    edit->insertSeparator(m_actions[SelectAll]);
    addSelecting(*edit);
    edit->insertSeparator(m_actions[Settings]);
    QMenu *view = addMenu(tr("&View"), {ZoomIn, ZoomOut, Zoom100, Fit, RotateLeft, RotateRight, ResetRotation, Mirror});
    view->insertSeparator(m_actions[RotateLeft]);
    view->addSeparator();
    addAids(*view);
    m_docksMenu = view->addMenu(tr("&Docks"));
    for (const Command command : {HideDocks, NextPanel, PreviousPanel, FullScreen})
        view->addAction(m_actions[command]);
    fillObjectMenu(*addMenu(tr("&Object"), {}));
    fillTimeMenu(*addMenu(tr("Ti&me"), {}));
    addMenu(tr("&Nodes"), {InsertNodes, NodeCorner, NodeSmooth, NodeSymmetric, BreakNodes, JoinNodes, DeleteSegments,
                           BridgeSegments, ReverseStrokes});
    QMenu *tools = addMenu(tr("&Tools"), {Brush, Select, Segments, Knife, Eraser, AttributeBrush, Eyedropper, Pan});
    QMenu *favourites = tools->addMenu(tr("&Favourite Brushes"));
    for (int i = 0; i < 9; ++i)
        favourites->addAction(m_actions[Command(int(Favourite1) + i)]);
    for (const Command command : {SmallerSize, LargerSize, LessOpacity, MoreOpacity})
        tools->addAction(m_actions[command]);
    tools->insertSeparator(m_actions[SmallerSize]);
    addMenu(tr("&Help"), {FindCommand, Shortcuts, About});
}

QToolBar *Actions::makeToolBar()
{
    auto *bar = new QToolBar(tr("Tools"), &m_window);
    bar->setObjectName("tools");
    bar->setIconSize(QSize(22, 22));
    bar->setOrientation(Qt::Vertical);
    using enum Command;
    for (const Command command : {Brush, Select, Segments, Knife, Eraser, AttributeBrush, Eyedropper, Pan})
        bar->addAction(m_actions[command]);
    bar->addSeparator();
    for (const Command command : {Undo, Redo})
        bar->addAction(m_actions[command]);
    bar->addSeparator();
    for (const Command command : {ZoomIn, ZoomOut, Fit})
        bar->addAction(m_actions[command]);
    for (auto *button : bar->findChildren<QToolButton *>())
        button->setFocusPolicy(Qt::TabFocus); // the keyboard comes here, too; a click leaves it where it is
    return bar;
}

} // namespace suffuse
