#include "app/dialogs/shortcuts_dialog.h"

#include "app/session/commands/commands.h"
#include "app/session/settings/settings.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/habits/mnemonics.h"
#include "app/widgets/look/section.h"
#include "app/widgets/menu_titles.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace suffuse {

namespace {

constexpr int NameRole = Qt::UserRole + 1; ///< of the command, in English, as Find a Command knows it
constexpr int roomBeside = 80;             ///< margins and scroll bar beside the list's columns

} // namespace

ShortcutsDialog::ShortcutsDialog(const QList<QAction *> &actions, const QList<FixedKeys> &fixed, QWidget *parent)
    : QDialog(parent), m_fixed(fixed)
{
    setWindowTitle(tr("Keyboard Shortcuts"));
    setHelpPage(*this, "keys");
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(8);
    addList(*column);
    addEditor(*column);
    auto *buttons =
        new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults, this);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    m_ok->setAutoDefault(false);
    column->addWidget(buttons);
    fill(actions);

    connect(m_search, &QLineEdit::textChanged, this, &ShortcutsDialog::filter);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &ShortcutsDialog::showCurrent);
    connect(m_edit, &QKeySequenceEdit::keySequenceChanged, this, &ShortcutsDialog::takeSequence);
    connect(m_clear, &QPushButton::clicked, m_edit, &QKeySequenceEdit::clear);
    connect(m_takeOver, &QPushButton::clicked, this, &ShortcutsDialog::takeOver);
    connect(m_resetOne, &QPushButton::clicked, this, [this] { reset(currentAction()); });
    connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, [this] {
        for (QAction *action : m_actions)
            m_chosen[action] = ownShortcutsOf(*action);
        showCurrent();
    });
    connect(buttons, &QDialogButtonBox::accepted, this, &ShortcutsDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    giveMnemonics(*this);
    m_list->setCurrentItem(m_list->topLevelItem(0));
    int wanted = roomBeside;
    for (int column = 0; column < m_list->columnCount(); ++column) {
        m_list->resizeColumnToContents(column);
        wanted += m_list->columnWidth(column);
    }
    // Wide enough for all commands; fewer of them, as while one searches, do not move the columns.
    m_list->header()->setSectionResizeMode(QHeaderView::Interactive);
    resize(std::clamp(wanted, 520, 1200), 560);
}

void ShortcutsDialog::addList(QVBoxLayout &column)
{
    m_search = new QLineEdit(this);
    m_search->setPlaceholderText(tr("Search"));
    m_search->setClearButtonEnabled(true);
    m_search->setAccessibleName(tr("Search shortcuts"));
    m_search->setToolTip(tr("Shows only commands whose name or shortcut holds this text."));
    column.addWidget(m_search);
    m_list = new QTreeWidget(this);
    m_list->setRootIsDecorated(false);
    m_list->setAlternatingRowColors(true);
    m_list->setUniformRowHeights(true);
    m_list->setHeaderLabels({tr("Command"), tr("Shortcut"), tr("Where")});
    m_list->headerItem()->setToolTip(
        2, tr("Where the shortcut works. What is typed in a dock, without Ctrl or Alt, stays there."));
    m_list->setAccessibleName(tr("Commands"));
    m_list->setToolTip(tr("Choose a command, then press its new shortcut below."));
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents); // so that a name is shown as a whole
    m_list->header()->setStretchLastSection(true);
    m_list->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    column.addWidget(m_list, 1);
}

void ShortcutsDialog::addEditor(QVBoxLayout &column)
{
    auto *row = new QHBoxLayout;
    auto *label = new QLabel(tr("Shortcut"), this);
    m_edit = new QKeySequenceEdit(this);
    m_edit->setAccessibleName(tr("Shortcut"));
    m_edit->setToolTip(tr("Press the keys"));
    label->setBuddy(m_edit);
    const auto button = [this](const QString &text, const QString &tip) {
        auto *made = new QPushButton(text, this);
        made->setToolTip(tip);
        made->setAutoDefault(false);
        return made;
    };
    m_clear = button(tr("&None"), tr("No shortcut for this command"));
    m_resetOne = button(tr("&Reset"), tr("This command's own shortcut"));
    m_takeOver = button(tr("&Take Over"), tr("Takes the shortcut away from the other command"));
    row->addWidget(label);
    row->addWidget(m_edit, 1);
    row->addWidget(m_takeOver);
    row->addWidget(m_clear);
    row->addWidget(m_resetOne);
    column.addLayout(row);
    auto *hint = new HintLabel(this);
    m_conflict = hint;
    column.addWidget(hint);
}

void ShortcutsDialog::fill(const QList<QAction *> &actions)
{
    QPixmap nothing(m_list->iconSize().isValid() ? m_list->iconSize() : QSize(16, 16));
    nothing.fill(Qt::transparent);
    const QIcon blank(nothing); // so that all titles stand in one line
    for (QAction *action : actions) {
        if (action->isSeparator() || action->menu() || action->text().isEmpty())
            continue;
        m_actions << action;
        m_chosen[action] = action->shortcuts();
        auto *item = new QTreeWidgetItem(m_list, {titleWithMenus(*action), QString()});
        item->setData(0, NameRole, action->objectName());
        item->setIcon(0, action->icon().isNull() ? blank : action->icon());
        item->setData(0, Qt::UserRole, QVariant::fromValue<quintptr>(reinterpret_cast<quintptr>(action)));
    }
    fillFixed(blank);
}

void ShortcutsDialog::fillFixed(const QIcon &blank)
{
    for (const FixedKeys &fixed : m_fixed) {
        auto *item = new QTreeWidgetItem(
            m_list, {fixed.title, QKeySequence::listToString(fixed.keys, QKeySequence::NativeText)});
        item->setIcon(0, blank);
        for (int column = 0; column < m_list->columnCount(); ++column) {
            item->setForeground(column, palette().brush(QPalette::Disabled, QPalette::Text));
            item->setToolTip(column, tr("Fixed: no command can have these keys."));
        }
    }
}

QTreeWidgetItem *ShortcutsDialog::itemOf(QAction *action) const
{
    const qsizetype row = m_actions.indexOf(action);
    return row < 0 ? nullptr : m_list->topLevelItem(int(row));
}

QAction *ShortcutsDialog::currentAction() const
{
    const int row = m_list->indexOfTopLevelItem(m_list->currentItem());
    return row < 0 || row >= m_actions.size() ? nullptr : m_actions[row];
}

void ShortcutsDialog::showCurrent()
{
    QAction *action = currentAction();
    m_edit->setEnabled(action);
    m_clear->setEnabled(action);
    m_resetOne->setEnabled(action);
    {
        const QSignalBlocker blocker(m_edit);
        m_edit->setKeySequence(action ? m_chosen[action].value(0) : QKeySequence());
    }
    refresh();
}

void ShortcutsDialog::takeSequence(const QKeySequence &sequence)
{
    QAction *action = currentAction();
    if (!action)
        return;
    // A command has one key chord, since the list would only wait for a second one.
    const QKeySequence first = sequence.isEmpty() ? QKeySequence() : QKeySequence(sequence[0]);
    if (first != sequence) {
        const QSignalBlocker blocker(m_edit);
        m_edit->setKeySequence(first);
    }
    QList<QKeySequence> &chosen = m_chosen[action];
    if (first.isEmpty()) {
        chosen.clear();
    } else { // further shortcuts stay, such as Shift+Del for Cut
        chosen.removeAll(first);
        chosen.isEmpty() ? chosen.append(first) : void(chosen[0] = first);
    }
    refresh();
}

void ShortcutsDialog::reset(QAction *action)
{
    if (!action)
        return;
    m_chosen[action] = ownShortcutsOf(*action);
    showCurrent();
}

void ShortcutsDialog::refresh()
{
    std::map<QString, QList<QAction *>> users;
    for (QAction *action : m_actions)
        for (const QKeySequence &sequence : m_chosen[action])
            users[sequence.toString()] << action;
    QStringList warnings;
    std::map<QAction *, bool> clashes, clashesWithFixed;
    for (const auto &[sequence, actions] : users) {
        if (actions.size() < 2)
            continue;
        for (QAction *action : actions)
            clashes[action] = true;
        warnings << tr("%1 belongs to “%2” and “%3”. Give one of them another shortcut.")
                        .arg(QKeySequence(sequence).toString(QKeySequence::NativeText), titleWithMenus(*actions[0]),
                             titleWithMenus(*actions[1]));
    }
    for (const FixedKeys &fixed : m_fixed)
        for (const QKeySequence &sequence : fixed.keys)
            if (const auto it = users.find(sequence.toString()); it != users.end()) {
                clashesWithFixed[it->second[0]] = true;
                warnings << tr("%1 is fixed: “%2”. Give “%3” another shortcut.")
                                .arg(sequence.toString(QKeySequence::NativeText), fixed.title,
                                     titleWithMenus(*it->second[0]));
            }
    static_cast<HintLabel *>(m_conflict)->showHint(warnings.join('\n'));
    m_ok->setEnabled(warnings.isEmpty());
    for (QAction *action : m_actions) {
        QTreeWidgetItem *item = itemOf(action);
        item->setText(1, QKeySequence::listToString(m_chosen[action], QKeySequence::NativeText));
        item->setText(2, whereKeysWork(scopeOf(*action), m_chosen[action]));
        QFont font = m_list->font();
        font.setBold(m_chosen[action] != ownShortcutsOf(*action));
        item->setFont(1, font);
        const bool warned = clashes[action] || clashesWithFixed[action];
        item->setForeground(1, warned ? QBrush(m_conflict->palette().color(QPalette::WindowText)) : QBrush());
    }
    m_takeOver->setVisible(clashes[currentAction()]);
}

void ShortcutsDialog::filter()
{
    const QString wanted = m_search->text().trimmed();
    QTreeWidgetItem *first = nullptr;
    for (int row = m_list->topLevelItemCount(); row-- > 0;) {
        QTreeWidgetItem *item = m_list->topLevelItem(row);
        const auto holds = [&](const QString &text) { return text.contains(wanted, Qt::CaseInsensitive); };
        const QString name = item->data(0, NameRole).toString(); // in English, without spaces
        const bool found = holds(item->text(0)) || holds(item->text(1)) ||
                           name.contains(QString(wanted).remove(u' '), Qt::CaseInsensitive);
        item->setHidden(!found);
        first = found ? item : first;
    }
    if (QTreeWidgetItem *current = m_list->currentItem(); !current || current->isHidden())
        m_list->setCurrentItem(first); // the chosen row must be a visible one
}

void ShortcutsDialog::takeOver()
{
    QAction *taker = currentAction();
    for (QAction *action : m_actions)
        if (action != taker)
            for (const QKeySequence &sequence : m_chosen[taker])
                m_chosen[action].removeAll(sequence);
    refresh();
}

void ShortcutsDialog::accept()
{
    for (QAction *action : m_actions)
        storeShortcuts(*action, m_chosen[action]);
    settings::store().sync();
    QDialog::accept();
}

} // namespace suffuse
