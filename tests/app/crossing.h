// Three strokes that cross, and what opens there.
#pragma once

#include "app/tools/brush/brush_palette.h"
#include "app/window/pointer/value_card.h"
#include "tests/app/selecting.h"

#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>

namespace suffuse {

/// Three strokes that cross at (400, 300), and the window in front.
struct Crossing : Selecting {
    Crossing()
        : Selecting({line(1, {200, 300}, {600, 300}), line(2, {400, 100}, {400, 500}), line(3, {300, 200}, {500, 400})})
    {
        window.activateWindow();
        (void)QTest::qWaitForWindowActive(&window);
        canvas().setFocus();
    }
    QMenu &menu() { return *window.findChild<QMenu *>("canvasMenu"); }
    void askAt(Point where, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseClick(&canvas(), Qt::RightButton, modifiers, at(where));
    }
    void key(int key, Qt::KeyboardModifiers modifiers = {})
    {
        QWidget *focus = QApplication::focusWidget();
        QTest::keyClick(focus ? focus : &canvas(), Qt::Key(key), modifiers);
    }
    QStringList texts()
    {
        QStringList list;
        for (const QAction *action : menu().actions())
            if (!action->isSeparator())
                list << plainTitle(action->text());
        return list;
    }
    QAction *entry(const QString &title) { return entryIn(menu(), title); }
    static QAction *entryIn(const QMenu &menu, const QString &title)
    {
        for (QAction *action : menu.actions())
            if (plainTitle(action->text()).contains(title))
                return action;
        return nullptr;
    }
    /// An entry of a menu below.
    QAction *entry(const QString &menu, const QString &title)
    {
        const QAction *above = entry(menu);
        return above && above->menu() ? entryIn(*above->menu(), title) : nullptr;
    }
    BrushPalette *palette() { return window.findChild<BrushPalette *>(); }
    ValueCard *values() { return window.findChild<ValueCard *>(); }
    void doubleClick(Point where)
    {
        click(where);
        send(QEvent::MouseButtonDblClick, at(where), none);
        send(QEvent::MouseButtonRelease, at(where), none);
    }
    bool canvasHasKeyboard() { return QApplication::focusWidget() == &canvas(); }
};

/// Letters that two entries of a menu, or of one below it, share.
inline QStringList sharedLetters(const QMenu &menu)
{
    QStringList shared;
    QString taken;
    for (const QAction *action : menu.actions()) {
        static const QRegularExpression letter("&([^&])");
        if (const auto match = letter.match(QString(action->text()).remove("&&")); match.hasMatch()) {
            if (taken.contains(match.captured(1), Qt::CaseInsensitive))
                shared << menu.title() + ": " + action->text();
            taken += match.captured(1);
        }
        if (action->menu())
            shared += sharedLetters(*action->menu());
    }
    return shared;
}

/// Types into a field and presses Return there.
inline void enter(QLineEdit &field, const QString &text)
{
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

} // namespace suffuse
