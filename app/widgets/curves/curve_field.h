// The common part of curve editors: the field, with a grid and names of the axes, and how curve and knots look.
#pragma once

#include <QWidget>

class QPainter;
class QPainterPath;

namespace suffuse {

/// A field of [0, 1] × [0, 1]. Derived classes start the drags. Esc gives a drag up.
class CurveField : public QWidget {
    Q_OBJECT

public:
    explicit CurveField(QWidget *parent = nullptr);

    /// Sets texts over the field and at both ends under it. Where they are empty the field takes their room.
    void setTexts(const QString &above, const QString &left, const QString &right);
    /// Puts 0 on top, for quantities that are shown in the opposite sense.
    void setUpsideDown(bool upsideDown);
    /// Where a place and value of the curve lie in the widget.
    QPointF toWidget(QPointF at) const;
    bool isDragging() const { return m_dragging; }
    /// Ends a drag without a word, since the curve is about something else now.
    void dropDrag() { m_dragging = false; }

signals:
    void edited();   ///< the user has edited the curve
    void released(); ///< a drag has ended
    void givenUp();  ///< a drag was given up, and the curve is as it was before

protected:
    bool event(QEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    /// Makes the curve what it was when the drag began.
    virtual void takeBack() = 0;

    QRectF field() const;
    QPointF fromWidget(QPointF at) const; ///< clamped to the field
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
