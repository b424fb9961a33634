#pragma once

#include "app/tools/shapes/drawing_tool.h"

namespace suffuse {

/// Paints a rectangle, an ellipse, a polygon or a star. The shape is drawn from corner to corner or, with Ctrl, from
/// its middle; polygons and stars always are. It shows as paint while it is dragged, and is selected then. What it was
/// is forgotten: from then on it is a stroke like others.
class ShapeTool : public DrawingTool {
    Q_OBJECT

public:
    explicit ShapeTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    /// Return draws the shape in the middle of the view, as large as the last one was.
    bool keyPress(QKeyEvent *event) override;
    bool wantsKey(const QKeyEvent &event) const override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

    const ShapeForm &form() const { return m_form; }
    /// What is drawn from now on; it is remembered in the settings.
    void setForm(const ShapeForm &form);

protected:
    void addFields(QHBoxLayout &row) override;
    void show() override;
    void forget() override {}

private:
    StrokePtr strokeBetween(Point a, Point b) const;
    void aim(const PointerEvent &event);
    void finish(const StrokePtr &stroke);
    void showFields();

    ShapeForm m_form;
    Point m_size{120, 80}; ///< from a to b of the last shape, canvas units
    Point m_from;          ///< where the drag began, canvas units
    Point m_a, m_b;        ///< those of `outlineOf`
};

} // namespace suffuse
