#include "app/canvas/canvas_view.h"

#include <cmath>

namespace suffuse {

namespace {

/// The angle from one direction to another, clockwise on the screen, in radians.
double angleBetween(Point from, Point to)
{
    return std::atan2(cross(from, to), dot(from, to));
}

} // namespace

void CanvasView::fit(const Rect &area, double margin)
{
    m_transform.fit(area, margin);
    m_fitted = true;
    emit moved();
}

void CanvasView::lookAt(const Rect &area, double margin)
{
    m_transform.fit(area, margin);
    moveByHand();
}

void CanvasView::moveByHand()
{
    m_fitted = false;
    emit moved();
}

void CanvasView::panBy(Point pixels)
{
    const Point asked = m_leftOver + pixels, whole{std::round(asked.x), std::round(asked.y)};
    m_leftOver = asked - whole;
    m_transform.panBy(whole);
    moveByHand();
}

void CanvasView::bringIntoView(const Rect &pixels, double margin)
{
    const double width = view().width, height = view().height;
    if (pixels.left >= 0 && pixels.top >= 0 && pixels.right <= width && pixels.bottom <= height)
        return;
    const auto way = [margin](double from, double to, double size) {
        const double free = std::min(margin, size / 4);
        if (to - from > size - 2 * free) // It is larger than the view.
            return (size - from - to) / 2;
        return from < free ? free - from : to > size - free ? size - free - to : 0;
    };
    panBy({way(pixels.left, pixels.right, width), way(pixels.top, pixels.bottom, height)});
}

void CanvasView::zoomAt(Point pixel, double factor)
{
    m_transform.zoomAt(pixel, factor);
    moveByHand();
}

void CanvasView::setScaleAt(Point pixel, double scale)
{
    m_transform.setScaleAt(pixel, scale);
    moveByHand();
}

void CanvasView::rotateAt(Point pixel, double radians)
{
    m_transform.rotateAt(pixel, radians);
    moveByHand();
}

void CanvasView::resetRotation()
{
    m_transform.setRotationAt(centre(), 0);
    moveByHand();
}

void CanvasView::mirror()
{
    m_transform.mirrorAt(centre());
    moveByHand();
}

void CanvasView::lookThrough(const View &view)
{
    m_transform.show(view);
    moveByHand();
}

void CanvasView::turnBy(Point from, Point to)
{
    rotateAt(centre(), angleBetween(from - centre(), to - centre()));
}

void CanvasView::pinch(Point from1, Point to1, Point from2, Point to2)
{
    const Point middle = 0.5 * (to1 + to2), before = from2 - from1, after = to2 - to1;
    m_transform.panBy(middle - 0.5 * (from1 + from2));
    if (length(before) > 1 && length(after) > 1) {
        m_transform.zoomAt(middle, length(after) / length(before));
        m_transform.rotateAt(middle, angleBetween(before, after));
    }
    moveByHand();
}

} // namespace suffuse
