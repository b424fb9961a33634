#pragma once

#include "app/session/gesture.h"
#include "app/session/selecting/stroke_boxes.h"
#include "app/tools/sized_tool.h"

namespace suffuse {

/// Removes the parts of strokes whose curves lie under the circle: of the selected strokes or, without a selection, of
/// all.
class EraserTool : public SizedTool {
    Q_OBJECT

public:
    explicit EraserTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    QWidget *options() override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    bool changesAnything() const override { return true; }
    bool isBusy() const override { return m_gesture.isOpen(); }
    void cancel() override;

private:
    void eraseTo(Point point);
    /// The strokes that the circle may touch on its way from one point to the other.
    std::set<StrokeId> targets(Point from, Point to);

    QPointer<QWidget> m_options;
    Gesture m_gesture;
    Point m_last;
    bool m_fromSelected = false;
    StrokeBoxes m_boxes;
};

} // namespace suffuse
