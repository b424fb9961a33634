// Affine maps of strokes, and what becomes of their spread.
#pragma once

#include "model/painting/stroke.h"

#include <optional>

namespace suffuse {

/// x′ = M x + offset, M = (a b; c d).
struct Affine {
    double a = 1, b = 0;
    double c = 0, d = 1;
    Point offset;
    friend bool operator==(const Affine &, const Affine &) = default;

    static Affine translation(Point by) { return {1, 0, 0, 1, by}; }
    /// M with a point that stays where it is.
    static Affine about(Point fixed, double a, double b, double c, double d);
    static Affine scaling(Point fixed, double x, double y) { return about(fixed, x, 0, 0, y); }
    /// Radians, from the x axis towards the y axis.
    static Affine rotation(Point fixed, double angle);
    /// x′ = x + kx·y, y′ = y + ky·x, seen from the fixed point.
    static Affine skew(Point fixed, double kx, double ky) { return about(fixed, 1, kx, ky, 1); }
    /// Maps one rectangle onto another, sides parallel; a side of no length is not scaled.
    static Affine between(const Rect &from, const Rect &to);

    Point turned(Point vector) const { return {a * vector.x + b * vector.y, c * vector.x + d * vector.y}; }
    Point operator()(Point p) const { return turned(p) + offset; }
    double determinant() const { return a * d - b * c; }
    bool isIdentity() const { return *this == Affine(); }
    bool isTranslation() const { return a == 1 && b == 0 && c == 0 && d == 1; }
    /// Turns, mirrors and scales evenly, but for rounding.
    bool isSimilarity() const;
    /// None where the determinant is 0.
    std::optional<Affine> inverse() const;
};
/// First `before`, then `after`.
Affine operator*(const Affine &after, const Affine &before);

/// Whether spread and density follow the shape.
enum class SpreadRule {
    Scales, ///< the picture is mapped: D·k², φ·k; uneven maps make a tensor A·D·Aᵀ
    Stays,  ///< the curve alone is mapped
};

/// The mapped stroke. Translations move the origin alone. Under uneven maps that scale the spread, φ′ = φ·|det A|·l/l′
/// by lengths, and segments are split (exactly) into as few as keep the dry density within half a per cent: |dl|/|dl′|
/// varies by at most 1 % in a part that is longer than the spread s, by 0.07·s/l in a shorter one of length l.
/// `sources`: for each segment of the result, the index of that it came from. None if the map is not invertible or a
/// value leaves its domain.
std::optional<Stroke> tryTransformed(const Stroke &stroke, const Affine &map, SpreadRule rule,
                                     std::vector<int> *sources = nullptr);
/// The same; the stroke itself where it cannot be.
Stroke transformed(const Stroke &stroke, const Affine &map, SpreadRule rule);

/// The curves' own box, exact; without their spread. Canvas units.
Rect curveBox(const Cubic &cubic);
Rect curveBox(const Stroke &stroke);
/// Around all control points, which is quicker; canvas units.
Rect controlBox(const Stroke &stroke);

} // namespace suffuse
