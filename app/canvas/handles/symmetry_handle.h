#pragma once

#include "app/canvas/handles/canvas_handle.h"
#include "model/geometry/symmetry.h"

#include <functional>

namespace suffuse {

class CanvasView;
class DrawingAids;

/// The axes of the symmetry. At the ends of the first one, at the border of the view and so out of the way of what is
/// painted, there are a square that moves all of it and a disc that turns it around the centre. With Shift the centre
/// goes in one direction only, and the angle in steps of 15°.
class SymmetryHandle : public CanvasHandle {
public:
    /// `isShown` says whether the axes are seen; `dpr` is the device pixel ratio.
    SymmetryHandle(DrawingAids &aids, const CanvasView &view, std::function<bool()> isShown,
                   std::function<double()> dpr);

    std::optional<QCursor> cursorAt(Point pixel) const override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    void cancel() override;
    void paint(QPainter &painter, const View &view, const OverlayColours &colours, double dpr) const override;

    /// Where the square and the disc are, device pixels; no value where the first axis is not in the view.
    struct Grips {
        Point move, turn;
    };
    std::optional<Grips> grips() const;

private:
    enum class Part { None, Move, Turn };
    Part partAt(Point pixel) const;

    DrawingAids &m_aids;
    const CanvasView &m_view;
    std::function<bool()> m_isShown;
    std::function<double()> m_dpr;
    Part m_held = Part::None;
    Symmetry m_before; ///< when it was pressed
    Point m_from;      ///< of the press, canvas units
};

} // namespace suffuse
