#include "app/actions.h"

#include "app/icons.h"

#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QToolBar>

#include <iterator>

namespace suffuse {

namespace {

/// Name in the settings, the same in every language; in the order of Command.
constexpr const char *commandNames[] = {
    "new",           "open",   "save",      "saveAs",     "export",    "close",      "quit",
    "undo",          "redo",   "delete",    "duplicate",  "selectAll", "deselect",   "settings",
    "brush",         "select", "segments",  "pan",        "raise",     "lower",      "top",
    "bottom",        "zoomIn", "zoomOut",   "zoom100",    "fit",       "rotateLeft", "rotateRight",
    "resetRotation", "mirror", "hideDocks", "fullScreen", "shortcuts", "about",
};
static_assert(std::size(commandNames) == std::size_t(Command::About) + 1);

/// Commands whose keys lists and fields need for themselves.
bool isCanvasOnly(Command command)
{
    switch (command) {
    case Command::Raise:
    case Command::Lower:
    case Command::Top:
    case Command::Bottom:
    case Command::HideDocks:
        return true;
    default:
        return false;
    }
}

} // namespace

QString plainTitle(QString title)
{
    static const QRegularExpression mnemonic(QStringLiteral("\\(&.\\)"));
    title.remove(mnemonic).remove('&');
    while (title.endsWith('.') || title.endsWith(QStringLiteral("…")) || title.endsWith(' '))
        title.chop(1);
    return title;
}

Actions::Actions(QMainWindow &window, QWidget &canvas) : QObject(&window), m_window(window), m_canvas(canvas)
{
    addFileAndEdit();
    addTools();
    addViewAndHelp();
}

void Actions::add(Command command, const QString &text, const char *iconName, const QList<QKeySequence> &keys,
                  const QString &tip)
{
    auto *action = new QAction(text, this);
    if (*iconName)
        action->setIcon(icon(QString::fromLatin1(iconName)));
    action->setObjectName(commandNames[std::size_t(command)]);
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
    if (isCanvasOnly(command)) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        m_canvas.addAction(action);
    } else {
        m_window.addAction(action); // keys work with the menu bar hidden, too
    }
}

void Actions::addFileAndEdit()
{
    const auto keys = [](QKeySequence::StandardKey key) { return QKeySequence::keyBindings(key); };
    add(Command::New, tr("&New…"), "new", keys(QKeySequence::New));
    add(Command::Open, tr("&Open…"), "open", keys(QKeySequence::Open));
    add(Command::Save, tr("&Save"), "save", keys(QKeySequence::Save));
    add(Command::SaveAs, tr("Save &As…"), "", {QKeySequence(tr("Ctrl+Shift+S"))});
    add(Command::Export, tr("&Export…"), "export", {QKeySequence(tr("Ctrl+Shift+E"))});
    add(Command::Close, tr("&Close Window"), "", keys(QKeySequence::Close));
    add(Command::Quit, tr("&Quit"), "", {QKeySequence(tr("Ctrl+Q"))});
    m_actions[Command::Quit]->setMenuRole(QAction::QuitRole);
    add(Command::Undo, tr("&Undo"), "undo", keys(QKeySequence::Undo));
    add(Command::Redo, tr("&Redo"), "redo", {QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
    add(Command::Delete, tr("&Delete"), "delete", {QKeySequence(Qt::Key_Delete)});
    add(Command::Duplicate, tr("D&uplicate"), "duplicate", {QKeySequence(tr("Ctrl+D"))});
    add(Command::SelectAll, tr("Select &All"), "", keys(QKeySequence::SelectAll));
    add(Command::Deselect, tr("D&eselect"), "", {QKeySequence(tr("Ctrl+Shift+A"))});
    add(Command::Settings, tr("Se&ttings…"), "", {QKeySequence(tr("Ctrl+,"))});
    m_actions[Command::Settings]->setMenuRole(QAction::PreferencesRole);
}

void Actions::addTools()
{
    add(Command::Brush, tr("&Brush"), "brush", {QKeySequence(Qt::Key_B)}, tr("Paint strokes"));
    add(Command::Select, tr("&Select"), "select", {QKeySequence(Qt::Key_V)}, tr("Select and move strokes"));
    add(Command::Segments, tr("Se&gments"), "segments", {QKeySequence(Qt::Key_N)}, tr("Select segments of strokes"));
    add(Command::Pan, tr("&Hand"), "pan", {QKeySequence(Qt::Key_H)}, tr("Move the canvas"));
    auto *group = new QActionGroup(this);
    for (const Command command : {Command::Brush, Command::Select, Command::Segments, Command::Pan}) {
        m_actions[command]->setCheckable(true);
        group->addAction(m_actions[command]);
    }
    add(Command::Raise, tr("&Raise"), "raise", {QKeySequence(Qt::Key_PageUp)});
    add(Command::Lower, tr("&Lower"), "lower", {QKeySequence(Qt::Key_PageDown)});
    add(Command::Top, tr("Raise to &Top"), "top", {QKeySequence(Qt::Key_Home)});
    add(Command::Bottom, tr("Lower to &Bottom"), "bottom", {QKeySequence(Qt::Key_End)});
}

void Actions::addViewAndHelp()
{
    // "=" is the unshifted "+" on many keyboards.
    add(Command::ZoomIn, tr("Zoom &In"), "zoom-in",
        {QKeySequence(Qt::Key_Plus), QKeySequence(Qt::Key_Equal), QKeySequence(QKeySequence::ZoomIn)});
    add(Command::ZoomOut, tr("Zoom &Out"), "zoom-out",
        {QKeySequence(Qt::Key_Minus), QKeySequence(QKeySequence::ZoomOut)});
    add(Command::Zoom100, tr("&100 %"), "", {QKeySequence(Qt::Key_1)});
    add(Command::Fit, tr("&Fit the Canvas"), "fit", {QKeySequence(Qt::Key_0)});
    add(Command::RotateLeft, tr("Turn &Left"), "", {QKeySequence(Qt::Key_4)});
    add(Command::RotateRight, tr("Turn &Right"), "", {QKeySequence(Qt::Key_6)});
    add(Command::ResetRotation, tr("&Upright"), "", {QKeySequence(Qt::Key_5)});
    add(Command::Mirror, tr("&Mirror"), "", {QKeySequence(Qt::Key_M)});
    add(Command::HideDocks, tr("&Hide the Docks"), "", {QKeySequence(Qt::Key_Tab)});
    add(Command::FullScreen, tr("F&ull Screen"), "", {QKeySequence(Qt::Key_F11)});
    m_actions[Command::Mirror]->setCheckable(true);
    m_actions[Command::HideDocks]->setCheckable(true);
    m_actions[Command::FullScreen]->setCheckable(true);
    add(Command::Shortcuts, tr("&Keyboard Shortcuts…"), "", {QKeySequence(Qt::Key_F1)});
    add(Command::About, tr("&About Suffuse…"), "", {});
    m_actions[Command::About]->setMenuRole(QAction::AboutRole);
}

QList<QAction *> Actions::all() const
{
    QList<QAction *> list;
    for (const auto &[command, action] : m_actions)
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
    QMenu *file = addMenu(tr("&File"), {New, Open, Save, SaveAs, Export, Close, Quit});
    m_recentMenu = new QMenu(tr("Open &Recent"), file);
    file->insertMenu(m_actions[Save], m_recentMenu);
    file->insertSeparator(m_actions[Save]);
    file->insertSeparator(m_actions[Export]);
    file->insertSeparator(m_actions[Close]);
    QMenu *edit = addMenu(tr("&Edit"), {Undo, Redo, Delete, Duplicate, SelectAll, Deselect, Settings});
    edit->insertSeparator(m_actions[Delete]);
    edit->insertSeparator(m_actions[SelectAll]);
    edit->insertSeparator(m_actions[Settings]);
    QMenu *view = addMenu(tr("&View"), {ZoomIn, ZoomOut, Zoom100, Fit, RotateLeft, RotateRight, ResetRotation, Mirror});
    view->insertSeparator(m_actions[RotateLeft]);
    view->addSeparator();
    m_docksMenu = view->addMenu(tr("&Docks"));
    view->addAction(m_actions[HideDocks]);
    view->addAction(m_actions[FullScreen]);
    addMenu(tr("&Stroke"), {Raise, Lower, Top, Bottom});
    addMenu(tr("&Tools"), {Brush, Select, Segments, Pan});
    addMenu(tr("&Help"), {Shortcuts, About});
}

QToolBar *Actions::makeToolBar()
{
    auto *bar = new QToolBar(tr("Tools"), &m_window);
    bar->setObjectName("tools");
    bar->setIconSize(QSize(22, 22));
    bar->setOrientation(Qt::Vertical);
    using enum Command;
    for (const Command command : {Brush, Select, Segments, Pan})
        bar->addAction(m_actions[command]);
    bar->addSeparator();
    for (const Command command : {Undo, Redo})
        bar->addAction(m_actions[command]);
    bar->addSeparator();
    for (const Command command : {ZoomIn, ZoomOut, Fit})
        bar->addAction(m_actions[command]);
    return bar;
}

} // namespace suffuse
