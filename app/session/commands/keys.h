// Keys of commands: those that the user has chosen, those that nobody can have, and where which of them work.
#pragma once

#include "app/session/commands/command_row.h"

#include <QAction>

class QKeyEvent;

namespace suffuse {

/// Remembers each action's own shortcuts and puts those in the settings in their place. Call it once all actions exist;
/// actions are known by their object name, or where they have none by their text.
void applyStoredShortcuts(const QList<QAction *> &actions);
/// Those that it has while the user has chosen none.
QList<QKeySequence> ownShortcutsOf(const QAction &action);
/// Gives an action the keys that the user has chosen, and keeps them in the settings.
void storeShortcuts(QAction &action, const QList<QKeySequence> &keys);

/// A key that types, moves or deletes; not one that stands for a command in any place, as function keys do. F2 renames
/// in lists.
bool isTypedKey(QKeyCombination key);
/// Where a command's keys work, for people; empty where it has none.
QString whereKeysWork(CommandScope scope, const QList<QKeySequence> &keys);

/// Keys that tools, not commands, answer to, and that stay as they are.
struct FixedKeys {
    QString title; ///< what they do, translated
    QList<QKeySequence> keys;
};
/// All of them: no command may have one, or it would not be heard of.
QList<FixedKeys> fixedKeys();

/// Whether a key redoes something, by the platform's keys or Ctrl+Y.
bool meansRedo(const QKeyEvent &event);

} // namespace suffuse
