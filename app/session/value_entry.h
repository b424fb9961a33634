// How values come in from a field: typed, as steps that follow each other, or while something is dragged.
#pragma once

#include "app/session/gesture.h"
#include "model/document/document.h"

#include <QElapsedTimer>

namespace suffuse {

/// A field keeps one and hands it on with each value; whoever makes an edit of the value gives both to `Editor::push`.
/// While it drags, all its edits are one gesture. Else each is done at once, and goes on with the step of the one
/// before where nothing was done and nothing else selected in between: a key that is held down, or a wheel that is
/// turned, is one step.
class ValueEntry {
public:
    ValueEntry() = default;
    /// What a field shows when it goes, stays.
    ~ValueEntry();
    ValueEntry(const ValueEntry &) = delete;
    ValueEntry &operator=(const ValueEntry &) = delete;

    void beginDrag();
    bool isDragging() const { return m_drags; }
    void commitDrag();
    void giveUpDrag();

    /// The next value begins a step of its own.
    void endSteps() { m_step.reset(); }
    /// The next value comes by a key or a wheel. It begins a step of its own unless the key is held down, or came so soon
    /// after the last one that the hand has not paused. Some systems repeat a key by presses like any other.
    void noteStep(bool held = false);

    /// The painting from which a change of several values is counted: that of the first call since it was forgotten.
    const PaintingPtr &start(const Document &document);
    /// The same, null where there is none.
    const PaintingPtr &start() const { return m_start; }
    void forgetStart() { m_start.reset(); }

private:
    friend class Editor;

    bool m_drags = false;
    Gesture m_gesture;          ///< of the drag, once it has brought an edit
    std::weak_ptr<Edit> m_step; ///< that was done last
    quint64 m_selection = 0;    ///< number of the selection that there was after it
    QElapsedTimer m_sinceStep;  ///< since the last key or turn of the wheel
    PaintingPtr m_start;
};

} // namespace suffuse
