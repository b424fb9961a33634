// Strokes that float over the canvas while a gesture maps them as a whole.
#pragma once

#include "app/canvas/canvas_view.h"
#include "app/canvas/overlay/overlay.h"
#include "app/canvas/overlay/selection_outline.h"
#include "app/session/floating_view.h"
#include "app/session/frames/frame_thread.h"

namespace suffuse {

class Editor;

/// Has the frame thread make pictures of what is lifted and of the rest, and says what floats in the next frame.
class CanvasLift : public FloatingView {
public:
    /// `schedule` asks for a frame.
    CanvasLift(Editor &editor, FrameThread &frames, const CanvasView &view, std::function<void()> schedule);
    ~CanvasLift() override;

    void lift(const std::set<StrokeId> &strokes) override;
    void endLift() override;
    bool isLifted() const override { return m_lift && holds(*m_lift); }
    void showFloating(const Affine &map) override;
    void settleFloating() override;
    bool coversFloating(const Affine &map) const override;

    /// What floats in a frame of now; what belongs to another painting, moment or view is let go.
    const std::optional<Floating> &forFrame();
    /// Something is shown afloat, until the exact picture is.
    bool isFloating() const { return m_floating.has_value(); }
    /// The document has not heard of what is shown.
    bool isAhead() const { return m_floating && !m_floating->settled; }
    /// The exact picture of the document is shown.
    void exactShown();
    /// The lines of the selection where what is selected floats; false: it does not.
    bool paintOutline(QPainter &painter, SelectionOutline &outline, const Selection &selection,
                      const OverlayColours &colours, double dpr) const;

private:
    const View &view() const { return m_view.view(); }
    bool holds(const Lift &lift) const;

    Editor &m_editor;
    FrameThread &m_frames;
    const CanvasView &m_view;
    std::function<void()> m_schedule;
    LiftPtr m_lift;                     ///< null: none
    std::optional<Floating> m_floating; ///< that is shown, until the exact picture is
    PaintingPtr m_liftedFrom;           ///< the document's painting, for which both hold
};

} // namespace suffuse
