#pragma once

#include "app/session/selecting/snapping.h"
#include "app/tools/canvas_tool.h"
#include "model/shaping/shapes.h"

#include <QPointer>

class QHBoxLayout;

namespace suffuse {

/// Paints a rectangle, an ellipse, a polygon or a star with the brush in hand: its outline, what is within it, or both. The shape is drawn from
/// corner to corner or, with Ctrl, from its middle; polygons and stars always are. It shows as paint while it is
/// dragged, and is selected then. What it was is forgotten: from then on it is a stroke like others.
class ShapeTool : public CanvasTool {
    Q_OBJECT

public:
    explicit ShapeTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    QWidget *options() override;
    ColourTarget::ToolUse colourUse() const override { return ColourTarget::ToolUse::Paints; }
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    bool isBusy() const override { return m_id != 0; }
    void cancel() override;
    /// Return draws the shape in the middle of the view, as large as the last one was.
    bool keyPress(QKeyEvent *event) override;
    bool wantsKey(const QKeyEvent &event) const override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

    const ShapeForm &form() const { return m_form; }
    /// What is drawn from now on; it is remembered in the settings.
    void setForm(const ShapeForm &form);

private:
    StrokePtr strokeBetween(Point a, Point b) const;
    void aim(const PointerEvent &event);
    void finish(const StrokePtr &stroke);
    void showFields();

    ShapeForm m_form;
    Point m_size{120, 80}; ///< from a to b of the last shape, canvas units
    StrokeId m_id = 0;     ///< of the shape in hand; 0: none
    Microseconds m_born = 0;
    Snapping m_snapping;
    Point m_from;   ///< where the drag began, canvas units
    Point m_a, m_b; ///< those of `outlineOf`
    QPointer<QWidget> m_options;
};

} // namespace suffuse
