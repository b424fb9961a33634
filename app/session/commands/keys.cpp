#include "app/session/commands/keys.h"

#include <QKeyEvent>

#include "app/session/commands/commands.h"
#include "app/session/settings/settings.h"

#include <algorithm>

namespace suffuse {

namespace {

const char ownShortcuts[] = "suffuseOwnShortcuts";

QString keyOf(const QAction &action)
{
    const QString name = action.objectName().isEmpty() ? action.text().remove('&') : action.objectName();
    return QStringLiteral("shortcuts/") + QString::fromLatin1(name.toUtf8().toPercentEncoding());
}

} // namespace

QList<QKeySequence> ownShortcutsOf(const QAction &action)
{
    const QVariant own = action.property(ownShortcuts);
    return own.isValid() ? own.value<QList<QKeySequence>>() : action.shortcuts();
}

void applyStoredShortcuts(const QList<QAction *> &actions)
{
    for (QAction *action : actions) {
        if (!action->property(ownShortcuts).isValid())
            action->setProperty(ownShortcuts, QVariant::fromValue(action->shortcuts()));
        const QVariant stored = settings::store().value(keyOf(*action));
        if (stored.isValid())
            action->setShortcuts(QKeySequence::listFromString(stored.toString(), QKeySequence::PortableText));
        else
            action->setShortcuts(ownShortcutsOf(*action));
    }
}

void storeShortcuts(QAction &action, const QList<QKeySequence> &keys)
{
    action.setShortcuts(keys);
    if (keys == ownShortcutsOf(action))
        settings::store().remove(keyOf(action));
    else
        settings::store().setValue(keyOf(action), QKeySequence::listToString(keys, QKeySequence::PortableText));
}

bool isTypedKey(QKeyCombination key)
{
    const bool isFunction = key.key() >= Qt::Key_F1 && key.key() <= Qt::Key_F35 && key.key() != Qt::Key_F2;
    return !isFunction && !(key.keyboardModifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
}

QString whereKeysWork(CommandScope scope, const QList<QKeySequence> &keys)
{
    const auto isNone = [](const QKeySequence &key) { return key.isEmpty(); }; // as it is stored where there is none
    if (std::ranges::all_of(keys, isNone))
        return {};
    if (scope == CommandScope::Canvas)
        return Commands::tr("Canvas, while held");
    const bool typed =
        std::ranges::any_of(keys, [&](const QKeySequence &key) { return !isNone(key) && isTypedKey(key[0]); });
    if (!typed)
        return Commands::tr("Everywhere");
    switch (scope) {
    case CommandScope::Strokes:
        return Commands::tr("Canvas, Strokes dock");
    case CommandScope::Timeline:
        return Commands::tr("Canvas, Timeline dock");
    case CommandScope::Nodes:
        return Commands::tr("Canvas, Segments tool");
    case CommandScope::Window:
    case CommandScope::Canvas:
        break;
    }
    return Commands::tr("Canvas");
}

QList<FixedKeys> fixedKeys()
{
    const auto arrows = [](Qt::KeyboardModifiers modifiers) {
        QList<QKeySequence> keys;
        for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down})
            keys << QKeySequence(QKeyCombination(modifiers, key));
        return keys;
    };
    // Tab is not among them: it goes to the next stroke only where a tool has one, and hides the docks otherwise.
    return {{Commands::tr("Move the Selection"), arrows({})},
            {Commands::tr("Move the Selection Ten Times as Far"), arrows(Qt::ShiftModifier)},
            {Commands::tr("Move the Selection by One Unit"), arrows(Qt::AltModifier)},
            {Commands::tr("Move the Selection by Ten Units"), arrows(Qt::AltModifier | Qt::ShiftModifier)},
            {Commands::tr("Move Rows in the Strokes Dock"),
             {QKeySequence(QKeyCombination(Qt::AltModifier, Qt::Key_Up)),
              QKeySequence(QKeyCombination(Qt::AltModifier, Qt::Key_Down))}},
            {Commands::tr("Previous Stroke or Node"), {QKeySequence(Qt::SHIFT | Qt::Key_Tab)}},
            {Commands::tr("Give Up, or Deselect"), {QKeySequence(Qt::Key_Escape)}}};
}

bool meansRedo(const QKeyEvent &event)
{
    return event.matches(QKeySequence::Redo) || (event.key() == Qt::Key_Y && event.modifiers() == Qt::ControlModifier);
}

} // namespace suffuse
