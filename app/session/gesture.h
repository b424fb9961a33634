// One thing that is being done and is not decided yet: a drag, or a dialog that shows what it would do.
#pragma once

#include "model/document/edit.h"
#include "model/shaping/nodes/reshape.h"
#include "model/shaping/transform.h"

#include <QString>

#include <functional>
#include <memory>
#include <set>

namespace suffuse {

class GestureState;

/// Changes that follow each other within one gesture, as in a window that stays open: undo and redo go through them
/// before they come to the steps of the undo stack.
class GestureSteps {
public:
    virtual ~GestureSteps() = default;
    virtual bool canStep(bool back) const = 0;
    /// Shows in the gesture what was shown one change before, or after.
    virtual void step(bool back) = 0;
    /// Hands the changes over to the undo stack, also those that were taken back and can be redone, and goes on from
    /// what is shown, without changes of its own. `commit` makes a step of what the gesture shows, and returns false if
    /// that changes nothing; `undo` takes back the last step.
    virtual void handOver(const std::function<bool()> &commit, const std::function<void()> &undo) = 0;
};

/// What is shown in a gesture is in the document, but in no step: `commit` makes one step of all of it, `giveUp` puts
/// everything back, and so does a handle that is destroyed. So the steps that can be redone, and the one that is saved,
/// stay what they are until the gesture is decided; one that comes back to its start leaves no trace at all.
///
/// There is one gesture at a time, and whatever else is begun, pushed, undone, redone or saved by the editor commits it
/// first; changes within it become a step each where it is saved, or where undo goes back beyond them. Where a step of
/// the undo stack is done without the editor knowing, the gesture is given up before. In both cases whoever holds the
/// handle may go on: what it shows next begins a new part of the same name.
class Gesture {
public:
    /// A handle of nothing.
    Gesture();
    explicit Gesture(std::unique_ptr<GestureState> state);
    Gesture(Gesture &&other) noexcept;
    Gesture &operator=(Gesture &&other) noexcept;
    ~Gesture();

    /// From `Editor::begin` until it is committed or given up by this handle.
    bool isOpen() const { return m_state != nullptr; }

    /// Puts an edit of the document, as it is shown now, in.
    void show(Edit edit);

    /// Takes the visible, unlocked ones of the strokes into the gesture, as they are now.
    void take(const std::set<StrokeId> &strokes);
    /// Puts in what becomes of each stroke as it was when it was taken. A stroke that something else has changed or
    /// taken away since is left alone.
    void show(const std::function<Stroke(const Stroke &)> &change);
    /// Shows the strokes under a map, from where they were when they were taken. Where they are lifted (FloatingView)
    /// only their picture moves, until the hand rests, the view or the moment changes, or somebody asks for the
    /// document.
    void floatBy(const Affine &map, SpreadRule rule);
    /// Strokes cannot be painted under the map that was shown last, so all of them are shown where they were. What
    /// floats is put in the document before this is known.
    bool isRefused() const;
    std::set<StrokeId> strokes() const;
    /// A stroke as it was when it was taken, or null.
    const Stroke *before(StrokeId stroke) const;

    /// The hand is off it, though it is not decided yet: frames are exact, and the journal has what is shown.
    void rest();
    void commit();
    void giveUp();

private:
    std::unique_ptr<GestureState> m_state; ///< null: not open
};

} // namespace suffuse
