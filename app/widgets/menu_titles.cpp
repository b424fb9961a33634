#include "app/widgets/menu_titles.h"

#include "app/session/commands/commands.h"

#include <QMenu>
#include <QSet>

namespace suffuse {

namespace {

/// The menu that an action is in; none: null. An action may be in tool bars, too, and in the nameless menu that a menu
/// bar without room has at its end.
const QMenu *menuOf(const QAction &action)
{
    for (const QObject *place : action.associatedObjects())
        if (const auto *menu = qobject_cast<const QMenu *>(place); menu && !menu->title().isEmpty())
            return menu;
    return nullptr;
}

} // namespace

QString titleWithMenus(const QAction &action)
{
    QString title = plainTitle(action.iconText());
    for (const QMenu *menu = menuOf(action); menu; menu = menuOf(*menu->menuAction()))
        title.prepend(plainTitle(menu->title()) + QStringLiteral(" ▸ "));
    return title;
}

namespace {

/// The place of the letter behind the ampersand; −1: none.
qsizetype mnemonicAt(const QString &text)
{
    for (qsizetype i = 0; i + 1 < text.size(); ++i)
        if (text[i] == u'&') {
            if (text[i + 1] != u'&')
                return i + 1;
            ++i;
        }
    return -1;
}

/// The text with a letter that is free. In brackets behind a text in Chinese it may be any.
QString withFreeLetter(const QString &text, const QSet<QChar> &taken)
{
    const qsizetype at = mnemonicAt(text);
    if (at < 0 || !taken.contains(text[at].toLower()))
        return text;
    if (at >= 2 && text[at - 2] == u'(' && text.endsWith(u')')) {
        for (char16_t letter = u'a'; letter <= u'z'; ++letter)
            if (!taken.contains(letter))
                return text.left(at) + QChar(letter).toUpper() + text.mid(at + 1);
    }
    const QString plain = text.left(at - 1) + text.mid(at);
    for (qsizetype i = 0; i < plain.size(); ++i)
        if (plain[i].isLetter() && !taken.contains(plain[i].toLower()))
            return plain.left(i) + u'&' + plain.mid(i);
    return plain;
}

} // namespace

void makeMnemonicsDistinct(QMenu &menu)
{
    const auto isOwn = [&menu](const QAction *action) {
        return action->parent() == &menu || (action->menu() && action->menu()->parent() == &menu);
    };
    QSet<QChar> taken;
    const auto take = [&taken](const QString &text) {
        if (const qsizetype at = mnemonicAt(text); at >= 0)
            taken.insert(text[at].toLower());
    };
    for (const QAction *action : menu.actions())
        if (!isOwn(action))
            take(action->text());
    for (QAction *action : menu.actions())
        if (isOwn(action)) {
            action->setText(withFreeLetter(action->text(), taken));
            take(action->text());
        }
}

} // namespace suffuse
