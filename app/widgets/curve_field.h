// What editors of a curve have in common: its field, with a grid and names of the axes, and how curve and knots look.
#pragma once

#include <QWidget>

class QPainter;
class QPainterPath;

namespace suffuse {

/// A field of [0, 1] × [0, 1]. Who derives from it starts drags.
class CurveField : public QWidget {
    Q_OBJECT

public:
    explicit CurveField(QWidget *parent = nullptr);

    /// Texts over the field and at both ends under it; the room of empty ones is the field's.
    void setTexts(const QString &above, const QString &left, const QString &right);
    /// Whether 0 is on top: for what is shown in the opposite sense.
    void setUpsideDown(bool upsideDown);
    /// Where a place and value of the curve are in the widget.
    QPointF toWidget(QPointF at) const;

signals:
    void edited(); ///< by hand

protected:
    void mouseReleaseEvent(QMouseEvent *event) override;

    QRectF field() const;
    QPointF fromWidget(QPointF at) const; ///< within the field
    QColor accent() const;
    void paintField(QPainter &painter) const;
    void paintCurve(QPainter &painter, const QPainterPath &path) const;
    void paintKnot(QPainter &painter, QPointF at, bool chosen) const;

    bool m_dragging = false;
    bool m_upsideDown = false;

private:
    QString m_above, m_left, m_right;
};

} // namespace suffuse
