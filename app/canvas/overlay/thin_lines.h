// Quick lines through strokes, with which the outlines of thousands of strokes are drawn.
#pragma once

#include "app/canvas/overlay/pixel_mask.h"
#include "app/canvas/view_transform.h"
#include "model/painting/stroke.h"
#include "render/pixel_map.h"

#include <QLineF>
#include <QList>
#include <QRect>

#include <algorithm>
#include <cmath>
#include <set>

namespace suffuse {

/// The length of a segment's control polygon, canvas units.
inline double polygonLength(const Segment &segment)
{
    double sum = 0;
    for (std::size_t i = 1; i < 4; ++i) {
        const double dx = segment.bezier[i].x - segment.bezier[i - 1].x,
                     dy = segment.bezier[i].y - segment.bezier[i - 1].y;
        sum += std::sqrt(dx * dx + dy * dy);
    }
    return sum;
}

/// Draws lines of one pixel which are not smoothed, many times faster than a painter does.
class ThinPen {
public:
    /// Sets pixels only in `part`.
    ThinPen(PixelMask &mask, const QRect &part)
        : m_mask(mask), m_left(part.left()), m_top(part.top()), m_right(part.right()), m_bottom(part.bottom()),
          m_inside(Rect::of(0, 0, mask.width() - 1.0, mask.height() - 1.0))
    {}

    void line(Point a, Point b)
    {
        if (!clipLine(a, b, m_inside))
            return;
        constexpr double one = 65536;
        const Point way = b - a;
        const int steps = int(std::max(std::abs(way.x), std::abs(way.y))) + 1;
        int x = int((a.x + 0.5) * one), y = int((a.y + 0.5) * one);
        const int stepX = int(way.x / steps * one), stepY = int(way.y / steps * one);
        for (int i = 0; i <= steps; ++i, x += stepX, y += stepY)
            // The comparison by QRect would be a function call for each pixel.
            if (const int column = x >> 16, row = y >> 16;
                column >= m_left && column <= m_right && row >= m_top && row <= m_bottom)
                m_mask.set(column, row);
    }

private:
    PixelMask &m_mask;
    int m_left, m_top, m_right, m_bottom;
    Rect m_inside;
};

/// Lists lines for a painter instead of drawing them.
struct ListPen {
    QList<QLineF> lines;
    void line(Point a, Point b) { lines << QLineF(a.x, a.y, b.x, b.y); }
};

/// Draws a polyline through each chain of the stroke with points about `spacing` pixels apart. What takes paint away has
/// lines of its own (ErasureLines).
template <typename Pen>
void drawStroke(Pen &pen, const Stroke &stroke, const PixelMap &pixelOf, double scale, double spacing)
{
    constexpr double mostPieces = 16; // of one segment
    Point last = pixelOf(Point{} + stroke.segments.front().bezier[0]);
    double since = 0; // pixels along the curve since the last point
    const auto goesOn = [&stroke](std::size_t k) { // whether the line goes on to this segment
        return k < stroke.segments.size() && !stroke.beginsChain(k) && !stroke.segments[k].takesPaint();
    };
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const Segment &segment = stroke.segments[k];
        if (segment.takesPaint())
            continue;
        if (!goesOn(k)) {
            last = pixelOf(Point{} + segment.bezier[0]);
            since = 0;
        }
        const double size = polygonLength(segment) * scale;
        const int pieces = int(std::clamp(size / spacing, 1.0, mostPieces));
        Cubic cubic;
        if (pieces > 1)
            for (std::size_t i = 0; i < 4; ++i)
                cubic.p[i] = Point{} + segment.bezier[i];
        for (int i = 1; i <= pieces; ++i) {
            const bool isEnd = !goesOn(k + 1) && i == pieces;
            since += size / pieces;
            if (!isEnd && since < spacing)
                continue;
            since = 0;
            const Point p = pixelOf(i == pieces ? Point{} + segment.bezier[3] : cubic.at(double(i) / pieces));
            pen.line(last, p);
            last = p;
        }
    }
}

/// Draws lines through the chosen segments alone.
inline void drawChosen(ThinPen &pen, const Stroke &stroke, const std::set<int> &chosen, const PixelMap &pixelOf, double scale,
                double spacing)
{
    constexpr double mostPieces = 16;
    for (const int k : chosen) {
        const Segment &segment = stroke.segments[std::size_t(k)];
        const int pieces = int(std::clamp(polygonLength(segment) * scale / spacing, 1.0, mostPieces));
        Cubic cubic;
        for (std::size_t i = 0; i < 4; ++i)
            cubic.p[i] = Point{} + segment.bezier[i];
        Point last = pixelOf(cubic.p[0]);
        for (int i = 1; i <= pieces; ++i) {
            const Point p = pixelOf(i == pieces ? cubic.p[3] : cubic.at(double(i) / pieces));
            pen.line(last, p);
            last = p;
        }
    }
}

} // namespace suffuse
