#include "app/widgets/habits/keyboard_focus.h"

#include "app/session/commands/keys.h"
#include "app/widgets/habits/entry_field.h"
#include "app/widgets/habits/panel_walk.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcutEvent>
#include <QStatusBar>
#include <QTabBar>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QTreeView>

#include <algorithm>
#include <utility>

namespace suffuse {

namespace {

/// Whether a key types, moves or deletes. Keys that stand for a command everywhere, such as function keys, do not; but
/// F2 renames in lists.
bool isTyped(const QKeyEvent &key)
{
    return isTypedKey(QKeyCombination(key.modifiers(), Qt::Key(key.key())));
}

/// Whether a key does something where it is pressed. Modifier keys and F6 by themselves only lead there and on.
bool isUse(const QKeyEvent &key)
{
    switch (key.key()) {
    case Qt::Key_Shift:
    case Qt::Key_Control:
    case Qt::Key_Alt:
    case Qt::Key_Meta:
    case Qt::Key_F6:
        return false;
    default:
        return true;
    }
}

bool hasAction(const QWidget &widget, const QKeySequence &keys)
{
    return std::ranges::any_of(widget.actions(),
                               [&](const QAction *action) { return action->shortcuts().contains(keys); });
}

bool isHeldWithShift(const QAction *action)
{
    return std::ranges::any_of(action->shortcuts(), [](const QKeySequence &keys) {
        return !keys.isEmpty() && keys[0].keyboardModifiers() == Qt::ShiftModifier;
    });
}

/// Whether a widget takes typing: not a button, a slider or the like. The timeline does, since it has keys of its own
/// and scrolls.
bool canBeTypedInto(const QWidget &widget)
{
    return qobject_cast<const QLineEdit *>(&widget) || qobject_cast<const QAbstractSpinBox *>(&widget) ||
           qobject_cast<const QComboBox *>(&widget) ||
           (qobject_cast<const QAbstractScrollArea *>(&widget) && !qobject_cast<const QScrollArea *>(&widget));
}

/// Whether a letter would choose a row by the first letter of its name.
bool searchesFor(const QWidget &widget, const QKeyEvent &key)
{
    const auto *combo = qobject_cast<const QComboBox *>(&widget);
    const bool isTree = qobject_cast<const QTreeView *>(&widget); // a tree opens and closes rows by + - *
    if (!qobject_cast<const QAbstractItemView *>(&widget) && !(combo && !combo->isEditable()))
        return false;
    const QString text = key.text();
    return isTyped(key) && !text.isEmpty() && text[0].isPrint() && !text[0].isSpace() &&
           !(isTree && QStringLiteral("+-*").contains(text[0]));
}

/// Something is being done that may ask what stands in a panel.
bool actsOnPanels(QEvent::Type type)
{
    switch (type) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::TabletPress:
    case QEvent::TouchBegin:
    case QEvent::Wheel:
    case QEvent::KeyPress:
    case QEvent::ShortcutOverride:
    case QEvent::InputMethod:
    case QEvent::DragEnter:
    case QEvent::Drop:
        return true;
    default:
        return false;
    }
}

/// Whether an event types a character into a text on the canvas, which no panel has a part in. Panels that followed
/// each of them would hold the letters up.
bool typesIntoCanvas(const QObject &watched, const QEvent &event, const QWidget &canvas)
{
    if (!canvas.testAttribute(Qt::WA_InputMethodEnabled) || // no text is in hand
        (&watched != &canvas && QApplication::focusWidget() != &canvas))
        return false;
    if (event.type() == QEvent::InputMethod)
        return true;
    if (event.type() != QEvent::KeyPress && event.type() != QEvent::ShortcutOverride)
        return false;
    const auto &key = static_cast<const QKeyEvent &>(event);
    return isTypedKey(QKeyCombination(key.modifiers(), Qt::Key(key.key()))) && !key.text().isEmpty() &&
           key.text()[0].isPrint();
}

/// The property of widgets that leave the keyboard after clicks.
constexpr char leavesProperty[] = "leavesKeyboardAfterClicks";

bool leavesAfterClicks(const QWidget *widget)
{
    while (widget && !widget->property(leavesProperty).toBool())
        widget = widget->isWindow() ? nullptr : widget->parentWidget();
    return widget;
}

/// Whether a click elsewhere is about something else than the field that has the keyboard: on a button, or on the tab
/// of another dock, which may hide the field.
bool endsTyping(const QWidget *clicked, const QWidget &field)
{
    const bool isElsewhere =
        clicked && clicked != &field && !clicked->isAncestorOf(&field) && !field.isAncestorOf(clicked);
    return isElsewhere && (qobject_cast<const QAbstractButton *>(clicked) || qobject_cast<const QTabBar *>(clicked));
}

/// Whether a widget is the editor of a row in a list.
bool isRowEditor(const QWidget *widget)
{
    const QWidget *viewport = widget ? widget->parentWidget() : nullptr;
    const auto *view = viewport ? qobject_cast<const QAbstractItemView *>(viewport->parentWidget()) : nullptr;
    return view && view->viewport() == viewport;
}

/// Does with Return what Qt does with Space alone.
void press(QAbstractButton &button)
{
    auto *tool = qobject_cast<QToolButton *>(&button);
    if (tool && tool->popupMode() == QToolButton::InstantPopup)
        tool->showMenu();
    else
        button.click();
}

/// Whether an arrow key would lead from a button to another panel, as Qt lets it, where the next one would do something
/// that nobody means.
bool leadsOutOf(const QWidget &panel, QWidget &button, const QKeyEvent &key)
{
    const bool forward = key.key() == Qt::Key_Right || key.key() == Qt::Key_Down;
    if (!forward && key.key() != Qt::Key_Left && key.key() != Qt::Key_Up)
        return false;
    QWidget *next = &button;
    do
        next = forward ? next->nextInFocusChain() : next->previousInFocusChain();
    while (next != &button && !(takesFocus(*next) && next->isVisible()));
    return !panel.isAncestorOf(next);
}

} // namespace

KeyboardFocus::KeyboardFocus(QMainWindow &window, QWidget &canvas)
    : QObject(&window), m_window(window), m_canvas(canvas), m_walk(*new PanelWalk(window, canvas, this))
{
    qApp->installEventFilter(this);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget *old, QWidget *now) {
        if (now && now->windowType() == Qt::Popup)
            return; // A menu comes back to where it was opened.
        // What had the keyboard has gone, with its section for example, and Qt has given it to whatever came next.
        if (old && now && !old->isVisible() && old->window() == &m_window && panelOf(now))
            QTimer::singleShot(0, this, &KeyboardFocus::toCanvas);
        m_walk.leave(now);
        if (m_told && now && panelOf(now) != m_told) { // not while the window is being closed
            m_told = nullptr;
            m_window.statusBar()->clearMessage();
        }
        if (const int tab = std::exchange(m_tab, 0); tab && now && panelOf(now) != panelOf(old))
            if (m_walk.tabbed(*now, tab > 0) == &m_canvas)
                say(m_canvas);
    });
    connect(&m_walk, &PanelWalk::framed, this, [this](QWidget *panel) {
        const bool isPanel = panel && panel != &m_canvas;
        if (isPanel)
            say(*panel);
        emit framed(isPanel ? sentenceOf(*panel) : QString());
    });
}

void KeyboardFocus::leaveAfterClicks(QWidget &widget)
{
    widget.setProperty(leavesProperty, true);
}

void KeyboardFocus::toCanvas()
{
    m_window.activateWindow(); // the panel may float
    m_canvas.setFocus(Qt::OtherFocusReason);
}

void KeyboardFocus::toDock(QDockWidget &dock)
{
    m_walk.toDock(dock);
}

void KeyboardFocus::walk(bool forward)
{
    m_walk.walk(forward);
}

QWidget *KeyboardFocus::panelOf(QWidget *widget) const
{
    return m_walk.panelOf(widget);
}

bool KeyboardFocus::keepsFromCanvas(QWidget &widget, const QKeyEvent &key) const
{
    if (!isTyped(key) || &widget == &m_window || &widget == &m_canvas || m_canvas.isAncestorOf(&widget))
        return false;
    if (const QWidget *focus = QApplication::focusWidget(); focus && focus != &widget && widget.isAncestorOf(focus))
        return false; // the widget with the focus has let the event through
    QWidget *panel = panelOf(&widget);
    if (!panel && widget.window() != &m_window)
        return false;
    const QKeySequence keys(QKeyCombination(key.modifiers() & ~Qt::KeypadModifier, Qt::Key(key.key())));
    const bool shift = key.modifiers() & Qt::ShiftModifier;
    for (const QWidget *w = &widget; panel && w; w = w == panel ? nullptr : w->parentWidget())
        // The effect of Shift on a key depends on the keyboard (> is Shift+. on some). Qt's table of shortcuts knows
        // it.
        if (hasAction(*w, keys) || (shift && std::ranges::any_of(w->actions(), isHeldWithShift)))
            return false;
    return true;
}

/// Handles a shortcut that Qt found for a key which the filter had left to it, since the panel might have had a command
/// for it.
bool KeyboardFocus::keepsShortcut(const QObject &owner, const QKeySequence &keys) const
{
    QWidget *focus = QApplication::focusWidget(), *panel = panelOf(focus);
    const auto *action = qobject_cast<const QAction *>(&owner);
    if (!panel || !action || keys.isEmpty() || !isTypedKey(keys[0]))
        return false;
    for (const QWidget *w = focus; w; w = w == panel ? nullptr : w->parentWidget())
        if (std::ranges::any_of(w->actions(), [action](const QAction *own) { return own == action; }))
            return false;
    return true;
}

bool KeyboardFocus::keyPressed(QWidget &widget, const QKeyEvent &key)
{
    QWidget *panel = panelOf(&widget);
    if (!panel) {
        // The tabs of docks that lie over each other belong to none of them.
        const bool isTabs = qobject_cast<QTabBar *>(&widget) && widget.parentWidget() == &m_window;
        if (isTabs && key.key() == Qt::Key_Escape)
            toCanvas();
        return isTabs && key.key() == Qt::Key_Escape;
    }
    const bool leaves = key.key() == Qt::Key_Escape || key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    if (panel == &widget) { // nothing in the panel had a use for the key
        if (std::exchange(m_endsName, false))
            return true; // The key has ended a name, and the list goes on.
        if (leaves)
            toCanvas();
        else
            tellWhoHasIt(*panel, key);
        return leaves;
    }
    if (!widget.hasFocus())
        return false;
    if (auto *button = qobject_cast<QAbstractButton *>(&widget)) {
        const bool isPushed = qobject_cast<QToolButton *>(button) || qobject_cast<QPushButton *>(button);
        if (leaves && isPushed && key.key() != Qt::Key_Escape) {
            press(*button);
            if (qobject_cast<QToolBar *>(panel)) // Who takes a tool goes on with it.
                toCanvas();
            return true;
        }
        if (leadsOutOf(*panel, widget, key))
            return true;
    }
    if (!searchesFor(widget, key))
        return false;
    tellWhoHasIt(*panel, key);
    return true;
}

/// Gives the keyboard back after a click: the mouse has been let go, so the clicked widget has done its work.
void KeyboardFocus::letClicked(const QWidget *clicked)
{
    if (QApplication::mouseButtons() != Qt::NoButton)
        return;
    QWidget *focus = QApplication::focusWidget();
    // This works behind a dialog, too, that the click has opened.
    for (QWidget *had : {focus, m_window.focusWidget()})
        if (had && panelOf(had) && (!canBeTypedInto(*had) || leavesAfterClicks(clicked) || endsTyping(clicked, *had))) {
            if (had == focus)
                toCanvas();
            else
                m_canvas.setFocus(Qt::OtherFocusReason);
        }
}

/// Gives the keyboard back when the list of a combo box closes that a click has opened, whatever was chosen there, and
/// by what. Who goes from field to field by the keyboard stays where they are.
void KeyboardFocus::listClosed(const QWidget &popup)
{
    auto *combo = qobject_cast<QComboBox *>(popup.parentWidget());
    if (!combo || popup.windowType() != Qt::Popup || combo != m_opened || combo->isEditable() || !panelOf(combo))
        return;
    QMetaObject::invokeMethod(
        this,
        [this, combo = QPointer<QComboBox>(combo)] {
            if (combo && combo->hasFocus())
                toCanvas();
        },
        Qt::QueuedConnection);
}

void KeyboardFocus::tellWhoHasIt(QWidget &panel, const QKeyEvent &key)
{
    const bool plain = isTyped(key) && !(key.modifiers() & Qt::ShiftModifier);
    const QList<QAction *> actions = m_window.findChildren<QAction *>();
    if (m_told == &panel || !plain || std::ranges::none_of(actions, [&](const QAction *action) {
            return action->isEnabled() && action->shortcuts().contains(QKeySequence(key.key()));
        }))
        return;
    say(panel);
}

QString KeyboardFocus::sentenceOf(const QWidget &panel) const
{
    const QString title = panel.windowTitle();
    return &panel == &m_canvas ? tr("The canvas has the keyboard.")
           : qobject_cast<const QDockWidget *>(&panel)
               ? tr("The %1 dock has the keyboard; Esc gives it back to the canvas.").arg(title)
               : tr("The tool bar “%1” has the keyboard; Esc gives it back to the canvas.").arg(title);
}

/// The status bar says who has the keyboard.
void KeyboardFocus::say(QWidget &panel)
{
    constexpr int milliseconds = 10'000;
    m_told = &panel;
    m_window.statusBar()->showMessage(sentenceOf(panel), milliseconds);
}

/// What has been typed counts before anything else is done: a tool's button or a shortcut takes no focus, and the field
/// would keep the text for later, when something else may be selected.
void KeyboardFocus::takeTypedBefore(const QObject &watched, QEvent::Type type)
{
    const bool does = type == QEvent::MouseButtonPress || type == QEvent::TabletPress || type == QEvent::TouchBegin ||
                      type == QEvent::Shortcut;
    auto *field = does ? qobject_cast<EntryField *>(QApplication::focusWidget()) : nullptr;
    const auto *widget = qobject_cast<const QWidget *>(&watched);
    // Windows that stay open beside the main one have some of its shortcuts.
    if (!field || &watched == field || (!panelOf(field) && type != QEvent::Shortcut) ||
        (!widget && type != QEvent::Shortcut))
        return;
    if (type == QEvent::Shortcut || !widget->isAncestorOf(field))
        field->takeTyped();
}

bool KeyboardFocus::eventFilter(QObject *watched, QEvent *event)
{
    takeTypedBefore(*watched, event->type());
    if (actsOnPanels(event->type()) && !typesIntoCanvas(*watched, *event, m_canvas))
        emit acting();
    auto *widget = qobject_cast<QWidget *>(watched);
    switch (event->type()) {
    case QEvent::ShortcutOverride:
        if (widget && keepsFromCanvas(*widget, *static_cast<QKeyEvent *>(event))) {
            event->accept(); // the key comes again as a key press
            return true;
        }
        break;
    case QEvent::Shortcut: {
        const auto *shortcut = static_cast<QShortcutEvent *>(event);
        if (keepsShortcut(*watched, shortcut->key()))
            return true;
        break;
    }
    case QEvent::KeyPress:
        noteKey(widget, *static_cast<QKeyEvent *>(event));
        if (widget == m_opened)
            m_opened = nullptr;
        if (widget && panelOf(widget) && isUse(*static_cast<QKeyEvent *>(event)))
            m_walk.keepInFront();
        if (widget && keyPressed(*widget, *static_cast<QKeyEvent *>(event)))
            return true;
        break;
    case QEvent::MouseButtonRelease:
        if (widget &&
            (panelOf(widget) || (qobject_cast<QTabBar *>(widget) &&
                                 widget->parentWidget() == &m_window))) // after the widget has handled the release
            QMetaObject::invokeMethod(
                this, [this, clicked = QPointer<QWidget>(widget)] { letClicked(clicked); }, Qt::QueuedConnection);
        break;
    case QEvent::MouseButtonPress:
        m_namesByKey = false;
        m_walk.unframe();
        if (qobject_cast<QComboBox *>(widget))
            m_opened = widget;
        break;
    case QEvent::Hide:
        if (widget)
            listClosed(*widget);
        break;
    case QEvent::Resize:
    case QEvent::Move:
        m_walk.follow(widget);
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

void KeyboardFocus::noteKey(const QWidget *widget, const QKeyEvent &key)
{
    const bool isReturn = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    // The editor may be gone before the panel hears of the key.
    m_endsName = isReturn && (m_endsName || (m_namesByKey && isRowEditor(widget)));
    m_tab = key.key() == Qt::Key_Tab ? 1 : key.key() == Qt::Key_Backtab ? -1 : 0;
    if (!isRowEditor(widget)) // what is typed in one does not tell how it was opened
        m_namesByKey = true;
}

} // namespace suffuse
