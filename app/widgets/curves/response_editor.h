#pragma once

#include "app/widgets/curves/curve_field.h"
#include "model/brush/response_curve.h"

#include <optional>

namespace suffuse {

/// Edits a ResponseCurve by its points. Points are dragged; a click beside them makes another one; a point that is
/// dragged out of the field, or Delete, is taken away. Page Up and Page Down choose a point, and arrow keys move it.
class ResponseEditor : public CurveField {
    Q_OBJECT

public:
    using CurveField::CurveField;

    void setCurve(const ResponseCurve &curve);
    const ResponseCurve &curve() const { return m_curve; }
    /// Shows a dot on the curve at an input in [0, 1].
    void setMark(std::optional<double> input);

    QSize sizeHint() const override { return {220, 220}; }
    QSize minimumSizeHint() const override { return {160, 160}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void takeBack() override { setCurve(m_before); }

private:
    int pointAt(QPointF at) const;
    void movePoint(QPointF to);
    bool removePoint();

    ResponseCurve m_curve;
    ResponseCurve m_before;  ///< the curve when the drag began
    std::size_t m_point = 0; ///< the point in hand
    std::optional<double> m_mark;
};

} // namespace suffuse
