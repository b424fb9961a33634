// Plain geometry in canvas units; y points down.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace suffuse {

/// A point or vector in canvas units, double precision.
struct Point {
    double x = 0;
    double y = 0;
    friend bool operator==(const Point &, const Point &) = default;
    friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
    friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
    friend Point operator*(double k, Point a) { return {k * a.x, k * a.y}; }
};

inline double dot(Point a, Point b)
{
    return a.x * b.x + a.y * b.y;
}
inline double cross(Point a, Point b)
{
    return a.x * b.y - a.y * b.x;
}
inline double length(Point a)
{
    return std::hypot(a.x, a.y);
}

/// The offset of a control point from its stroke's origin in float32, as files store it.
struct Offset {
    float x = 0;
    float y = 0;
    friend bool operator==(const Offset &, const Offset &) = default;
};

inline Point operator+(Point origin, Offset o)
{
    return {origin.x + double(o.x), origin.y + double(o.y)};
}
inline Offset toOffset(Point p, Point origin)
{
    return {float(p.x - origin.x), float(p.y - origin.y)};
}

/// An axis-aligned rectangle. The default is empty; `united` ignores empty ones.
struct Rect {
    double left = std::numeric_limits<double>::infinity();
    double top = std::numeric_limits<double>::infinity();
    double right = -std::numeric_limits<double>::infinity();
    double bottom = -std::numeric_limits<double>::infinity();

    static Rect of(double x, double y, double width, double height) { return {x, y, x + width, y + height}; }
    bool isEmpty() const { return !(left <= right && top <= bottom); }
    double width() const { return isEmpty() ? 0 : right - left; }
    double height() const { return isEmpty() ? 0 : bottom - top; }
    Point centre() const { return {0.5 * (left + right), 0.5 * (top + bottom)}; }
    bool contains(Point p) const { return p.x >= left && p.x <= right && p.y >= top && p.y <= bottom; }
    bool intersects(const Rect &o) const
    {
        return !isEmpty() && !o.isEmpty() && left <= o.right && o.left <= right && top <= o.bottom && o.top <= bottom;
    }
    void include(Point p)
    {
        left = std::min(left, p.x);
        top = std::min(top, p.y);
        right = std::max(right, p.x);
        bottom = std::max(bottom, p.y);
    }
    Rect united(const Rect &o) const
    {
        return {std::min(left, o.left), std::min(top, o.top), std::max(right, o.right), std::max(bottom, o.bottom)};
    }
    Rect grown(double by) const { return isEmpty() ? *this : Rect{left - by, top - by, right + by, bottom + by}; }
    friend bool operator==(const Rect &, const Rect &) = default;
};

/// A cubic Bézier curve c(p), p in [0, 1], in double precision.
struct Cubic {
    std::array<Point, 4> p;

    friend bool operator==(const Cubic &, const Cubic &) = default;

    Point at(double t) const
    {
        const double u = 1 - t;
        return (u * u * u) * p[0] + (3 * u * u * t) * p[1] + (3 * u * t * t) * p[2] + (t * t * t) * p[3];
    }
    Point derivative(double t) const
    {
        const double u = 1 - t;
        return (3 * u * u) * (p[1] - p[0]) + (6 * u * t) * (p[2] - p[1]) + (3 * t * t) * (p[3] - p[2]);
    }
    /// The box of the control points, which contains the curve.
    Rect controlBox() const
    {
        Rect r;
        for (const Point &q : p)
            r.include(q);
        return r;
    }
    /// Splits the curve at t by de Casteljau's algorithm: the two parts trace the same curve.
    std::array<Cubic, 2> split(double t) const
    {
        const auto mix = [t](Point a, Point b) { return (1 - t) * a + t * b; };
        const Point a = mix(p[0], p[1]), m = mix(p[1], p[2]), b = mix(p[2], p[3]);
        const Point am = mix(a, m), mb = mix(m, b), q = mix(am, mb);
        return {Cubic{{p[0], a, am, q}}, Cubic{{q, mb, b, p[3]}}};
    }
};

/// The length of the control polygon. No arc of the curve is longer.
inline double polygonLength(const Cubic &c)
{
    return length(c.p[1] - c.p[0]) + length(c.p[2] - c.p[1]) + length(c.p[3] - c.p[2]);
}

} // namespace suffuse
