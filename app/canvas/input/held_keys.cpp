#include "app/canvas/input/held_keys.h"

#include <QKeyEvent>

namespace suffuse {

namespace {

/// The modifiers of a key event; keys of the keypad count as the keys of their names.
Qt::KeyboardModifiers modifiersOf(const QKeyEvent &event)
{
    return event.modifiers() & ~Qt::KeypadModifier;
}

QKeySequence sequence(const QKeyEvent &event, Qt::KeyboardModifiers modifiers)
{
    return QKeySequence(QKeyCombination(modifiers, Qt::Key(event.key())));
}

} // namespace

Navigation KeysDown::navigationOf(const QKeyEvent &event) const
{
    const Qt::KeyboardModifiers modifiers = modifiersOf(event);
    if (m_keys.turn.contains(sequence(event, modifiers)))
        return Navigation::Rotate;
    return m_keys.pan.contains(sequence(event, modifiers)) ||
                   m_keys.pan.contains(sequence(event, modifiers & ~Qt::ShiftModifier))
               ? Navigation::Pan
               : Navigation::None;
}

bool KeysDown::isBareKey(const QKeyEvent &event) const
{
    return m_keys.bare.contains(sequence(event, modifiersOf(event)));
}

bool KeysDown::release(int key)
{
    for (int *down : {&m_pan, &m_turn, &m_bare})
        if (*down == key) {
            *down = 0;
            return true;
        }
    return false;
}

Navigation KeysDown::navigation(Qt::KeyboardModifiers modifiers) const
{
    if (m_pan)
        return modifiers & Qt::ShiftModifier ? Navigation::Rotate : Navigation::Pan;
    return m_turn ? Navigation::Rotate : Navigation::None;
}

} // namespace suffuse
