// The view of the canvas as hands move it.
#pragma once

#include "app/canvas/view_transform.h"

#include <QObject>

namespace suffuse {

/// The view that the canvas shows, and whether it is fitted. All points are device pixels of the canvas widget.
class CanvasView : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    const View &view() const { return m_transform.view(); }
    Point centre() const { return m_transform.centrePixel(); }
    /// It has not been moved by hand since it was fitted.
    bool isFitted() const { return m_fitted; }

    /// All of `area` (canvas units), with `margin` around.
    void fit(const Rect &area, double margin);
    /// Another size of the widget. It emits nothing: whoever calls it knows whether the view is to be fitted, too.
    void resize(int width, int height) { m_transform.resize(width, height); }

    // By hand: it is fitted no more.
    void panBy(Point pixels);
    void zoomAt(Point pixel, double factor);
    void setScaleAt(Point pixel, double scale);
    void rotateAt(Point pixel, double radians);
    void resetRotation();
    void mirror();
    void lookThrough(const View &view);
    /// Turns around the centre, as a hand does that goes from one point to another.
    void turnBy(Point from, Point to);
    /// What lay under two fingers lies under them again.
    void pinch(Point from1, Point to1, Point from2, Point to2);

signals:
    void moved();

private:
    void moveByHand();

    ViewTransform m_transform;
    bool m_fitted = true;
};

} // namespace suffuse
