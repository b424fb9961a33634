#include "app/canvas/overlay/shown_selection.h"

#include "app/session/editor.h"

#include <algorithm>

namespace suffuse {

namespace {

/// The box in pixels around a box of the canvas, however the view is turned.
Rect pixelBox(const Rect &units, const View &view)
{
    Rect box;
    for (const Point &corner : {Point{units.left, units.top}, Point{units.right, units.top},
                                Point{units.right, units.bottom}, Point{units.left, units.bottom}})
        box.include(view.toPixels(corner));
    return box;
}

} // namespace

const Selection &ShownSelection::selection() const
{
    const Document &document = m_editor.unsettled();
    return m_begun.at(m_editor.clock().time(), document.painting()->strokes, document.selection());
}

bool ShownSelection::followMoment()
{
    if (m_editor.selection().isEmpty() || m_begun.holds(m_editor.clock().time()))
        return false;
    const std::set<StrokeId> before = m_begun.leftOut();
    selection();
    return m_begun.leftOut() != before;
}

Rect ShownSelection::curves() const
{
    return m_outline.curveBoxOf(*m_editor.document().painting(), selection());
}

QRect ShownSelection::curvesInView(const View &view, const QRect &canvas, double dpr) const
{
    const Rect units = curves();
    if (units.isEmpty())
        return {};
    const Rect pixels = pixelBox(units, view);
    const QRectF logical(pixels.left / dpr, pixels.top / dpr, pixels.width() / dpr, pixels.height() / dpr);
    // The boxes of straight strokes may have no width or no height.
    return (logical.adjusted(-1, -1, 1, 1) & QRectF(canvas)).toAlignedRect();
}

QRegion ShownSelection::area(const View &view, double margin, double dpr) const
{
    if (selection().isEmpty())
        return {};
    return QRegion(markedArea(m_outline.boxOf(*m_editor.unsettled().painting(), selection()), margin, view, dpr));
}

QRect markedArea(const Rect &units, double margin, const View &view, double dpr)
{
    constexpr double lines = 12; // logical pixels that the outline takes
    if (units.isEmpty())
        return {};
    const Rect box = pixelBox(units, view).grown(std::max(margin, lines * dpr));
    const QRectF pixels(QPointF(box.left, box.top), QPointF(box.right, box.bottom));
    return (pixels & QRectF(0, 0, view.width, view.height)).toAlignedRect();
}

} // namespace suffuse
