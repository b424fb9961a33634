#pragma once

#include "app/tools/canvas_tool.h"

#include <QPointer>

class QHBoxLayout;

namespace suffuse {

class NumberField;

/// A tool that works within a circle around the pointer. The circle is shown, and commands change its size.
class SizedTool : public CanvasTool {
    Q_OBJECT

public:
    static constexpr double leastRadius = 1e-7;
    static constexpr double greatestRadius = 1e5;

    /// Makes the tool with a radius in canvas units, which the settings remember under `name`.
    SizedTool(const QString &name, double radius, CanvasWidget &canvas, QObject *parent);

    QCursor cursor() const override { return Qt::CrossCursor; }
    void hover(const PointerEvent &event) override;
    void leave() override;
    void stepSize(int steps) override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

    /// The radius of the circle.
    double radius() const { return m_radius; } ///< canvas units
    /// Sets the radius (canvas units) and remembers it in the settings.
    void setRadius(double radius);

protected:
    /// Adds a field to the tool's row that shows the radius as a diameter.
    void addSizeField(QHBoxLayout &row);
    void showCircleAt(Point pixel);
    /// A faint ring within the circle, at a share of its radius: what is done fades from there on.
    void paintSoftRing(QPainter &painter, double share, const View &view, double dpr) const;

private:
    void repaintCircle();

    QString m_name;
    double m_radius;
    QPointer<NumberField> m_field;
    bool m_shown = false;
    Point m_pixel; ///< where the middle of the circle is
};

} // namespace suffuse
