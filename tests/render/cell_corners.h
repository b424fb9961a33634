// Crisp triangles with an edge that leads exactly through a corner of the 8-pixel grid, where the renderers hand their
// shapes from cell to cell.
#pragma once

#include "tests/render/filled.h"

#include <random>

namespace suffuse::test {

/// Holds the corners of such a triangle on a sheet of 64 × 48 pixels.
struct CellTriangle {
    std::array<Point, 3> corners;

    Stroke shape() const
    {
        Stroke s = emptyFill(1, 0, styleOf(StyleKind::Uniform));
        addPolygon(s, {corners.begin(), corners.end()});
        return s;
    }
};

/// Returns the n-th triangle, the same on every machine.
inline CellTriangle triangleThroughCorner(unsigned n)
{
    std::mt19937 random(31 + n);
    const auto whole = [&](int least, int most) { return double(least + int(random() % unsigned(most - least + 1))); };
    const Point corner{8 * whole(1, 7), 8 * whole(1, 5)}, along{whole(-9, 9), whole(1, 9)};
    const Point begin = corner - whole(0, 4) * along, end = corner + whole(1, 4) * along;
    const double x = whole(0, 64);
    return {{begin, end, Point{x, whole(0, 48)}}};
}

/// Draws triangles, and looks at all pixels that lie a pixel away from their edges: these are covered inside, and free
/// outside.
inline void checkTrianglesThroughCorners(Renderer &renderer, unsigned triangles)
{
    const View view = View::ofArea(Rect::of(0, 0, 64, 48), 64, 48);
    for (unsigned n = 0; n < triangles; ++n) {
        const CellTriangle triangle = triangleThroughCorner(n);
        const auto &corners = triangle.corners;
        const FloatPicture picture = test::render(renderer, painting({triangle.shape()}, 64, 48), view, -1, true);
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x) {
                int right = 0; // of how many sides it lies
                double nearest = 1e9;
                for (std::size_t k = 0; k < 3; ++k) {
                    const Point side = corners[(k + 1) % 3] - corners[k], to = Point{x + 0.5, y + 0.5} - corners[k];
                    const double distance = (side.x * to.y - side.y * to.x) / std::max(length(side), 1e-9);
                    right += distance > 0;
                    nearest = std::min(nearest, std::abs(distance));
                }
                const float covered = picture.at(x, y)[3];
                if (nearest > 1)
                    QVERIFY2(right % 3 == 0 ? covered > 0.5f : covered == 0,
                             qPrintable(QStringLiteral("%1: %2 at %3, %4").arg(n).arg(covered).arg(x).arg(y)));
            }
    }
}

} // namespace suffuse::test
