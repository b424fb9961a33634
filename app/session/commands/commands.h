// The table of commands: a row each, and an action for whoever shows it.
#pragma once

#include "app/session/commands/command.h"
#include "app/session/commands/command_row.h"

#include <QAction>
#include <QActionGroup>
#include <QIcon>

#include <map>

namespace suffuse {

/// Holds the rows of one window, or of a session that has none. Whoever knows how a command is done adds its row: the
/// session, the canvas, a tool, the window.
class Commands : public QObject {
    Q_OBJECT

public:
    using MakeIcon = std::function<QIcon(const QString &name)>;

    /// Without `icons` actions have none.
    explicit Commands(MakeIcon icons = {}, QObject *parent = nullptr);

    /// Adds a row, to be completed by the caller. `id` is its name in the settings: the same in every language, and for
    /// ever. `icon` may be empty; without a `tip` the text says it all.
    CommandRow &add(Command command, const QString &id, const QString &text, const char *icon,
                    const QList<QKeySequence> &keys, const QString &tip = {});
    /// Of these switches one is on at a time.
    void makeExclusive(const QList<Command> &commands,
                       QActionGroup::ExclusionPolicy policy = QActionGroup::ExclusionPolicy::Exclusive);

    /// Asks `first` whenever a command that is there is to run. Where it returns true, it has done what there was to
    /// do.
    void ask(Command command, std::function<bool()> first);

    /// The row must be there.
    const CommandRow &row(Command command) const { return m_rows.at(command); }
    QAction &operator[](Command command) const { return *row(command).action; }
    /// All that were added, in the order of `Command`.
    QList<QAction *> all() const;
    /// Those that do something when they are triggered.
    QList<QAction *> runnable() const;
    QList<QAction *> of(CommandScope scope) const;

    /// Enables, checks, shows and names all commands by their rows. Tool tips and status tips of those that cannot be used
    /// say why. To be called when something that they look at has
    /// changed; after a command has run it is done anyway, unless `updatesComeBy` says that it is about to be called.
    void update();
    void update(Command command);
    /// While this is true, what a command did is still to be told to those who only show it, and `update` is called
    /// then: what people look at, the picture, is not kept waiting by buttons that turn grey.
    void updatesComeBy(std::function<bool()> isWaiting) { m_isWaiting = std::move(isWaiting); }

signals:
    /// What a command has to say to people, for so many milliseconds at most and until something else is done.
    void said(const QString &message, int milliseconds);

private:
    void run(const CommandRow &row);
    void follow(CommandRow &row);

    MakeIcon m_icons;
    std::function<bool()> m_isWaiting;
    std::map<Command, CommandRow> m_rows;
};

/// The scope of an action that a table has made; of others that of the window.
CommandScope scopeOf(const QAction &action);

/// A menu entry's text without mnemonic ("&Open", "打开(&O)") and dots.
QString plainTitle(QString title);

} // namespace suffuse
