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

/// Tells clicks from drags; a drag is a rubber band unless the tool takes it.
class SelectionTool : public CanvasTool {
    Q_OBJECT

public:
    using CanvasTool::CanvasTool;

    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    bool isBusy() const override { return m_state != State::Idle; }
    void cancel() override;
    /// Arrows nudge the selected strokes on screen by 1 unit (Shift: 10, Alt: 1 pixel); Esc deselects.
    bool keyPress(QKeyEvent *event) override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

protected:
    virtual void pressed(const PointerEvent &) {}
    virtual void clicked(const PointerEvent &event) = 0;
    /// The band is in device pixels.
    virtual void banded(const Rect &band, const PointerEvent &event) = 0;
    /// Of the band that a drag begins which is not the tool's own.
    virtual BandShape bandShape(const PointerEvent &) const { return BandShape::Rectangle; }
    /// A band of another shape than a rectangle has begun, or goes on, at the point.
    virtual void tracing(Point, BandShape) {}
    /// A band of another shape than a rectangle; the path is in canvas units.
    virtual void traced(const std::vector<Point> &, BandShape, const PointerEvent &) {}
    /// True if the drag that begins is the tool's own.
    virtual bool beginDrag(const PointerEvent &) { return false; }
    virtual void drag(const PointerEvent &) {}
    virtual void endDrag(bool /*cancelled*/) {}

    std::optional<SegmentRef> pick(const PointerEvent &event) const;
    /// Canvas units around the pointer in which hairlines are found.
    double tolerance() const;
    const Selection &selection() const;
    void select(Selection selection);
    /// Selects one segment, from which a run may start.
    void selectSegment(const SegmentRef &segment);
    /// Adds one segment to what is selected; from it a run may go on.
    void addSegment(const SegmentRef &segment);
    /// Adds the segments from the last one clicked to the one under the pointer, of that stroke even where another lies
    /// above it; false if the last one is not selected any more, or its stroke is not seen there.
    bool selectRun(const PointerEvent &event);
    /// How far an arrow moves things, canvas units; none where the key is no arrow.
    std::optional<Point> nudgeOf(const QKeyEvent &event) const;
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
    std::vector<Point> m_trace; ///< canvas units
    SegmentRef m_anchor;
    ValueEntry m_nudges;
};

} // namespace suffuse
