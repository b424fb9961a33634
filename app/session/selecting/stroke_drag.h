#pragma once

#include "model/shaping/reshape.h"
#include "undo/edit_command.h"

#include <functional>
#include <map>
#include <set>

namespace suffuse {

class Editor;

/// Strokes in a drag: every state that is shown is made from the one at the press, and all of them are one undo step. A
/// stroke that something else has changed or taken away meanwhile is left alone.
class StrokeDrag {
public:
    explicit StrokeDrag(Editor &editor) : m_editor(editor) {}

    /// Takes the visible, unlocked ones of the strokes; `name` is the undo step's, translated.
    void begin(const std::set<StrokeId> &strokes, const QString &name);
    /// Takes further strokes into the drag, as they are now.
    void add(const std::set<StrokeId> &strokes);
    /// Puts in what becomes of each stroke as it was at the press.
    void show(const std::function<Stroke(const Stroke &)> &change);
    /// Brings the strokes back as they were; a run that comes back to its start leaves no step.
    void giveUp();
    void end();

    bool isActive() const { return !m_strokes.empty(); }
    std::set<StrokeId> strokes() const;
    /// A stroke as it was at the press, or null.
    const Stroke *before(StrokeId stroke) const;

private:
    struct Dragged {
        StrokePtr before;
        StrokePtr shown;
        bool kept = false; ///< it is in the document as it was shown
    };

    Editor &m_editor;
    std::map<StrokeId, Dragged> m_strokes;
    QString m_name;
    EditRun m_run = 0;
};

} // namespace suffuse
