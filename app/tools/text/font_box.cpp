#include "app/tools/text/font_box.h"

#include <QCompleter>
#include <QFontDatabase>
#include <QKeyEvent>
#include <QLineEdit>

namespace suffuse {

FontBox::FontBox(QWidget *parent) : QComboBox(parent)
{
    setEditable(true);
    setInsertPolicy(NoInsert);
    setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(13);
    completer()->setFilterMode(Qt::MatchContains);
    completer()->setCompletionMode(QCompleter::PopupCompletion);
    connect(this, &QComboBox::activated, this, &FontBox::take);
    connect(lineEdit(), &QLineEdit::editingFinished, this, &FontBox::take);
}

void FontBox::setFamily(const QString &family)
{
    m_family = family;
    if (!lineEdit()->hasFocus() || lineEdit()->text().compare(family, Qt::CaseInsensitive) != 0)
        setEditText(family);
    lineEdit()->setCursorPosition(0);
}

void FontBox::fill()
{
    if (count() > 0)
        return;
    const QString shown = currentText();
    for (const QString &family : QFontDatabase::families())
        if (!QFontDatabase::isPrivateFamily(family))
            addItem(family);
    setEditText(shown);
}

void FontBox::take()
{
    const int index = findText(currentText(), Qt::MatchFixedString);
    if (index < 0) {
        setEditText(m_family);
        return;
    }
    const QString family = itemText(index);
    if (family == m_family)
        return;
    m_family = family;
    emit chosen(family);
}

void FontBox::showPopup()
{
    fill();
    setCurrentIndex(findText(m_family, Qt::MatchFixedString));
    QComboBox::showPopup();
}

void FontBox::focusInEvent(QFocusEvent *event)
{
    fill();
    QComboBox::focusInEvent(event);
}

void FontBox::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape)
        setEditText(m_family);
    QComboBox::keyPressEvent(event);
}

void FontBox::wheelEvent(QWheelEvent *event)
{
    fill();
    QComboBox::wheelEvent(event);
}

} // namespace suffuse
