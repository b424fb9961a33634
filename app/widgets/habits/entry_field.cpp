#include "app/widgets/habits/entry_field.h"

#include <QDialog>
#include <QKeyEvent>

namespace suffuse {

namespace {

/// The property of dialogs in which Return only shows what was typed.
constexpr char showsFirstProperty[] = "returnShowsFirst";

} // namespace

EntryField::EntryField(QWidget *parent) : QLineEdit(parent)
{
    connect(this, &QLineEdit::editingFinished, this, &EntryField::finish);
}

void EntryField::letReturnShowFirst(QDialog &dialog)
{
    dialog.setProperty(showsFirstProperty, true);
}

void EntryField::takeTypedIn(const QWidget &window)
{
    if (auto *field = qobject_cast<EntryField *>(window.focusWidget()))
        field->takeTyped();
}

void EntryField::showText(const QString &text)
{
    if (!hasFocus() || !isModified() || text != m_shown)
        replaceText(text);
}

void EntryField::replaceText(const QString &text)
{
    m_shown = text;
    const bool wasSelected = hasFocus() && hasSelectedText() && selectedText() == this->text();
    const int caret = hasFocus() ? cursorPosition() : 0; // who saves while they type goes on where they were
    setText(text);
    setCursorPosition(caret);
    if (wasSelected) // the next typed text replaces all of it, also where the painting has just changed
        selectAll();
    setModified(false);
}

void EntryField::finish()
{
    if (!isModified())
        return;
    if (text() == m_shown)
        return replaceText(m_shown);
    const QString taken = text();
    m_shown = taken;
    setModified(false); // Return and leaving the field take a text once
    m_refused = false;
    emit typed(taken);
}

bool EntryField::event(QEvent *event)
{
    // Where nothing has been typed there is nothing to undo in the field, so the keys undo in the painting.
    if (event->type() == QEvent::ShortcutOverride && !isModified()) {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    return QLineEdit::event(event);
}

void EntryField::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape && isModified()) {
        replaceText(m_shown);
        // In a dialog the key stops here, since Esc would close it; in a panel it goes on and gives the keyboard back.
        event->setAccepted(qobject_cast<QDialog *>(window()));
    } else {
        const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
        const bool takes = isReturn && isModified();
        QLineEdit::keyPressEvent(event);
        if (takes && m_refused)
            selectAll();
        if (takes && (m_refused || window()->property(showsFirstProperty).toBool()))
            event->accept();
    }
}

void EntryField::mouseDoubleClickEvent(QMouseEvent *event)
{
    // Line edits know from this event that a third click selects all. The word that they select now is of 70.9 only 70.
    QLineEdit::mouseDoubleClickEvent(event);
    if (event->button() == Qt::LeftButton)
        selectAll();
}

} // namespace suffuse
