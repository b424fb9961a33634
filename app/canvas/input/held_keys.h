// Keys that mean something to the canvas for as long as they are held.
#pragma once

#include <QKeySequence>
#include <QList>

class QKeyEvent;

namespace suffuse {

/// What a drag does to the view.
enum class Navigation { None, Pan, Rotate };

/// The keys that turn drags into moves of the view while they are held, and those that leave the picture bare. With
/// Shift the keys that pan turn instead.
struct HeldKeys {
    QList<QKeySequence> pan{QKeySequence(Qt::Key_Space)};
    QList<QKeySequence> turn{QKeySequence(Qt::Key_R)};
    QList<QKeySequence> bare{QKeySequence(Qt::Key_O)};
};

/// Knows which of the held keys are down.
class KeysDown {
public:
    void setKeys(const HeldKeys &keys) { m_keys = keys; }

    /// What a drag does to the view while the key is held.
    Navigation navigationOf(const QKeyEvent &event) const;
    bool isBareKey(const QKeyEvent &event) const;
    void pressNavigation(Navigation navigation, int key) { (navigation == Navigation::Pan ? m_pan : m_turn) = key; }
    void pressBare(int key) { m_bare = key; }
    /// Notes that a key is released. Returns false if it was not known to be down.
    bool release(int key);
    /// Forgets all keys. To be called when the focus goes, since their release then goes elsewhere.
    void forget() { m_pan = m_turn = m_bare = 0; }

    /// What a drag of the left button does to the view, with the keys that are down.
    Navigation navigation(Qt::KeyboardModifiers modifiers) const;
    bool pans() const { return m_pan != 0; }
    bool turns() const { return m_turn != 0; }
    bool isBare() const { return m_bare != 0; }

private:
    HeldKeys m_keys;
    int m_pan = 0; ///< the key that is down; 0: none
    int m_turn = 0;
    int m_bare = 0;
};

} // namespace suffuse
