// What the tools that select have in common: click, rubber band, nudging.
#pragma once

#include "app/session/value_entry.h"
#include "app/tools/canvas_tool.h"
#include "model/painting/selection.h"

#include <QPainterPath>

#include <optional>
#include <vector>

namespace suffuse {

/// What a drag encloses or touches.
enum class BandShape { Rectangle, Lasso, Touch };

/// Tells clicks from drags. A drag is a rubber band unless the tool takes it for itself.
class SelectionTool : public CanvasTool {
    Q_OBJECT

public:
    using CanvasTool::CanvasTool;

    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    bool isBusy() const override { return m_state != State::Idle; }
    void cancel() override;
    /// Arrow keys move the selected strokes on the screen by 1 unit (with Shift by 10, with Alt by 1 pixel); Esc
    /// deselects.
    bool keyPress(QKeyEvent *event) override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

protected:
    virtual void pressed(const PointerEvent &) {}
    virtual void clicked(const PointerEvent &event) = 0;
    /// Called when a band was drawn, in device pixels.
    virtual void banded(const Rect &band, const PointerEvent &event) = 0;
    /// The shape of the band that a drag begins which is not the tool's own.
    virtual BandShape bandShape(const PointerEvent &) const { return BandShape::Rectangle; }
    /// Called when a band of another shape than a rectangle begins or goes on at the point (canvas units).
    virtual void tracing(Point, BandShape) {}
    /// Called when a band of another shape than a rectangle was drawn; the path is in canvas units.
    virtual void traced(const std::vector<Point> &, BandShape, const PointerEvent &) {}
    /// Returns true if the drag that begins is the tool's own.
    virtual bool beginDrag(const PointerEvent &) { return false; }
    virtual void drag(const PointerEvent &) {}
    virtual void endDrag(bool /*cancelled*/) {}

    std::optional<SegmentRef> pick(const PointerEvent &event) const;
    /// The distance from the pointer, in canvas units, in which hairlines are found.
    double tolerance() const;
    const Selection &selection() const;
    void select(Selection selection);
    /// Selects one segment. A run of segments may start from it.
    void selectSegment(const SegmentRef &segment);
    /// Adds one segment to the selection. A run of segments may start from it.
    void addSegment(const SegmentRef &segment);
    /// Adds the segments from the last one that was clicked to the one under the pointer. Both belong to that stroke,
    /// even where another one lies above it. Returns false if the last one is no longer selected, or its stroke is not
    /// seen under the pointer.
    bool selectRun(const PointerEvent &event);
    const PointerEvent &start() const { return m_start; }

private:
    enum class State { Idle, Pressed, Band, Drag };

    Rect band() const;
    void beginMoving();
    void addToTrace(const PointerEvent &event);
    void finishBand(const PointerEvent &event);
    QPainterPath bandPath(const View &view) const;
    void updateBand() const;

    State m_state = State::Idle;
    PointerEvent m_start;
    PointerEvent m_now;
    BandShape m_shape = BandShape::Rectangle;
    std::vector<Point> m_trace; ///< the path of the band, canvas units
    SegmentRef m_anchor;
    ValueEntry m_nudges;
};

} // namespace suffuse
