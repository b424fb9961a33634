#include "app/widgets/habits/mnemonics.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSet>
#include <QTabWidget>

#include <algorithm>
#include <vector>

namespace suffuse {

namespace {

/// A widget that shows a text with a mnemonic, and the page of a tab widget that it is on. Pages are never seen
/// together.
struct Holder {
    QWidget *widget;
    const QWidget *page;
};

bool isLatin(QChar c)
{
    return (c >= u'a' && c <= u'z') || (c >= u'A' && c <= u'Z');
}

QChar mnemonicOf(const QString &text)
{
    for (qsizetype i = 0; i + 1 < text.size(); ++i)
        if (text[i] == u'&' && text[++i] != u'&')
            return text[i].toUpper();
    return {};
}

/// Places where a mnemonic could stand in the text, the best first: at the start of words, then anywhere.
std::vector<qsizetype> placesIn(const QString &text)
{
    std::vector<qsizetype> starts, others;
    for (qsizetype i = 0; i < text.size(); ++i)
        if (isLatin(text[i]))
            (i == 0 || text[i - 1].isSpace() ? starts : others).push_back(i);
    starts.insert(starts.end(), others.begin(), others.end());
    return starts;
}

/// The text with a mnemonic; empty if no letter is left.
QString withMnemonic(QString text, const QSet<QChar> &taken)
{
    const std::vector<qsizetype> places = placesIn(text);
    for (const qsizetype place : places)
        if (!taken.contains(text[place].toUpper()))
            return text.insert(place, u'&');
    for (char16_t key = u'A'; key <= u'Z'; ++key) // capital letters, as in Chinese menus
        if (!taken.contains(key))
            return QStringLiteral("%1(&%2)").arg(text, QChar(key));
    return {};
}

QString textOf(const QWidget *widget)
{
    const auto *label = qobject_cast<const QLabel *>(widget);
    return label ? label->text() : static_cast<const QAbstractButton *>(widget)->text();
}

void setText(QWidget *widget, const QString &text)
{
    if (auto *label = qobject_cast<QLabel *>(widget))
        label->setText(text);
    else
        static_cast<QAbstractButton *>(widget)->setText(text);
}

const QWidget *pageOf(const QWidget *widget, const QList<QTabWidget *> &tabs)
{
    for (const QTabWidget *tab : tabs)
        for (int i = 0; i < tab->count(); ++i)
            if (tab->widget(i)->isAncestorOf(widget))
                return tab->widget(i);
    return nullptr;
}

std::vector<Holder> holdersIn(const QWidget &dialog)
{
    const QList<QTabWidget *> tabs = dialog.findChildren<QTabWidget *>();
    std::vector<Holder> holders;
    for (QWidget *widget : dialog.findChildren<QWidget *>()) {
        const auto *label = qobject_cast<const QLabel *>(widget);
        const bool holds = label ? label->buddy() != nullptr
                                 : qobject_cast<QCheckBox *>(widget) || qobject_cast<QPushButton *>(widget);
        if (holds && !textOf(widget).isEmpty() && widget->window() == dialog.window())
            holders.push_back({widget, pageOf(widget, tabs)});
    }
    // Texts of a single letter come first, since they have no choice.
    std::ranges::stable_partition(holders, [](const Holder &holder) { return textOf(holder.widget).size() == 1; });
    return holders;
}

} // namespace

void giveMnemonics(QWidget &dialog)
{
    const std::vector<Holder> holders = holdersIn(dialog);
    for (const Holder &holder : holders) {
        if (!mnemonicOf(textOf(holder.widget)).isNull())
            continue;
        QSet<QChar> taken;
        for (const Holder &other : holders)
            if (!holder.page || !other.page || other.page == holder.page)
                taken << mnemonicOf(textOf(other.widget));
        if (const QString text = withMnemonic(textOf(holder.widget), taken); !text.isEmpty())
            setText(holder.widget, text);
    }
}

} // namespace suffuse
