#include "app/canvas/overlay/missing_pictures.h"

namespace suffuse {

void MissingPictures::paint(QPainter &painter, const View &view, const PaintingPtr &painting,
                            const OverlayColours &colours, double dpr)
{
    if (painting != m_painting) {
        m_painting = painting;
        m_missing.clear();
        const Visibility isVisible(painting->groups);
        for (const StrokePtr &stroke : painting->strokes)
            if (stroke->picture && !stroke->picture->image && isVisible(*stroke))
                m_missing.push_back(stroke);
    }
    for (const StrokePtr &stroke : m_missing) {
        const Picture &picture = *stroke->picture;
        const Point corner = stroke->origin + picture.corner, right = stroke->origin + picture.right;
        const Point down = stroke->origin + picture.down, opposite = right + (down - corner);
        QPainterPath path;
        const auto addLine = [&](Point a, Point b) {
            const Point third = (1.0 / 3) * (b - a);
            addCurve(path, Cubic{{a, a + third, b - third, b}}, view);
        };
        addLine(corner, right), addLine(right, opposite), addLine(opposite, down), addLine(down, corner);
        addLine(corner, opposite), addLine(right, down);
        strokeTwoTone(painter, path, colours.border, dpr, Qt::DashLine);
    }
}

} // namespace suffuse
