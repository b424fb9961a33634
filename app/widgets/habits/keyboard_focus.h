// Decides who has the keyboard in a window: the canvas or a panel.
#pragma once

#include <QEvent>
#include <QObject>
#include <QPointer>

class QKeyEvent;
class QDockWidget;
class QMainWindow;

namespace suffuse {

class PanelWalk;

/// Keeps keys that are typed in a panel (a dock or a tool bar) from the canvas' commands. Without Ctrl, Alt or Meta a
/// key reaches no shortcut of the window except those of the panel itself, which are the actions that the panel or a
/// widget in it has by addAction(), whether or not the panel has a use for the key.
/// Esc and Enter give the keyboard back to the canvas where nothing in the panel has a use for them. So does the
/// release of the mouse over something that cannot be typed into, or that one chooses from to go on at the canvas
/// (`leaveAfterClicks`), and so does a choice from a list that a click has opened. Lists do not go to the row whose
/// name begins with a typed letter: the letter would be a command's key anywhere else, and the status bar says who has
/// the keyboard. Tab passes docks by that are hidden behind others, and shows which panel it has come to. A list in
/// which a name or a number was begun by a key keeps the keyboard when Return ends it.
class KeyboardFocus : public QObject {
    Q_OBJECT

public:
    /// The window owns this object.
    KeyboardFocus(QMainWindow &window, QWidget &canvas);

    /// A click on the widget gives the keyboard back to the canvas, though it can be typed into: what was clicked there
    /// is what the hand goes on with.
    static void leaveAfterClicks(QWidget &widget);

    void toCanvas();
    /// Gives the keyboard to a dock that is shown, and brings it to the front.
    void toDock(QDockWidget &dock);
    /// Gives the keyboard to the next of canvas, docks and tool bars, in the order in which they stand, or to the one
    /// before. A dock that is hidden behind another one is raised. The widget in it that had the keyboard last gets it
    /// again. A frame shows where the keyboard is until something is clicked.
    void walk(bool forward);

    bool eventFilter(QObject *watched, QEvent *event) override;

signals:
    /// Something is pressed, typed, scrolled or dropped, here or in a dialog: panels must be up to date now.
    void acting();
    /// A frame shows that a panel has the keyboard, which this sentence says; it is empty where there is none any more,
    /// or around the canvas.
    void framed(const QString &sentence);

private:
    QWidget *panelOf(QWidget *widget) const;
    bool keepsFromCanvas(QWidget &widget, const QKeyEvent &key) const;
    bool keepsShortcut(const QObject &owner, const QKeySequence &keys) const;
    bool keyPressed(QWidget &widget, const QKeyEvent &key);
    void letClicked(const QWidget *clicked);
    void listClosed(const QWidget &popup);
    void takeTypedBefore(const QObject &watched, QEvent::Type type);
    QString sentenceOf(const QWidget &panel) const;
    void say(QWidget &panel);
    void tellWhoHasIt(QWidget &panel, const QKeyEvent &key);
    void noteKey(const QWidget *widget, const QKeyEvent &key);

    QMainWindow &m_window;
    QWidget &m_canvas;
    PanelWalk &m_walk;
    QPointer<QWidget> m_opened; ///< the widget that was pressed last, and got no key since
    int m_tab = 0;              ///< 1 after Tab, −1 after Shift+Tab
    bool m_namesByKey = false;  ///< a key was pressed, as F2 in a list, and no button since
    bool m_endsName = false;    ///< the key that is being handled ends a name in a list
    QPointer<QWidget> m_told;   ///< the panel of which the status bar has said that it has the keyboard
};

} // namespace suffuse
