// The symmetry in which one paints: what is painted once comes several times.
#pragma once

#include "model/geometry/affine.h"

#include <vector>

namespace suffuse {

enum class SymmetryKind {
    Across,      ///< mirrored to the other side of an upright axis
    Down,        ///< mirrored to the other side of a level axis
    Both,        ///< mirrored at both axes
    Turns,       ///< turned around the centre, once for each arm
    Kaleidoscope ///< turned, and mirrored within each arm
};

/// A finite group of maps that leave the centre where it is. All of them keep lengths.
struct Symmetry {
    static constexpr int leastArms = 2, mostArms = 24;

    bool isOn = false;
    SymmetryKind kind = SymmetryKind::Across;
    Point centre;     ///< canvas units
    double angle = 0; ///< by which the axes are turned clockwise, radians
    int arms = 6;     ///< of Turns and Kaleidoscope

    friend bool operator==(const Symmetry &, const Symmetry &) = default;

    /// Whether the number of arms means anything.
    bool hasArms() const { return kind == SymmetryKind::Turns || kind == SymmetryKind::Kaleidoscope; }
    /// The direction of its first axis or arm: up, of the level axis to the right, turned by the angle. Length 1.
    Point direction() const;
    /// The directions in which lines from the centre bound what is repeated, the first one before all others. An axis
    /// has two of them.
    std::vector<Point> spokes() const;
    /// The maps to all copies but the first, which is what was painted itself; none where it is off.
    std::vector<Affine> copies() const;
};

} // namespace suffuse
