// A card of fields that lies over a window, where the pointer is.
#pragma once

#include <QFrame>
#include <QPointer>

namespace suffuse {

/// Lies within the window of the widget that it serves, and takes the keyboard while it is there. It closes by Esc, by
/// Return where no field has a use for it, by the keys of its own actions, and by a press elsewhere in the window,
/// which does what it does anyway: a press on the canvas paints. The keyboard then goes back to the widget it serves.
/// It is no window, so that a pen reaches the canvas beside it at once.
class FloatingCard : public QFrame {
    Q_OBJECT

public:
    explicit FloatingCard(QWidget &served);

    /// Shows it with `anchor`, a point of its own, at a place on the screen, as far as the window has room there; the
    /// child gets the keyboard.
    void openAt(QPoint global, QPoint anchor, QWidget *child);
    void close();
    bool isOpen() const { return isVisible(); }
    /// Whether a widget is a card or on one; null is not.
    static bool holds(const QWidget *widget);

signals:
    void closed();

protected:
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    bool focusNextPrevChild(bool next) override;

private:
    void keepInside();
    bool isOwnKey(const QKeyEvent &event) const;

    QWidget &m_served;
};

} // namespace suffuse
