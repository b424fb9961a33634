// The view that the user moves, and how an older picture lies in it.
#pragma once

#include "render/view.h"

#include <QPolygonF>
#include <QTransform>

namespace suffuse {

/// A View that hands move. Pixels are device pixels. What a function has under the pixel that it names stays there.
class ViewTransform {
public:
    static constexpr double minScale = 1e-3;
    static constexpr double maxScale = 1e9;

    const View &view() const { return m_view; }

    /// Takes another size of the picture; what was in the centre stays there.
    void resize(int width, int height);
    /// Moves the canvas under the window by device pixels.
    void panBy(Point pixels);
    /// Zooms by a factor, within minScale … maxScale.
    void zoomAt(Point pixel, double factor) { setScaleAt(pixel, m_view.scale * factor); }
    /// Sets the scale in pixels per canvas unit, within minScale … maxScale.
    void setScaleAt(Point pixel, double scale);
    /// Turns the canvas clockwise on the screen, by radians.
    void rotateAt(Point pixel, double radians) { setRotationAt(pixel, m_view.rotation + radians); }
    /// Sets the rotation of the canvas, in radians.
    void setRotationAt(Point pixel, double radians);
    /// Swaps left and right on the screen.
    void mirrorAt(Point pixel);
    /// Shows all of `area` as large as possible, with `margin` device pixels around it. Rotation and mirroring stay.
    void fit(const Rect &area, double margin);
    /// Shows what another view shows, in a picture of the same size. The scale stays within minScale … maxScale.
    void show(const View &view);
    Point centrePixel() const { return {0.5 * m_view.width, 0.5 * m_view.height}; }

private:
    template <typename Change>
    void keeping(Point pixel, Change change);

    View m_view;
};

/// Maps pixels of a picture that shows `from` to pixels of one that shows `to`; the differences are taken in canvas
/// units first, so that deep zoom loses nothing.
QTransform mapBetween(const View &from, const View &to);

/// The four corners of a canvas rectangle in pixels, clipped to `clip` in double precision (coordinates at deep zoom
/// are far beyond what a painter takes). May be empty.
QPolygonF clippedCorners(const View &view, const Rect &area, const Rect &clip);

/// Shortens a line, in place, to its part in `clip`. Returns false if nothing of it lies there.
bool clipLine(Point &a, Point &b, const Rect &clip);

} // namespace suffuse
