#include "app/dialogs/shortcuts_dialog.h"

#include "app/actions.h"
#include "app/panels/section.h"
#include "app/settings.h"

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

const char ownShortcuts[] = "suffuseOwnShortcuts";

QString keyOf(const QAction *action)
{
    const QString name = action->objectName().isEmpty() ? action->text().remove('&') : action->objectName();
    return QStringLiteral("shortcuts/") + QString::fromLatin1(name.toUtf8().toPercentEncoding());
}

QList<QKeySequence> ownShortcutsOf(const QAction *action)
{
    const QVariant own = action->property(ownShortcuts);
    return own.isValid() ? own.value<QList<QKeySequence>>() : action->shortcuts();
}

/// For undo without the step's name.
QString titleOf(const QAction *action)
{
    return plainTitle(action->iconText());
}

} // namespace

void applyStoredShortcuts(const QList<QAction *> &actions)
{
    for (QAction *action : actions) {
        if (!action->property(ownShortcuts).isValid())
            action->setProperty(ownShortcuts, QVariant::fromValue(action->shortcuts()));
        const QVariant stored = settings::store().value(keyOf(action));
        if (stored.isValid())
            action->setShortcuts(QKeySequence::listFromString(stored.toString(), QKeySequence::PortableText));
        else
            action->setShortcuts(ownShortcutsOf(action));
    }
}

ShortcutsDialog::ShortcutsDialog(const QList<QAction *> &actions, QWidget *parent) : QDialog(parent)
{
    setWindowTitle(tr("Keyboard shortcuts"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(8);
    addList(*column);
    QPushButton *clear = addEditor(*column);
    auto *buttons =
        new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults, this);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    m_ok->setAutoDefault(false);
    column->addWidget(buttons);
    fill(actions);

    connect(m_search, &QLineEdit::textChanged, this, &ShortcutsDialog::refresh);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &ShortcutsDialog::showCurrent);
    connect(m_edit, &QKeySequenceEdit::keySequenceChanged, this, &ShortcutsDialog::takeSequence);
    connect(clear, &QPushButton::clicked, m_edit, &QKeySequenceEdit::clear);
    connect(m_resetOne, &QPushButton::clicked, this, [this] { reset(currentAction()); });
    connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, [this] {
        for (QAction *action : m_actions)
            m_chosen[action] = ownShortcutsOf(action);
        showCurrent();
        refresh();
    });
    connect(buttons, &QDialogButtonBox::accepted, this, &ShortcutsDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    m_list->setCurrentItem(m_list->topLevelItem(0));
    refresh();
    resize(520, 560);
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
    m_list->setHeaderLabels({tr("Command"), tr("Shortcut")});
    m_list->setAccessibleName(tr("Commands"));
    m_list->setToolTip(tr("Choose a command, then press its new shortcut below."));
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    column.addWidget(m_list, 1);
}

QPushButton *ShortcutsDialog::addEditor(QVBoxLayout &column)
{
    auto *row = new QHBoxLayout;
    auto *label = new QLabel(tr("Shortcut"), this);
    m_edit = new QKeySequenceEdit(this);
    m_edit->setAccessibleName(tr("Shortcut"));
    m_edit->setToolTip(tr("Press the keys"));
    label->setBuddy(m_edit);
    auto *clear = new QPushButton(tr("None"), this);
    clear->setToolTip(tr("No shortcut for this command"));
    clear->setAutoDefault(false);
    m_resetOne = new QPushButton(tr("Reset"), this);
    m_resetOne->setToolTip(tr("This command's own shortcut"));
    m_resetOne->setAutoDefault(false);
    row->addWidget(label);
    row->addWidget(m_edit, 1);
    row->addWidget(clear);
    row->addWidget(m_resetOne);
    column.addLayout(row);
    auto *hint = new HintLabel(this);
    m_conflict = hint;
    column.addWidget(hint);

    return clear;
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
        auto *item = new QTreeWidgetItem(m_list, {titleOf(action), QString()});
        item->setIcon(0, action->icon().isNull() ? blank : action->icon());
        item->setData(0, Qt::UserRole, QVariant::fromValue<quintptr>(reinterpret_cast<quintptr>(action)));
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
    return row < 0 ? nullptr : m_actions[row];
}

void ShortcutsDialog::showCurrent()
{
    QAction *action = currentAction();
    m_edit->setEnabled(action);
    const QSignalBlocker blocker(m_edit);
    m_edit->setKeySequence(action ? m_chosen[action].value(0) : QKeySequence());
}

void ShortcutsDialog::takeSequence(const QKeySequence &sequence)
{
    QAction *action = currentAction();
    if (!action)
        return;
    // One key chord a command: a second one would only be waited for.
    const QKeySequence first = sequence.isEmpty() ? QKeySequence() : QKeySequence(sequence[0]);
    if (first != sequence) {
        const QSignalBlocker blocker(m_edit);
        m_edit->setKeySequence(first);
    }
    m_chosen[action] = first.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{first};
    refresh();
}

void ShortcutsDialog::reset(QAction *action)
{
    if (!action)
        return;
    m_chosen[action] = ownShortcutsOf(action);
    showCurrent();
    refresh();
}

void ShortcutsDialog::refresh()
{
    std::map<QString, QList<QAction *>> users;
    for (QAction *action : m_actions)
        for (const QKeySequence &sequence : m_chosen[action])
            users[sequence.toString()] << action;
    QString warning;
    std::map<QAction *, bool> clashes;
    for (const auto &[sequence, actions] : users) {
        if (actions.size() < 2)
            continue;
        for (QAction *action : actions)
            clashes[action] = true;
        warning = tr("%1 belongs to “%2” and “%3”. Give one of them another shortcut.")
                      .arg(QKeySequence(sequence).toString(QKeySequence::NativeText), titleOf(actions[0]),
                           titleOf(actions[1]));
    }
    static_cast<HintLabel *>(m_conflict)->showHint(warning);
    m_ok->setEnabled(warning.isEmpty());

    const QString wanted = m_search->text().trimmed();
    for (QAction *action : m_actions) {
        QTreeWidgetItem *item = itemOf(action);
        item->setText(1, QKeySequence::listToString(m_chosen[action], QKeySequence::NativeText));
        QFont font = m_list->font();
        font.setBold(m_chosen[action] != ownShortcutsOf(action));
        item->setFont(1, font);
        item->setForeground(1, clashes[action] ? QBrush(m_conflict->palette().color(QPalette::WindowText)) : QBrush());
        item->setHidden(!wanted.isEmpty() && !item->text(0).contains(wanted, Qt::CaseInsensitive) &&
                        !item->text(1).contains(wanted, Qt::CaseInsensitive));
    }
}

void ShortcutsDialog::accept()
{
    for (QAction *action : m_actions) {
        action->setShortcuts(m_chosen[action]);
        if (m_chosen[action] == ownShortcutsOf(action))
            settings::store().remove(keyOf(action));
        else
            settings::store().setValue(keyOf(action),
                                       QKeySequence::listToString(m_chosen[action], QKeySequence::PortableText));
    }
    settings::store().sync();
    QDialog::accept();
}

} // namespace suffuse
