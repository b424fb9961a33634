#pragma once

#include "app/session/gesture.h"
#include "app/session/painting/attribute_brush.h"
#include "app/tools/sized_tool.h"

#include <QBasicTimer>

namespace suffuse {

class WishFields;

/// Paints a quantity onto the segments that are there: the selected ones, or all without a selection. The nearer a
/// segment's middle is, and the longer the brush stays, the more it gets; no more than the whole wish a stroke of the
/// brush.
class AttributeBrushTool : public SizedTool {
    Q_OBJECT

public:
    explicit AttributeBrushTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    QWidget *options() override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    bool changesAnything() const override { return true; }
    bool isBusy() const override { return m_gesture.isOpen(); }
    void cancel() override;

    const AttributeWish &wish() const { return m_wish; }
    /// The colour of a wish is always the current one.
    void setWish(const AttributeWish &wish);
    /// Share of the wish that one dab of full pressure lays down in the middle, (0, 1].
    void setFlow(double flow);

protected:
    void timerEvent(QTimerEvent *event) override;

private:
    /// A segment that may be painted.
    struct Target {
        StrokeId stroke = 0;
        int segment = 0;
        Point middle;
        double left = 1; ///< share of the wish that has not been laid down
    };

    void gatherTargets();
    void dabAt(Point point, double pressure);
    void show();
    void finish();

    QPointer<QWidget> m_options;
    QPointer<WishFields> m_fields; ///< in the options
    AttributeWish m_wish;
    double m_flow = 0.2;

    PointerEvent m_last;
    std::vector<Target> m_targets; ///< in the order of the strokes' ids and segments
    std::set<StrokeId> m_touched;
    Gesture m_gesture;
    QBasicTimer m_timer; ///< lays down more while the pointer stays
};

} // namespace suffuse
