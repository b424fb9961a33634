#pragma once

#include "app/canvas/handles/canvas_handle.h"
#include "app/canvas/handles/rulers.h"
#include "app/session/selecting/snapping.h"
#include "model/geometry/guide.h"

#include <functional>
#include <vector>

namespace suffuse {

class CanvasView;
class DrawingAids;

/// The guides, and the rulers out of which they come. A press on a ruler takes the guide that ends there or, where none
/// does, begins a new one; a guide that is let go over its ruler or beside the view is gone. With Shift a guide goes to
/// whole ticks of the ruler. Where the tool in use has
/// nothing to do, the guides themselves can be taken, too.
class GuideHandle : public CanvasHandle {
public:
    struct Surroundings {
        std::function<CanvasAids()> aids;
        std::function<RulerUnit()> rulerUnit;
        std::function<bool()> isBare; ///< no guides are seen
        /// the tool in use has nothing to do with a press at a pixel
        std::function<bool(Point pixel)> isFree;
        std::function<double()> dpr;             ///< device pixel ratio
        std::function<void(int guide)> askPlace; ///< a double click wants the exact place of a guide, by its number
    };

    GuideHandle(DrawingAids &aids, const CanvasView &view, Surroundings around);

    std::optional<QCursor> cursorAt(Point pixel) const override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    void cancel() override;
    void paint(QPainter &painter, const View &view, const OverlayColours &colours, double dpr) const override;

private:
    /// What a press would take.
    struct Hit {
        int guide = -1;       ///< its number; −1: a new one
        bool upright = false; ///< the new one
    };
    std::optional<Hit> hitAt(Point pixel) const;
    bool isOnRuler(Point pixel) const;
    bool mayGo(Point pixel) const;

    DrawingAids &m_aids;
    const CanvasView &m_view;
    Surroundings m_around;
    std::vector<Guide> m_before; ///< when it was pressed
    int m_held = -1;             ///< −1: none
    bool m_isNew = false;
    Point m_pixel; ///< of the pointer while one is held
};

/// Where a guide is, as the rulers count, to a pixel of a view with so many pixels to a canvas unit: "x 26.6 mm".
QString placeInWords(const Guide &guide, const RulerUnit &unit, double scale);

} // namespace suffuse
