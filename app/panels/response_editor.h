#pragma once

#include "model/response_curve.h"

#include <QWidget>

#include <optional>

namespace suffuse {

/// Edits a ResponseCurve by its points: drag them, click beside them for another, drag one out of the field or press
/// Delete to take it away. Keys: Page Up and Page Down choose a point, arrows move it.
class ResponseEditor : public QWidget {
    Q_OBJECT

public:
    explicit ResponseEditor(QWidget *parent = nullptr);

    void setCurve(const ResponseCurve &curve);
    const ResponseCurve &curve() const { return m_curve; }
    /// Names of the axes, under and over the field.
    void setAxes(const QString &across, const QString &up);
    /// A dot on the curve at an input in [0, 1].
    void setMark(std::optional<double> input);

    /// Where input and value are in the widget.
    QPointF toWidget(QPointF at) const;
    QSize sizeHint() const override { return {220, 220}; }
    QSize minimumSizeHint() const override { return {160, 160}; }

signals:
    void edited(); ///< by hand

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    QRectF field() const;
    QPointF fromWidget(QPointF at) const;
    int pointAt(QPointF at) const;
    void movePoint(QPointF to);
    bool removePoint();

    ResponseCurve m_curve;
    std::size_t m_point = 0; ///< in hand
    bool m_dragging = false;
    std::optional<double> m_mark;
    QString m_across, m_up;
};

} // namespace suffuse
