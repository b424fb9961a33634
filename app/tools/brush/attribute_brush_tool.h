#pragma once

#include "app/session/gesture.h"
#include "app/session/painting/attribute_brush.h"
#include "app/tools/sized_tool.h"
#include "model/paint/fill_density.h"

#include <QBasicTimer>

namespace suffuse {

class WishFields;

/// Paints a quantity onto segments that exist: the selected ones or, without a selection, all. A segment gets more the
/// nearer its middle is and the longer the brush stays. A fill gets it as a whole, while the middle of the brush is in
/// it. One stroke of the brush gives no segment more than the whole
/// wish.
class AttributeBrushTool : public SizedTool {
    Q_OBJECT

public:
    explicit AttributeBrushTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    ColourTarget::ToolUse colourUse() const override { return ColourTarget::ToolUse::PaintsOver; }
    QWidget *options() override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    bool changesAnything() const override { return true; }
    bool isBusy() const override { return m_gesture.isOpen(); }
    void cancel() override;

    const AttributeWish &wish() const { return m_wish; }
    /// Sets what is painted. Where the wish is a colour, it is always the current one.
    void setWish(const AttributeWish &wish);
    /// Sets the share of the wish that one dab of full pressure lays down in the middle of the circle, (0, 1].
    void setFlow(double flow);

protected:
    void timerEvent(QTimerEvent *event) override;

private:
    /// A segment that this stroke of the brush may paint.
    struct Target {
        StrokeId stroke = 0;
        int segment = 0;
        Point middle;
        double left = 1; ///< the share of the wish that this segment has not received yet
    };

    /// A fill that it may paint.
    struct FillTarget {
        StrokePtr stroke;
        DensityOfFill density;
        double left = 1;
    };

    void gatherTargets();
    void dabAt(Point point, double pressure);
    void show();
    void finish();

    QPointer<QWidget> m_options;
    QPointer<WishFields> m_fields; ///< one of the fields of the options
    AttributeWish m_wish;
    double m_flow = 0.2;

    PointerEvent m_last;
    std::vector<Target> m_targets; ///< in the order of stroke ids and, within a stroke, of segments
    std::vector<FillTarget> m_fills;
    std::set<StrokeId> m_touched;
    bool m_metFill = false; ///< that cannot have what is painted
    Gesture m_gesture;
    QBasicTimer m_timer; ///< lays down more dabs while the pointer stays
};

} // namespace suffuse
