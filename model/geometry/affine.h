// Affine maps of the plane.
#pragma once

#include "model/geometry/geometry.h"

#include <optional>

namespace suffuse {

/// x′ = M x + offset, M = (a b; c d).
struct Affine {
    double a = 1, b = 0;
    double c = 0, d = 1;
    Point offset;
    friend bool operator==(const Affine &, const Affine &) = default;

    static Affine translation(Point by) { return {1, 0, 0, 1, by}; }
    /// The map with matrix M that leaves a point where it is.
    static Affine about(Point fixed, double a, double b, double c, double d);
    static Affine scaling(Point fixed, double x, double y) { return about(fixed, x, 0, 0, y); }
    /// A rotation in radians, from the x axis towards the y axis.
    static Affine rotation(Point fixed, double angle);
    /// x′ = x + kx·y, y′ = y + ky·x, relative to the fixed point.
    static Affine skew(Point fixed, double kx, double ky) { return about(fixed, 1, kx, ky, 1); }
    /// Maps one rectangle onto another with parallel sides. A side without length is not scaled.
    static Affine between(const Rect &from, const Rect &to);

    Point turned(Point vector) const { return {a * vector.x + b * vector.y, c * vector.x + d * vector.y}; }
    Point operator()(Point p) const { return turned(p) + offset; }
    double determinant() const { return a * d - b * c; }
    bool isIdentity() const { return *this == Affine(); }
    bool isTranslation() const { return a == 1 && b == 0 && c == 0 && d == 1; }
    /// Whether the map only turns, mirrors and scales evenly, apart from rounding.
    bool isSimilarity() const;
    /// The inverse map; no value where the determinant is 0.
    std::optional<Affine> inverse() const;
};
/// The map that applies `before` first and `after` then.
Affine operator*(const Affine &after, const Affine &before);

} // namespace suffuse
