// Knows which step of an undo stack is on disk.
#pragma once

#include <QUndoStack>

#include <map>

namespace suffuse {

/// Remembers the step at which the painting is the same as its file, while the user goes on painting, saves again, and
/// while saving fails. The stack's own mark only follows: once it has been moved, it cannot be put back.
class SavedStep {
public:
    /// At first the painting is the same as its file.
    explicit SavedStep(QUndoStack &stack);

    /// With `isNow` the painting is the same as its file at the present step; else it is so at no step.
    void set(bool isNow);
    /// Saving begins at the present step, under a number that rises. From now on no edit merges with this step.
    void savingBegins(quint64 serial);
    /// Saving ended. If it was `saved`, the step at which it began is on disk; else all is as before. Returns false for
    /// numbers that `set` has made void.
    bool savingEnds(quint64 serial, bool saved);
    /// Call it before a command is pushed, since undone steps are lost then.
    void willPush();
    /// Call it when the stack has another index.
    void follow();

    bool isSaving() const { return !m_saving.empty(); }
    /// Whether the painting is as its file, saving aside.
    bool isNow() const { return m_stack.index() == m_saved; }

private:
    static constexpr int lost = -1;

    QUndoStack &m_stack;
    int m_saved = 0;
    std::map<quint64, int> m_saving; ///< steps, by number
};

} // namespace suffuse
