// Whose the keyboard is in a window: the canvas', or a panel's.
#pragma once

#include <QObject>
#include <QPointer>

class QKeyEvent;
class QMainWindow;

namespace suffuse {

class PanelFrame;

/// Keeps what is typed in a panel (a dock or a tool bar) from the canvas' commands: without Ctrl, Alt or Meta a key
/// reaches no shortcut of the window but those of the panel itself, which are the actions that the panel or a widget in
/// it has by addAction(). Esc and Enter, where nothing in the panel has a use for them, give the keyboard back; so does
/// the mouse that is let go, where what was clicked cannot be typed into. Lists do not go to the row whose name begins
/// with a letter: it would be a command's key anywhere else, and the status bar says who has the keyboard.
class KeyboardFocus : public QObject {
    Q_OBJECT

public:
    /// Belongs to the window.
    KeyboardFocus(QMainWindow &window, QWidget &canvas);
    ~KeyboardFocus() override;

    void toCanvas();
    /// To the next of canvas, docks and tool bars, in the order in which they stand, or to the one before; a dock that
    /// is hidden behind another is raised. What had the keyboard in it last has it again. A frame shows where the
    /// keyboard is until something is clicked.
    void walk(bool forward);

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *panelOf(QWidget *widget) const;
    bool keepsFromCanvas(QWidget &widget, const QKeyEvent &key) const;
    bool keepsShortcut(const QObject &owner, const QKeySequence &keys) const;
    bool keyPressed(QWidget &widget, const QKeyEvent &key);
    void letClicked();
    void tellWhoHasIt(QWidget &panel, const QKeyEvent &key);
    QList<QWidget *> stops() const;
    bool enter(QWidget &stop);

    QMainWindow &m_window;
    QWidget &m_canvas;
    QPointer<PanelFrame> m_frame;
    QPointer<QWidget> m_told; ///< of this panel the status bar has said that it has the keyboard
};

} // namespace suffuse
