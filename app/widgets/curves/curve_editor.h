#pragma once

#include "app/widgets/curves/curve_field.h"

#include <vector>

namespace suffuse {

/// A curve over [0, 1] with values in [0, 1]: knots that are joined by straight lines. Without `places` one knot is a
/// constant, two knots are a ramp, and more are a drawn curve; they are evenly spread.
struct PlaceCurve {
    std::vector<double> knots{0.5};
    /// Where the knots of a curve of points lie: in order, from 0 to 1.
    std::vector<double> places = {};
    /// Where a drawn curve was drawn over: 1 at such knots, 0 at those that show what was there. Empty: 1 everywhere.
    std::vector<double> drawn = {};

    double at(double place) const;
    double drawnAt(double place) const;
    bool isPoints() const { return !places.empty(); }
    friend bool operator==(const PlaceCurve &, const PlaceCurve &) = default;
};

/// Edits a PlaceCurve. The line of a constant and the ends of a ramp are dragged; a drawn curve is drawn over; points
/// are dragged, a press beside them makes another one, and Del or a double click removes one. Arrow keys move the knot
/// that was dragged last.
class CurveEditor : public CurveField {
    Q_OBJECT

public:
    static constexpr int drawnKnots = 97;

    using CurveField::CurveField;

    void setCurve(const PlaceCurve &curve);
    /// Who gives the drag up from now on comes back to the curve as it is.
    void keepDragSoFar() { m_before = m_curve; }
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
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void takeBack() override { setCurve(m_before); }
    bool event(QEvent *event) override;

private:
    /// The point under the pointer, in widget coordinates; −1: none.
    int pointAt(QPointF pointer) const;
    void takePoint(QPointF pointer);
    void removePoint(std::size_t point);
    void stepPlace(double by);
    void dragTo(QPointF at);
    void drawTo(QPointF to);

    PlaceCurve m_curve;
    PlaceCurve m_before; ///< the curve when the drag began
    std::vector<QPointF> m_present;
    std::size_t m_knot = 0; ///< the knot that was dragged last
    QPointF m_last;
};

} // namespace suffuse
