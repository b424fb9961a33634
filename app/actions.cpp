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
    "new",
    "open",
    "save",
    "saveAs",
    "keepHistory",
    "importStrokes",
    "importUnderlay",
    "export",
    "close",
    "quit",
    "undo",
    "redo",
    "cut",
    "copy",
    "paste",
    "pasteInPlace",
    "delete",
    "duplicate",
    "selectAll",
    "deselect",
    "settings",
    "brush",
    "select",
    "segments",
    "knife",
    "eraser",
    "attributeBrush",
    "eyedropper",
    "pan",
    "raise",
    "lower",
    "top",
    "bottom",
    "insertNodes",
    "nodeCorner",
    "nodeSmooth",
    "nodeSymmetric",
    "breakNodes",
    "joinNodes",
    "deleteSegments",
    "bridgeSegments",
    "reverseStrokes",
    "invertSelection",
    "sameColour",
    "sameStyle",
    "sameBrush",
    "lasso",
    "touchPath",
    "group",
    "ungroup",
    "lock",
    "unlockAll",
    "hide",
    "showAll",
    "rename",
    "flipAcross",
    "flipDown",
    "quarterLeft",
    "quarterRight",
    "scaleSpread",
    "alignLeft",
    "alignCentre",
    "alignRight",
    "alignTop",
    "alignMiddle",
    "alignBottom",
    "alignToSelection",
    "alignToLast",
    "alignToFirst",
    "alignToBiggest",
    "alignToCanvas",
    "distributeGapsAcross",
    "distributeGapsDown",
    "distributeCentresAcross",
    "distributeCentresDown",
    "snapToNodes",
    "snapToGrid",
    "showGrid",
    "gridStep",
    "showUnderlay",
    "play",
    "toStart",
    "previousStroke",
    "nextStroke",
    "toEnd",
    "loopPlaying",
    "skipPauses",
    "letDry",
    "freezeNow",
    "rewet",
    "removeRewetting",
    "paceEven",
    "paceEaseIn",
    "paceEaseOut",
    "paceEaseInOut",
    "finalPreview",
    "exportTimelapse",
    "favourite1",
    "favourite2",
    "favourite3",
    "favourite4",
    "favourite5",
    "favourite6",
    "favourite7",
    "favourite8",
    "favourite9",
    "smallerSize",
    "largerSize",
    "lessOpacity",
    "moreOpacity",
    "holdToPan",
    "holdToTurn",
    "zoomIn",
    "zoomOut",
    "zoom100",
    "fit",
    "rotateLeft",
    "rotateRight",
    "resetRotation",
    "mirror",
    "hideDocks",
    "fullScreen",
    "shortcuts",
    "about",
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
    case Command::InsertNodes:
    case Command::NodeCorner:
    case Command::NodeSmooth:
    case Command::NodeSymmetric:
    case Command::BreakNodes:
    case Command::JoinNodes:
    case Command::DeleteSegments:
    case Command::BridgeSegments:
    case Command::ReverseStrokes:
    case Command::RenameStrokes:
    case Command::HideDocks:
    case Command::HoldToPan:
    case Command::HoldToTurn:
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
    addNodeCommands();
    addObjects();
    addTime();
    addFavourites();
    addToolKeys();
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
    add(Command::KeepHistory, tr("Keep Undo &History in the File"), "", {},
        tr("Whoever opens the file can go on undoing. Take it out before you give a file away"));
    m_actions[Command::KeepHistory]->setCheckable(true);
    add(Command::ImportStrokes, tr("&Import Strokes…"), "", {},
        tr("Drawings, recordings and the strokes of other paintings, into this one"));
    add(Command::ImportUnderlay, tr("Import &Underlay…"), "", {},
        tr("A picture to paint over, which shows on the canvas only"));
    add(Command::Export, tr("&Export…"), "export", {QKeySequence(tr("Ctrl+Shift+E"))});
    add(Command::Close, tr("&Close Window"), "", keys(QKeySequence::Close));
    add(Command::Quit, tr("&Quit"), "", {QKeySequence(tr("Ctrl+Q"))});
    m_actions[Command::Quit]->setMenuRole(QAction::QuitRole);
    add(Command::Undo, tr("&Undo"), "undo", keys(QKeySequence::Undo));
    add(Command::Redo, tr("&Redo"), "redo", {QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
    add(Command::Cut, tr("Cu&t"), "cut", keys(QKeySequence::Cut));
    add(Command::Copy, tr("&Copy"), "copy", keys(QKeySequence::Copy));
    add(Command::Paste, tr("&Paste"), "paste", keys(QKeySequence::Paste),
        tr("Paste strokes or SVG paths at the pointer; a colour becomes the current one"));
    add(Command::PasteInPlace, tr("Paste &in Place"), "", {QKeySequence(tr("Ctrl+Alt+V"))},
        tr("Paste strokes where they were"));
    add(Command::Delete, tr("&Delete"), "delete", {QKeySequence(Qt::Key_Delete)});
    add(Command::Duplicate, tr("Dup&licate"), "duplicate", {QKeySequence(tr("Ctrl+D"))});
    add(Command::SelectAll, tr("Select &All"), "", keys(QKeySequence::SelectAll));
    add(Command::Deselect, tr("D&eselect"), "", {QKeySequence(tr("Ctrl+Shift+A"))});
    add(Command::Settings, tr("Settin&gs…"), "", {QKeySequence(tr("Ctrl+,"))});
    m_actions[Command::Settings]->setMenuRole(QAction::PreferencesRole);
}

void Actions::addTools()
{
    add(Command::Brush, tr("&Brush"), "brush", {QKeySequence(Qt::Key_B)}, tr("Paint strokes"));
    add(Command::Select, tr("&Select"), "select", {QKeySequence(Qt::Key_V)}, tr("Select and move strokes"));
    add(Command::Segments, tr("Se&gments"), "segments", {QKeySequence(Qt::Key_N)},
        tr("Edit segments, nodes and handles of strokes"));
    add(Command::Pan, tr("&Hand"), "pan", {QKeySequence(Qt::Key_H)}, tr("Move the canvas"));
    auto *group = new QActionGroup(this);
    add(Command::Knife, tr("&Knife"), "knife", {QKeySequence(Qt::Key_K)}, tr("Cut strokes along a line"));
    add(Command::Eraser, tr("&Eraser"), "eraser", {QKeySequence(Qt::Key_E)}, tr("Erase parts of strokes"));
    add(Command::AttributeBrush, tr("&Attribute Brush"), "attribute-brush", {QKeySequence(Qt::Key_A)},
        tr("Paint values onto segments"));
    add(Command::Eyedropper, tr("Eye&dropper"), "eyedropper", {QKeySequence(Qt::Key_I)}, tr("Pick a colour"));
    for (const Command command : {Command::Brush, Command::Select, Command::Segments, Command::Knife, Command::Eraser,
                                  Command::AttributeBrush, Command::Eyedropper, Command::Pan}) {
        m_actions[command]->setCheckable(true);
        group->addAction(m_actions[command]);
    }
    add(Command::Raise, tr("&Raise"), "raise", {QKeySequence(Qt::Key_PageUp)});
    add(Command::Lower, tr("&Lower"), "lower", {QKeySequence(Qt::Key_PageDown)});
    add(Command::Top, tr("Raise to &Top"), "top", {QKeySequence(Qt::Key_Home)});
    add(Command::Bottom, tr("Lower to &Bottom"), "bottom", {QKeySequence(Qt::Key_End)});
}

void Actions::addNodeCommands()
{
    add(Command::InsertNodes, tr("&Insert Nodes"), "node-insert", {QKeySequence(Qt::Key_Insert)},
        tr("Insert a node into each selected segment"));
    add(Command::NodeCorner, tr("&Corner"), "node-corner", {QKeySequence(tr("Shift+C"))},
        tr("Make the selected nodes corners"));
    add(Command::NodeSmooth, tr("&Smooth"), "node-smooth", {QKeySequence(tr("Shift+S"))},
        tr("Make the selected nodes smooth"));
    add(Command::NodeSymmetric, tr("S&ymmetric"), "node-symmetric", {QKeySequence(tr("Shift+Y"))},
        tr("Make the selected nodes symmetric"));
    add(Command::BreakNodes, tr("&Break Strokes"), "node-break", {QKeySequence(tr("Shift+B"))},
        tr("Break strokes at the selected nodes"));
    add(Command::JoinNodes, tr("&Join Nodes"), "node-join", {QKeySequence(tr("Shift+J"))},
        tr("Join two selected end nodes"));
    add(Command::DeleteSegments, tr("&Delete Segments"), "segment-delete", {QKeySequence(tr("Ctrl+Del"))},
        tr("Delete the selected segments, so that strokes split"));
    add(Command::BridgeSegments, tr("Brid&ge Segments"), "bridge", {QKeySequence(tr("Alt+Del"))},
        tr("Replace selected segments by one that goes on smoothly"));
    add(Command::ReverseStrokes, tr("&Reverse"), "reverse", {QKeySequence(tr("Shift+R"))},
        tr("Let the selected strokes run from end to start"));
}

void Actions::addViewAndHelp()
{
    // "=" is the unshifted "+" on many keyboards.
    add(Command::ZoomIn, tr("Zoom &In"), "zoom-in",
        {QKeySequence(Qt::Key_Plus), QKeySequence(Qt::Key_Equal), QKeySequence(QKeySequence::ZoomIn)});
    add(Command::ZoomOut, tr("Zoom &Out"), "zoom-out",
        {QKeySequence(Qt::Key_Minus), QKeySequence(QKeySequence::ZoomOut)});
    add(Command::Zoom100, tr("&100 %"), "", {QKeySequence(tr("Ctrl+1"))});
    add(Command::Fit, tr("&Fit the Canvas"), "fit", {QKeySequence(Qt::Key_0)});
    add(Command::RotateLeft, tr("Turn &Left"), "", {QKeySequence(tr("Ctrl+4"))});
    add(Command::RotateRight, tr("Turn &Right"), "", {QKeySequence(tr("Ctrl+6"))});
    add(Command::ResetRotation, tr("&Upright"), "", {QKeySequence(tr("Ctrl+5"))});
    add(Command::Mirror, tr("&Mirror"), "", {QKeySequence(Qt::Key_M)});
    add(Command::HideDocks, tr("&Hide the Docks"), "", {QKeySequence(Qt::Key_Tab)});
    add(Command::FullScreen, tr("Full S&creen"), "", {QKeySequence(Qt::Key_F11)});
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
    QMenu *file = addMenu(tr("&File"), {New, Open, Save, SaveAs, KeepHistory, ImportStrokes, ImportUnderlay, Export,
                                        ExportTimelapse, Close, Quit});
    m_recentMenu = new QMenu(tr("Open &Recent"), file);
    file->insertMenu(m_actions[Save], m_recentMenu);
    file->insertSeparator(m_actions[Save]);
    file->insertSeparator(m_actions[ImportStrokes]);
    file->insertSeparator(m_actions[Close]);
    QMenu *edit = addMenu(
        tr("&Edit"), {Undo, Redo, Cut, Copy, Paste, PasteInPlace, Delete, Duplicate, SelectAll, Deselect, Settings});
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
    view->addAction(m_actions[HideDocks]);
    view->addAction(m_actions[FullScreen]);
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
    addMenu(tr("&Help"), {Shortcuts, About});
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
    return bar;
}

} // namespace suffuse
