// Which step of an undo stack is on disk.
#pragma once

#include <QUndoStack>

#include <map>

namespace suffuse {

/// Remembers the step at which a painting is as its file, while it is painted on, saved again, and saving fails. The
/// stack's own mark only follows: once it is moved it cannot be put back to where it was.
class SavedStep {
public:
    /// At first the painting is as its file.
    explicit SavedStep(QUndoStack &stack);

    /// The painting is as its file now, or no step is.
    void set(bool isNow);
    /// Saving begins here, under a number that rises. No edit merges with this step any more.
    void savingBegins(quint64 serial);
    /// It is on disk, or it is not and all is as it was before. False for numbers that `set` has made void.
    bool savingEnds(quint64 serial, bool saved);
    /// Call it before a command is pushed: undone steps are lost then.
    void willPush();
    /// Call it when those steps are on the stack again, where they were.
    void putBack();
    /// Call it when the stack has another index.
    void follow();

    bool isSaving() const { return !m_steps.saving.empty(); }
    /// Whether the painting is as its file, saving aside.
    bool isNow() const { return m_stack.index() == m_steps.saved; }

private:
    static constexpr int lost = -1;
    struct Steps {
        int saved = 0;
        std::map<quint64, int> saving; ///< by number
    };

    QUndoStack &m_stack;
    Steps m_steps;
    Steps m_dropped; ///< as they were before undone steps were lost the last time
};

} // namespace suffuse
