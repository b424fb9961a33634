#include "app/session/commands/commands.h"

#include <QPointer>
#include <QRegularExpression>
#include <QSignalBlocker>

#include <algorithm>

namespace suffuse {

QString plainTitle(QString title)
{
    static const QRegularExpression mnemonic(QStringLiteral("\\(&.\\)"));
    title.remove(mnemonic).remove('&');
    while (title.endsWith('.') || title.endsWith(QStringLiteral("…")) || title.endsWith(' '))
        title.chop(1);
    return title;
}

CommandRow &CommandRow::checkable(bool on)
{
    const QSignalBlocker quiet(action); // it is as it begins, and nobody has switched it
    action->setCheckable(true);
    action->setChecked(on);
    return *this;
}

bool CommandRow::isOn() const
{
    return action->isChecked();
}

CommandRow &CommandRow::held(std::function<void(const QList<QKeySequence> &keys)> function)
{
    keysChanged = std::move(function);
    keysChanged(action->shortcuts());
    return *this;
}

Commands::Commands(MakeIcon icons, QObject *parent) : QObject(parent), m_icons(std::move(icons)) {}

CommandRow &Commands::add(Command command, const QString &id, const QString &text, const char *iconName,
                          const QList<QKeySequence> &keys, const QString &tip)
{
    Q_ASSERT(!m_rows.contains(command));
    CommandRow &row = m_rows[command];
    auto *action = row.action = new QAction(text, this);
    if (m_icons && *iconName)
        action->setIcon(m_icons(QString::fromLatin1(iconName)));
    action->setObjectName(id);
    action->setIconText(plainTitle(text)); // stays when the text names the step that is undone
    action->setShortcuts(keys);
    const auto showKey = [action, tip, &row] {
        const QString key = action->shortcut().toString(QKeySequence::NativeText);
        const QString what = tip.isEmpty() ? plainTitle(action->text()) : tip;
        const QString all = key.isEmpty() ? what : QStringLiteral("%1 (%2)").arg(what, key);
        action->setToolTip(row.whyNot.isEmpty() ? all : all + '\n' + row.whyNot);
    };
    showKey();
    connect(action, &QAction::changed, this, [&row, showKey] {
        showKey();
        if (row.keysChanged)
            row.keysChanged(row.action->shortcuts());
    });
    connect(action, &QAction::triggered, this, [this, &row] { run(row); });
    connect(action, &QAction::toggled, this, [&row](bool on) {
        if (row.toggled)
            row.toggled(on);
    });
    return row;
}

void Commands::makeExclusive(const QList<Command> &commands, QActionGroup::ExclusionPolicy policy)
{
    auto *group = new QActionGroup(this);
    group->setExclusionPolicy(policy);
    for (const Command command : commands)
        group->addAction(row(command).action);
}

void Commands::run(const CommandRow &row)
{
    const QPointer<Commands> alive = this; // a command may close the window
    if (row.run)
        row.run();
    if (alive && !(m_isWaiting && m_isWaiting()))
        update();
}

void Commands::ask(Command command, std::function<bool()> first)
{
    CommandRow &row = m_rows.at(command);
    row.run = [first = std::move(first), run = std::move(row.run)] {
        if (!first() && run)
            run();
    };
}

QList<QAction *> Commands::all() const
{
    QList<QAction *> list;
    for (const auto &[command, row] : m_rows)
        list << row.action;
    return list;
}

QList<QAction *> Commands::runnable() const
{
    QList<QAction *> list;
    for (const auto &[command, row] : m_rows)
        if (!row.isHeld())
            list << row.action;
    return list;
}

QList<QAction *> Commands::of(CommandScope scope) const
{
    QList<QAction *> list;
    for (const auto &[command, row] : m_rows)
        if (row.scope == scope)
            list << row.action;
    return list;
}

void Commands::update()
{
    for (auto &[command, row] : m_rows)
        follow(row);
}

void Commands::update(Command command)
{
    follow(m_rows.at(command));
}

void Commands::follow(CommandRow &row)
{
    if (row.enabled) {
        const Usability now = row.enabled();
        row.whyNot = now.whyNot;
        row.action->setStatusTip(now.whyNot); // which tells the tool tip
        row.action->setEnabled(now.isUsable);
    }
    if (row.checked)
        row.action->setChecked(row.checked());
    if (row.shown)
        row.action->setVisible(row.shown());
    if (row.text)
        row.action->setText(row.text());
    if (!row.icon || !m_icons)
        return;
    if (const QString name = row.icon(); name != row.shownIcon) {
        row.action->setIcon(m_icons(name));
        row.shownIcon = name;
    }
}

CommandScope scopeOf(const QAction &action)
{
    const auto *table = qobject_cast<const Commands *>(action.parent());
    if (table)
        for (const CommandScope scope :
             {CommandScope::Strokes, CommandScope::Timeline, CommandScope::Nodes, CommandScope::Canvas})
            if (table->of(scope).contains(&action))
                return scope;
    return CommandScope::Window;
}

} // namespace suffuse
