// The view of the canvas, and the ways in which hands move it.
#pragma once

#include "app/canvas/view_transform.h"

#include <QObject>

namespace suffuse {

/// The view that the canvas shows. It knows whether it is fitted to the canvas. All points are device pixels of the
/// canvas widget.
class CanvasView : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    const View &view() const { return m_transform.view(); }
    Point centre() const { return m_transform.centrePixel(); }
    /// Whether nobody has moved the view by hand since it was fitted.
    bool isFitted() const { return m_fitted; }

    /// Shows all of `area` (canvas units) with a margin around it (device pixels).
    void fit(const Rect &area, double margin);
    /// Shows all of `area` (canvas units) with a margin around it (device pixels), as a hand would.
    void lookAt(const Rect &area, double margin);
    /// Takes another size of the widget. It emits nothing, since the caller knows whether the view is to be fitted,
    /// too.
    void resize(int width, int height) { m_transform.resize(width, height); }

    /// Moves the canvas by pixels, as many whole ones as there are with what was left over before: then the picture has
    /// to be drawn only where it comes into view. This and what follows are moves by hand, after which the view is no
    /// longer fitted.
    void panBy(Point pixels);
    /// Moves the canvas no further than that a box of pixels (left, top, right, bottom) lies within the view, if it can
    /// with a margin around it; a larger box comes into the middle. What is seen already stays where it is.
    void bringIntoView(const Rect &pixels, double margin);
    /// Zooms by a factor; the point under the pixel stays there.
    void zoomAt(Point pixel, double factor);
    /// Sets the scale (pixels per canvas unit); the point under the pixel stays there.
    void setScaleAt(Point pixel, double scale);
    /// Turns the canvas clockwise by an angle in radians; the point under the pixel stays there.
    void rotateAt(Point pixel, double radians);
    /// Turns the canvas upright around the centre of the view.
    void resetRotation();
    /// Mirrors the view around its centre.
    void mirror();
    /// Shows what another view shows.
    void lookThrough(const View &view);
    /// Turns the canvas around the centre, as a hand does that moves from one point to another.
    void turnBy(Point from, Point to);
    /// Moves, turns and zooms the canvas so that what lay under two fingers lies under them again.
    void pinch(Point from1, Point to1, Point from2, Point to2);

signals:
    /// Emitted when another part of the canvas is shown.
    void moved();

private:
    void moveByHand();

    ViewTransform m_transform;
    bool m_fitted = true;
    Point m_leftOver; ///< what the canvas is still to be moved by, less than half a pixel
};

} // namespace suffuse
