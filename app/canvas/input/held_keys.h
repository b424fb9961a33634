// Keys that mean something to the canvas for as long as they are held.
#pragma once

#include <QKeySequence>
#include <QList>

class QKeyEvent;

namespace suffuse {

/// What a drag does to the view.
enum class Navigation { None, Pan, Rotate };

/// Keys that turn drags into moves of the view while they are held (with Shift those that pan turn), and those that
/// leave the picture bare.
struct HeldKeys {
    QList<QKeySequence> pan{QKeySequence(Qt::Key_Space)};
    QList<QKeySequence> turn{QKeySequence(Qt::Key_R)};
    QList<QKeySequence> bare{QKeySequence(Qt::Key_O)};
};

/// Which of them are down.
class KeysDown {
public:
    void setKeys(const HeldKeys &keys) { m_keys = keys; }

    /// What holding the key makes of drags.
    Navigation navigationOf(const QKeyEvent &event) const;
    bool isBareKey(const QKeyEvent &event) const;
    void pressNavigation(Navigation navigation, int key) { (navigation == Navigation::Pan ? m_pan : m_turn) = key; }
    void pressBare(int key) { m_bare = key; }
    /// False if the key was not one that is down.
    bool release(int key);
    /// The focus goes: the keys' release goes elsewhere.
    void forget() { m_pan = m_turn = m_bare = 0; }

    /// What the keys that are down make of a drag of the left button.
    Navigation navigation(Qt::KeyboardModifiers modifiers) const;
    bool pans() const { return m_pan != 0; }
    bool turns() const { return m_turn != 0; }
    bool isBare() const { return m_bare != 0; }

private:
    HeldKeys m_keys;
    int m_pan = 0; ///< that is down; 0: none
    int m_turn = 0;
    int m_bare = 0;
};

} // namespace suffuse
