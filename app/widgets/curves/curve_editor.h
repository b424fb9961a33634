#pragma once

#include "app/widgets/curves/curve_field.h"

#include <vector>

namespace suffuse {

/// A curve over [0, 1] with values in [0, 1]. One knot is a constant, two knots are a ramp, and more are a drawn curve;
/// they are evenly spread and joined by straight lines.
struct PlaceCurve {
    std::vector<double> knots{0.5};
    double at(double place) const;
};

/// Edits a PlaceCurve. The line of a constant and the ends of a ramp are dragged; a drawn curve is drawn over. Arrow
/// keys move the knot that was dragged last.
class CurveEditor : public CurveField {
    Q_OBJECT

public:
    static constexpr int drawnKnots = 97;

    using CurveField::CurveField;

    void setCurve(const PlaceCurve &curve);
    const PlaceCurve &curve() const { return m_curve; }
    /// Shows the present values as dots: place and value, both in [0, 1].
    void setPresent(std::vector<QPointF> dots);
    /// Sets the texts at the lower and upper end of the axis.
    void setAxis(const QString &low, const QString &high);

    QSize sizeHint() const override { return {360, 200}; }
    QSize minimumSizeHint() const override { return {200, 120}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void takeBack() override { setCurve(m_before); }

private:
    void dragTo(QPointF at);
    void drawTo(QPointF to);

    PlaceCurve m_curve;
    PlaceCurve m_before; ///< the curve when the drag began
    std::vector<QPointF> m_present;
    std::size_t m_knot = 0; ///< the knot that was dragged last
    QPointF m_last;
};

} // namespace suffuse
