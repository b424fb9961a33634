// Goes from panel to panel of a window by the keyboard, and shows where it is.
#pragma once

#include <QObject>
#include <QPointer>

class QDockWidget;
class QMainWindow;
class QWidget;

namespace suffuse {

class PanelFrame;

/// Whether Tab leads to a widget, as soon as it is seen.
bool takesFocus(const QWidget &widget);

/// The way of the keyboard from one panel (a dock or a tool bar) of a window to the next, with the canvas among them.
/// Docks that it brings to the front go back behind the one that stood there unless something is done in them.
class PanelWalk : public QObject {
    Q_OBJECT

public:
    PanelWalk(QMainWindow &window, QWidget &canvas, QObject *parent);
    ~PanelWalk() override;

    /// The panel that a widget is in; null on the canvas and in dialogs.
    QWidget *panelOf(QWidget *widget) const;

    /// Gives the keyboard to the next of canvas, docks and tool bars, or to the one before; see `KeyboardFocus::walk`.
    void walk(bool forward);
    /// Gives the keyboard to a dock that is shown, and brings it to the front, where it stays.
    void toDock(QDockWidget &dock);
    /// Tab has come to a widget of another panel. It goes on to the first one that can be seen. Returns the panel of
    /// that, or the canvas; null where there is none.
    QWidget *tabbed(QWidget &to, bool forward);
    /// What the walk has brought to the front is used, and stays there.
    void keepInFront();

    /// Takes the frame away.
    void unframe();
    /// Takes the frame away if the widget that has the keyboard now, if any, is not in it.
    void leave(const QWidget *now);
    /// Keeps the frame around its panel, which may be this one, that has moved or has another size.
    void follow(const QWidget *moved);

signals:
    /// A frame shows that this panel, or the canvas, has the keyboard; null: there is none any more.
    void framed(QWidget *panel);

private:
    QList<QWidget *> stops() const;
    QDockWidget *inFrontOf(QWidget &stop) const;
    void putBack(const QWidget &stop);
    bool enter(QWidget &stop);
    bool isBehind(QWidget &widget) const;
    void frame(QWidget &stop);

    QMainWindow &m_window;
    QWidget &m_canvas;
    QPointer<PanelFrame> m_frame;
    QPointer<QDockWidget> m_front; ///< the dock that stood in front of the one to which the walk has gone
};

} // namespace suffuse
