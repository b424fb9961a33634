#include "app/canvas/view_transform.h"

#include <numbers>
#include <vector>

namespace suffuse {

void ViewTransform::resize(int width, int height)
{
    m_view.width = width;
    m_view.height = height;
}

template <typename Change>
void ViewTransform::keeping(Point pixel, Change change)
{
    const Point canvas = m_view.toCanvas(pixel);
    change(m_view);
    m_view.centre = m_view.centre + (canvas - m_view.toCanvas(pixel));
}

void ViewTransform::panBy(Point pixels)
{
    m_view.centre = m_view.toCanvas(centrePixel() - pixels);
}

void ViewTransform::setScaleAt(Point pixel, double scale)
{
    keeping(pixel, [scale](View &view) { view.scale = std::clamp(scale, minScale, maxScale); });
}

void ViewTransform::setRotationAt(Point pixel, double radians)
{
    const double turn = 2 * std::numbers::pi;
    keeping(pixel, [=](View &view) { view.rotation = std::remainder(radians, turn); });
}

void ViewTransform::mirrorAt(Point pixel)
{
    // Mirroring comes before the rotation in a View; on screen it is a flip after it, hence the turned sign.
    keeping(pixel, [](View &view) {
        view.mirrored = !view.mirrored;
        view.rotation = -view.rotation;
    });
}

void ViewTransform::fit(const Rect &area, double margin)
{
    if (area.isEmpty() || m_view.width <= 0 || m_view.height <= 0)
        return;
    const double c = std::abs(std::cos(m_view.rotation)), s = std::abs(std::sin(m_view.rotation));
    const double width = c * area.width() + s * area.height();
    const double height = s * area.width() + c * area.height();
    const double across = std::max(m_view.width - 2 * margin, 0.5 * m_view.width) / std::max(width, 1e-12);
    const double down = std::max(m_view.height - 2 * margin, 0.5 * m_view.height) / std::max(height, 1e-12);
    m_view.scale = std::clamp(std::min(across, down), minScale, maxScale);
    m_view.centre = area.centre();
}

void ViewTransform::show(const View &view)
{
    const int width = m_view.width, height = m_view.height;
    m_view = view;
    m_view.scale = std::clamp(view.scale, minScale, maxScale);
    m_view.rotation = std::remainder(view.rotation, 2 * std::numbers::pi);
    resize(width, height);
}

QTransform mapBetween(const View &from, const View &to)
{
    const double k = to.scale / from.scale;
    const double flip = from.mirrored == to.mirrored ? 1 : -1;
    // R(to) · M · R(from)⁻¹, M = diag(flip, 1)
    const double c1 = std::cos(from.rotation), s1 = std::sin(from.rotation);
    const double c2 = std::cos(to.rotation), s2 = std::sin(to.rotation);
    const double a = k * (c2 * flip * c1 + s2 * s1), b = k * (c2 * flip * s1 - s2 * c1);
    const double c = k * (s2 * flip * c1 - c2 * s1), d = k * (s2 * flip * s1 + c2 * c1);
    const Point centre = to.toPixels(from.centre);
    const double hx = 0.5 * from.width, hy = 0.5 * from.height;
    return QTransform(a, c, b, d, centre.x - (a * hx + b * hy), centre.y - (c * hx + d * hy));
}

namespace {

/// Sutherland-Hodgman against one half plane: keeps where `side` ≥ 0.
template <typename Side>
std::vector<Point> clipped(const std::vector<Point> &polygon, Side side)
{
    std::vector<Point> out;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double da = side(a), db = side(b);
        if (da >= 0)
            out.push_back(a);
        if ((da >= 0) != (db >= 0))
            out.push_back(a + (da / (da - db)) * (b - a));
    }
    return out;
}

} // namespace

QPolygonF clippedCorners(const View &view, const Rect &area, const Rect &clip)
{
    std::vector<Point> polygon;
    for (const Point corner : {Point{area.left, area.top}, Point{area.right, area.top}, Point{area.right, area.bottom},
                               Point{area.left, area.bottom}})
        polygon.push_back(view.toPixels(corner));
    polygon = clipped(polygon, [&](Point p) { return p.x - clip.left; });
    polygon = clipped(polygon, [&](Point p) { return clip.right - p.x; });
    polygon = clipped(polygon, [&](Point p) { return p.y - clip.top; });
    polygon = clipped(polygon, [&](Point p) { return clip.bottom - p.y; });
    QPolygonF out;
    for (const Point &p : polygon)
        out << QPointF(p.x, p.y);
    return out;
}

bool clipLine(Point &a, Point &b, const Rect &clip)
{
    const Point d = b - a;
    double from = 0, to = 1;
    // Liang-Barsky: each side bounds the part of the line that is inside.
    const double step[4] = {-d.x, d.x, -d.y, d.y};
    const double room[4] = {a.x - clip.left, clip.right - a.x, a.y - clip.top, clip.bottom - a.y};
    for (int i = 0; i < 4; ++i) {
        if (step[i] == 0) {
            if (room[i] < 0)
                return false;
            continue;
        }
        const double t = room[i] / step[i];
        if (step[i] < 0)
            from = std::max(from, t);
        else
            to = std::min(to, t);
    }
    if (from > to)
        return false;
    const Point start = a;
    a = start + from * d;
    b = start + to * d;
    return true;
}

} // namespace suffuse
