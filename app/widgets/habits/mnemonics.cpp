#include "app/widgets/habits/mnemonics.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSet>
#include <QTabWidget>

#include <algorithm>
#include <cmath>
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

/// An underlined letter is drawn by itself, without the kerning with which Qt measures a label, which then would cut
/// the end of its text: of "Te" and "Va" that is some pixels.
void keepRoom(QLabel &label, const QString &text, qsizetype letter)
{
    const QFontMetricsF metrics(label.font());
    const double apart = metrics.horizontalAdvance(text.left(letter)) + metrics.horizontalAdvance(text[letter]) +
                         metrics.horizontalAdvance(text.mid(letter + 1));
    const double more = apart - metrics.horizontalAdvance(text);
    if (more > 0 && !label.wordWrap())
        label.setMinimumWidth(label.sizeHint().width() + int(std::ceil(more)));
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
    std::stable_partition(holders.begin(), holders.end(),
                          [](const Holder &holder) { return textOf(holder.widget).size() == 1; });
    return holders;
}

/// Finds a letter for each text, no letter twice on what is seen together. A text whose letters are all taken makes
/// another one give up its own, if that has a second one: a matching by augmenting paths.
class Mnemonics {
public:
    explicit Mnemonics(std::vector<Holder> holders) : m_holders(std::move(holders))
    {
        for (const Holder &holder : m_holders)
            m_letters.push_back(mnemonicOf(textOf(holder.widget)));
        m_given.resize(m_holders.size(), -1);
    }

    void find()
    {
        for (std::size_t i = 0; i < m_holders.size(); ++i) {
            QSet<QChar> tried;
            if (m_letters[i].isNull() && !giveOwn(i, tried))
                giveForeign(i);
        }
    }

    void show() const
    {
        for (std::size_t i = 0; i < m_holders.size(); ++i) {
            const QString text = textOf(m_holders[i].widget);
            if (m_given[i] >= 0) {
                setText(m_holders[i].widget, QString(text).insert(m_given[i], u'&'));
                if (auto *label = qobject_cast<QLabel *>(m_holders[i].widget))
                    keepRoom(*label, text, m_given[i]);
            } else if (!m_letters[i].isNull() && mnemonicOf(text).isNull()) {
                setText(m_holders[i].widget, QStringLiteral("%1(&%2)").arg(text, m_letters[i]));
            }
        }
    }

private:
    /// Those seen together with this one that have the letter.
    std::vector<std::size_t> rivals(std::size_t i, QChar letter) const
    {
        std::vector<std::size_t> found;
        for (std::size_t k = 0; k < m_holders.size(); ++k) {
            const QWidget *page = m_holders[i].page, *other = m_holders[k].page;
            if (k != i && m_letters[k] == letter && (!page || !other || page == other))
                found.push_back(k);
        }
        return found;
    }

    /// `tried`: letters that are on their way to somebody already.
    bool giveOwn(std::size_t i, QSet<QChar> &tried)
    {
        const QString text = textOf(m_holders[i].widget);
        for (const bool mayMove : {false, true}) // whoever has a letter keeps it where another one is free
            for (const qsizetype place : placesIn(text)) {
                const QChar letter = text[place].toUpper();
                if (tried.contains(letter))
                    continue;
                if (const std::vector<std::size_t> others = rivals(i, letter); !others.empty()) {
                    if (!mayMove || others.size() > 1 || m_given[others.front()] < 0)
                        continue;
                    tried << letter;
                    if (!giveOwn(others.front(), tried))
                        continue;
                }
                m_letters[i] = letter;
                m_given[i] = place;
                return true;
            }
        return false;
    }

    /// A capital letter behind the text, as in Chinese menus; in Latin writing it would look like a misprint.
    void giveForeign(std::size_t i)
    {
        if (!placesIn(textOf(m_holders[i].widget)).empty())
            return;
        for (char16_t key = u'A'; key <= u'Z' && m_letters[i].isNull(); ++key)
            if (rivals(i, key).empty())
                m_letters[i] = key;
    }

    std::vector<Holder> m_holders;
    std::vector<QChar> m_letters;
    std::vector<qsizetype> m_given; ///< where the letter stands in the text; −1: not in it, or it came with the text
};

} // namespace

void giveMnemonics(QWidget &dialog)
{
    Mnemonics mnemonics(holdersIn(dialog));
    mnemonics.find();
    mnemonics.show();
}

} // namespace suffuse
