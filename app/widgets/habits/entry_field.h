#pragma once

#include <QLineEdit>

class QDialog;

namespace suffuse {

/// A line of text that is taken as a whole, by Return or by leaving the field. Esc takes back what has been typed, and
/// nothing is taken then. A line edit by itself knows no such text, and hands out whatever it holds when Esc moves the
/// keyboard elsewhere.
class EntryField : public QLineEdit {
    Q_OBJECT

public:
    explicit EntryField(QWidget *parent = nullptr);

    /// For a dialog whose work shows at once: Return shows what a typed text does, and only the next one presses the
    /// default button. Elsewhere Return does both.
    static void letReturnShowFirst(QDialog &dialog);

    /// Takes what has been typed, as Return does.
    void takeTyped() { finish(); }
    /// The same in the field of a window that has the keyboard, if there is one.
    static void takeTypedIn(const QWidget &window);
    /// Shows the text that counts now; emits nothing. What is being typed stays while that text stays the same.
    void showText(const QString &text);
    /// From whoever cannot take what was `typed`: after Return the keyboard stays, so that the keys that are to mend the
    /// text are not the canvas', where letters take tools.
    void refuse() { m_refused = true; }

signals:
    /// Another text has been typed. Whoever takes or refuses it shows the text that counts then.
    void typed(const QString &text);

protected:
    bool event(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;

    /// Shows a text that counts in place of what is being typed.
    void replaceText(const QString &text);

private:
    void finish();

    QString m_shown;        ///< the text that counts
    bool m_refused = false; ///< what was typed last
};

} // namespace suffuse
