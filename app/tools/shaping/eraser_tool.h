#pragma once

#include "app/session/gesture.h"
#include "app/session/selecting/stroke_boxes.h"
#include "app/tools/shaping/eraser_fields.h"
#include "app/tools/sized_tool.h"
#include "model/brush/stroke_builder.h"

namespace suffuse {

/// Takes paint away under its circle, of the selected strokes, of a group, or of all. Fading, the usual way, and
/// lifting are soft: they lay down segments that take paint away from each stroke that is seen there. Cutting takes out
/// what of the curves lies under the circle. Shift takes the other way for one drag: cutting, or the soft one.
class EraserTool : public SizedTool {
    Q_OBJECT

public:
    explicit EraserTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    QCursor cursor() const override;
    QWidget *options() override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    void hover(const PointerEvent &event) override;
    bool changesAnything() const override { return true; }
    bool isBusy() const override { return m_gesture.isOpen(); }
    void cancel() override;
    /// The strength.
    void stepOpacity(int steps) override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

    const EraserChoice &choice() const { return m_choice; }
    /// Is remembered in the settings.
    void setChoice(const EraserChoice &choice);

private:
    void setMode(EraserMode mode);
    void followModifiers(Qt::KeyboardModifiers held);
    void followSelection();
    bool isSoft() const { return m_mode != EraserMode::Cut; }
    SoftTip tip() const;
    void takeTo(const PointerEvent &event);
    void showTaken();
    void cutTo(Point point);
    /// The strokes that the circle may cut on its way.
    std::set<StrokeId> targets(Point from, Point to);
    void finish();
    /// Why the last drag took nothing.
    QString whyNothing() const;
    /// Why no gap is seen where strokes were cut; empty if one is.
    QString whyNoGap() const;

    QPointer<QWidget> m_options;
    QPointer<EraserFields> m_fields; ///< in the options
    EraserChoice m_choice;
    EraserMode m_mode; ///< of this drag; while there is none, of the next one
    EraserReach m_reach;
    Gesture m_gesture;
    std::unique_ptr<SoftEraser> m_soft; ///< while paint is taken softly
    std::vector<PenSample> m_samples;   ///< of this drag
    Microseconds m_began = 0;
    bool m_took = false;      ///< whether this drag has taken anything
    PaintingPtr m_before;     ///< when this drag began
    std::set<StrokeId> m_cut; ///< what it has cut
    StrokeBoxes m_boxes;
};

} // namespace suffuse
