#include "app/dialogs/command_palette.h"

#include "app/widgets/habits/help_page.h"
#include "model/formats/messages.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>

namespace suffuse {

namespace {

constexpr int keysRole = Qt::UserRole, entryRole = Qt::UserRole + 1, enabledRole = Qt::UserRole + 2;
constexpr int usualWidth = 560, rowsShown = 12, rowPadding = 4, keysGap = 12, iconSize = 20;

/// Draws the keys at the end of a row, where a menu has them.
class PaletteRowDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        const int text = option.fontMetrics.height(), icon = option.decorationSize.height();
        return {QStyledItemDelegate::sizeHint(option, index).width(), std::max(text, icon) + 2 * rowPadding};
    }
    void paint(QPainter *painter, const QStyleOptionViewItem &given, const QModelIndex &index) const override
    {
        const QString keys = index.data(keysRole).toString();
        QStyleOptionViewItem option = given;
        initStyleOption(&option, index);
        const int width = keys.isEmpty() ? 0 : option.fontMetrics.horizontalAdvance(keys) + 2 * keysGap;
        const QStyle *style = option.widget ? option.widget->style() : QApplication::style();
        const QString title = option.text;
        option.text.clear();
        // This paints the ground and the icon of the whole row.
        style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);
        const bool selected = option.state & QStyle::State_Selected, enabled = index.data(enabledRole).toBool();
        // Grey letters could not be read on the colour of what is marked; there the line below the list says it.
        painter->setPen(selected
                            ? option.palette.color(QPalette::Active, QPalette::HighlightedText)
                            : option.palette.color(enabled ? QPalette::Active : QPalette::Disabled, QPalette::Text));
        const QRect room =
            option.rect.adjusted(keysGap / 2 + option.decorationSize.width() + keysGap / 2, 0, -keysGap, 0);
        const QRect left = room.adjusted(0, 0, -width, 0);
        painter->drawText(left, Qt::AlignVCenter | Qt::AlignLeft,
                          option.fontMetrics.elidedText(title, Qt::ElideMiddle, left.width()));
        painter->drawText(room, Qt::AlignVCenter | Qt::AlignRight, keys);
    }
};

/// Whether all letters stand in the text in their order.
bool hasLetters(const QString &text, const QString &letters)
{
    qsizetype at = 0;
    for (const QChar c : text)
        if (at < letters.size() && c == letters[at])
            ++at;
    return at == letters.size();
}

bool startsWord(const QString &text, const QString &word)
{
    for (qsizetype at = text.indexOf(word); at >= 0; at = text.indexOf(word, at + 1))
        if (at == 0 || !text[at - 1].isLetterOrNumber())
            return true;
    return false;
}

} // namespace

std::optional<int> paletteRank(const PaletteEntry &entry, const QString &typed)
{
    const QString title = entry.title.toCaseFolded(), id = entry.id.toCaseFolded();
    const QString last = title.section(QStringLiteral(" ▸ "), -1);
    const QString wanted = typed.toCaseFolded().simplified();
    int rank = 0;
    for (const QString &word : wanted.split(' ', Qt::SkipEmptyParts)) {
        if (last.startsWith(word))
            continue;
        if (startsWord(last, word))
            rank += 1;
        else if (last.contains(word))
            rank += 2;
        else if (startsWord(title, word) || id.contains(word))
            rank += 3;
        else if (title.contains(word))
            rank += 4;
        else if (word.size() > 1 && hasLetters(last, word))
            rank += 20;
        else
            return {};
    }
    return 2 * rank + (wanted == last || (!id.isEmpty() && wanted == id) ? 0 : 1);
}

CommandPalette::CommandPalette(std::vector<PaletteEntry> entries, QWidget *parent)
    : QDialog(parent, Qt::Dialog | Qt::FramelessWindowHint), m_entries(std::move(entries))
{
    setWindowTitle(tr("Find a command"));
    setHelpPage(*this, "keys");
    auto *frame = new QFrame(this); // the window has no frame, and may lie over a ground of its own colour
    frame->setFrameStyle(QFrame::StyledPanel | QFrame::Raised);
    auto *whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(frame);
    auto *column = new QVBoxLayout(frame);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);
    m_search = new QLineEdit(this);
    m_search->setPlaceholderText(tr("Commands, brushes, docks, recent files"));
    m_search->setAccessibleName(tr("Find a command"));
    m_search->setToolTip(tr("Parts of names in any order; Enter runs the chosen one, Escape goes back."));
    m_search->setClearButtonEnabled(true);
    m_search->installEventFilter(this);
    column->addWidget(m_search);
    m_list = new QListWidget(this);
    m_list->setAccessibleName(tr("Found"));
    m_list->setToolTip(tr("Click one to run it."));
    m_list->setItemDelegate(new PaletteRowDelegate(m_list));
    m_list->setIconSize(QSize(iconSize, iconSize));
    m_list->setUniformItemSizes(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setFocusPolicy(Qt::NoFocus); // the field keeps the keyboard while the arrows choose
    m_list->setFocusProxy(m_search);
    column->addWidget(m_list, 1);
    m_nothing = new QLabel(tr("Nothing is called so."), this);
    m_nothing->setAlignment(Qt::AlignCenter);
    column->addWidget(m_nothing);
    m_state = new QLabel(this);
    m_state->setWordWrap(true);
    m_state->setMinimumHeight(2 * m_state->fontMetrics().lineSpacing()); // The list keeps its size when something is said.
    column->addWidget(m_state);
    connect(m_list, &QListWidget::currentRowChanged, this, &CommandPalette::showState);
    connect(m_search, &QLineEdit::textChanged, this, &CommandPalette::fill);
    connect(m_list, &QListWidget::itemClicked, this, &CommandPalette::choose);
    fill();
    const int row = std::max(m_list->sizeHintForRow(0), fontMetrics().height() + 2 * rowPadding);
    resize(usualWidth, rowsShown * row + m_search->sizeHint().height() + m_state->minimumHeight() + 40);
}

void CommandPalette::ask(std::vector<PaletteEntry> entries, QWidget &over)
{
    std::function<void()> run;
    {
        CommandPalette palette(std::move(entries), over.window());
        const QSize room = over.size();
        palette.resize(palette.size().boundedTo({room.width(), std::max(room.height(), 200)}));
        palette.move(over.mapToGlobal(QPoint((room.width() - palette.width()) / 2, room.height() / 12)));
        if (palette.exec() == QDialog::Accepted && palette.chosen())
            run = palette.chosen()->run;
    }
    over.window()->activateWindow(); // not every window manager does this when a frameless window goes
    if (run)
        run();
}

const PaletteEntry *CommandPalette::current() const
{
    const QListWidgetItem *item = m_list->currentItem();
    return item ? &m_entries[std::size_t(item->data(entryRole).toInt())] : nullptr;
}

void CommandPalette::fill()
{
    std::vector<std::pair<int, int>> found; // rank, entry
    for (int i = 0; i < int(m_entries.size()); ++i)
        if (const std::optional<int> rank = paletteRank(m_entries[std::size_t(i)], m_search->text()))
            found.emplace_back(*rank, i);
    const bool typed = !m_search->text().trimmed().isEmpty(); // else all stand in the order of the menus
    const auto order = [&](const std::pair<int, int> &each) {
        return std::pair(each.first, typed && !m_entries[std::size_t(each.second)].enabled);
    };
    std::stable_sort(found.begin(), found.end(), [&](const auto &a, const auto &b) { return order(a) < order(b); });
    m_list->clear();
    QPixmap nothing(m_list->iconSize());
    nothing.fill(Qt::transparent);
    const QIcon blank(nothing); // so that all titles stand in one line
    for (const auto &[rank, i] : found) {
        const PaletteEntry &entry = m_entries[std::size_t(i)];
        auto *item = new QListWidgetItem(entry.icon.isNull() ? blank : entry.icon, entry.title, m_list);
        if (!entry.enabled && !entry.icon.isNull())
            item->setIcon(entry.icon.pixmap(m_list->iconSize(), devicePixelRatioF(), QIcon::Disabled));
        item->setData(keysRole, entry.keys);
        item->setData(entryRole, i);
        item->setData(enabledRole, entry.enabled); // the item itself stays enabled, so that the arrows can pass it
        QStringList spoken{entry.title};
        if (!entry.keys.isEmpty())
            spoken << entry.keys;
        if (!entry.enabled) {
            spoken << joinedSentences({tr("It cannot be used now."), entry.whyNot});
            item->setToolTip(spoken.last());
        }
        item->setData(Qt::AccessibleTextRole, spoken.join(QStringLiteral(", ")));
    }
    m_list->setCurrentRow(0);
    m_list->setVisible(!found.empty());
    m_nothing->setVisible(found.empty());
}

void CommandPalette::showState()
{
    const PaletteEntry *entry = current();
    m_state->setText(!entry || entry->enabled
                         ? QString()
                         : joinedSentences({tr("“%1” cannot be used now.").arg(entry->title.section(QStringLiteral(" ▸ "), -1)),
                                            entry->whyNot}));
}

void CommandPalette::choose()
{
    if (const PaletteEntry *entry = current(); entry && entry->enabled) {
        m_chosen = entry;
        accept();
    }
}

bool CommandPalette::eventFilter(QObject *watched, QEvent *event)
{
    if (watched != m_search || event->type() != QEvent::KeyPress)
        return QDialog::eventFilter(watched, event);
    const int row = m_list->currentRow(), last = m_list->count() - 1;
    const int page = std::max(1, rowsShown - 1);
    switch (static_cast<QKeyEvent *>(event)->key()) {
    case Qt::Key_Down:
        m_list->setCurrentRow(row < last ? row + 1 : 0);
        return true;
    case Qt::Key_Up:
        m_list->setCurrentRow(row > 0 ? row - 1 : last);
        return true;
    case Qt::Key_PageDown:
        m_list->setCurrentRow(std::min(row + page, last));
        return true;
    case Qt::Key_PageUp:
        m_list->setCurrentRow(std::max(row - page, 0));
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        choose();
        return true;
    default:
        return QDialog::eventFilter(watched, event);
    }
}

} // namespace suffuse
