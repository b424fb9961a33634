// A field that says what is searched for in a list.
#pragma once

#include <QKeyEvent>
#include <QLineEdit>

namespace suffuse {

/// Esc ends the search, and only then leaves the field.
class SearchField : public QLineEdit {
public:
    using QLineEdit::QLineEdit;

protected:
    void keyPressEvent(QKeyEvent *event) override
    {
        if (event->key() != Qt::Key_Escape || text().isEmpty())
            return QLineEdit::keyPressEvent(event);
        clear();
        event->accept();
    }
};

} // namespace suffuse
