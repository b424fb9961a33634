#pragma once

#include "app/session/settings/pen_input.h"
#include "app/widgets/brush/stroke_sheet.h"
#include "model/brush/stroke_builder.h"

#include <QWidget>

namespace suffuse {

/// A sheet on which the pen can be tried: it paints with the real brush under a pressure curve.
class PenPad : public QWidget {
    Q_OBJECT

public:
    PenPad(const Brush &brush, QWidget *parent);

    void setCurve(const ResponseCurve &curve);
    void clear();
    const std::vector<StrokePtr> &strokes() const { return m_strokes; }

    QSize sizeHint() const override { return {260, 220}; }

signals:
    /// The pressure that the pen reports; none once it is lifted.
    void pressureReported(double pressure);
    void lifted();

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void tabletEvent(QTabletEvent *event) override;

private:
    void press(QPointF at, double pressure);
    void add(QPointF at, double pressure);
    void release();
    void draw();

    Brush m_brush;
    PenPressure m_pressure;
    StrokeSheet m_sheet;
    std::vector<StrokePtr> m_strokes;
    std::unique_ptr<StrokeBuilder> m_builder;
    Microseconds m_time = 0;
    StrokeId m_nextId = 1;
};

} // namespace suffuse
