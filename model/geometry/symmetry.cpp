#include "model/geometry/symmetry.h"

#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

/// Sines and cosines of right angles are whole numbers, so that what is mirrored at an upright axis keeps its heights.
double whole(double value)
{
    const double nearest = std::round(value);
    return std::abs(value - nearest) < 1e-15 ? nearest : value;
}

Point towards(double angle)
{
    return {whole(std::cos(angle)), whole(std::sin(angle))};
}

Affine turn(Point centre, double angle)
{
    const Point d = towards(angle);
    return Affine::about(centre, d.x, -d.y, d.y, d.x);
}

/// Mirrors at the line through the centre in the direction of an angle.
Affine mirror(Point centre, double angle)
{
    const Point d = towards(2 * angle);
    return Affine::about(centre, d.x, d.y, d.y, -d.x);
}

/// Of the first axis or arm, from the right clockwise.
double firstAngle(const Symmetry &symmetry)
{
    return symmetry.kind == SymmetryKind::Down ? symmetry.angle : symmetry.angle - std::numbers::pi / 2;
}

int turnsOf(const Symmetry &symmetry)
{
    switch (symmetry.kind) {
    case SymmetryKind::Across:
    case SymmetryKind::Down:
        return 1;
    case SymmetryKind::Both:
        return 2;
    case SymmetryKind::Turns:
    case SymmetryKind::Kaleidoscope:
        break;
    }
    return symmetry.arms;
}

} // namespace

Point Symmetry::direction() const
{
    return towards(firstAngle(*this));
}

std::vector<Point> Symmetry::spokes() const
{
    const int lines = kind == SymmetryKind::Turns ? arms : 2 * turnsOf(*this);
    std::vector<Point> all;
    for (int i = 0; i < lines; ++i)
        all.push_back(towards(firstAngle(*this) + 2 * std::numbers::pi * i / lines));
    return all;
}

std::vector<Affine> Symmetry::copies() const
{
    std::vector<Affine> all;
    const int turns = turnsOf(*this);
    for (int i = 0; isOn && i < turns; ++i) {
        const double angle = 2 * std::numbers::pi * i / turns;
        if (i > 0)
            all.push_back(turn(centre, angle));
        if (kind != SymmetryKind::Turns)
            all.push_back(mirror(centre, firstAngle(*this) + angle / 2));
    }
    return all;
}

} // namespace suffuse
