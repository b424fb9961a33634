#pragma once

#include "app/canvas/input/pointer_event.h"
#include "app/session/gesture.h"
#include "model/painting/painting.h"
#include "model/painting/selection.h"

#include <QString>

namespace suffuse {

class CanvasWidget;
class Editor;

/// Matches while the pointer is down: the selection gets the appearance of the stroke under the pointer, where there is
/// one. What varies along the selected strokes goes on varying; with Shift it is levelled. A press and all moves up to
/// the release are one step.
class MatchPicker {
public:
    explicit MatchPicker(CanvasWidget &canvas);

    void begin(const PointerEvent &event);
    void move(const PointerEvent &event);
    void end();
    void giveUp();
    bool isActive() const { return m_before != nullptr; }
    /// One line for the status bar.
    QString hint() const;

private:
    CanvasWidget &m_canvas;
    Editor &m_editor;
    PaintingPtr m_before; ///< when the press came; null: no press
    Selection m_selection;
    Gesture m_gesture;
};

} // namespace suffuse
