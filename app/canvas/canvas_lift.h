// Strokes that float over the canvas while a gesture maps them as a whole.
#pragma once

#include "app/canvas/canvas_view.h"
#include "app/canvas/overlay/overlay.h"
#include "app/canvas/overlay/selection_outline.h"
#include "app/session/floating_view.h"
#include "app/session/frames/frame_thread.h"

namespace suffuse {

class Editor;

/// Lets the frame thread make pictures of the lifted strokes and of the rest, and says what floats in the next frame.
class CanvasLift : public FloatingView {
public:
    /// `schedule` is called where a frame is needed.
    CanvasLift(Editor &editor, FrameThread &frames, const CanvasView &view, std::function<void()> schedule);
    ~CanvasLift() override;

    void lift(const std::set<StrokeId> &strokes) override;
    void endLift() override;
    bool isLifted() const override { return m_lift && holds(*m_lift); }
    void showFloating(const Affine &map) override;
    void settleFloating() override;
    bool coversFloating(const Affine &map) const override;

    /// What floats in a frame of now. If it belongs to another painting, moment or view, it is let go.
    const std::optional<Floating> &forFrame();
    /// Whether something is shown afloat. It stays so until the exact picture is shown.
    bool isFloating() const { return m_floating.has_value(); }
    /// Whether the screen shows more than the document has heard of.
    bool isAhead() const { return m_floating && !m_floating->settled; }
    /// To be called when the exact picture of the document is on the screen.
    void exactShown();
    /// Paints the lines of the selection where the selected strokes float. Returns false if they do not float.
    bool paintOutline(QPainter &painter, SelectionOutline &outline, const Selection &selection,
                      const OverlayColours &colours, double dpr) const;

private:
    const View &view() const { return m_view.view(); }
    bool holds(const Lift &lift) const;

    Editor &m_editor;
    FrameThread &m_frames;
    const CanvasView &m_view;
    std::function<void()> m_schedule;
    LiftPtr m_lift;                     ///< null while nothing is lifted
    std::optional<Floating> m_floating; ///< what is shown afloat, until the exact picture is shown
    PaintingPtr m_liftedFrom;           ///< the document's painting to which both belong
};

} // namespace suffuse
