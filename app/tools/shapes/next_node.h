// What was typed of the node that comes next in an outline.
#pragma once

#include "model/geometry/geometry.h"

#include <array>
#include <optional>

namespace suffuse {

/// Numbers of a node that is not set yet: its place, or the way to it from the node before. Those of the place and
/// those of the way exclude each other, and the one that is typed last counts. What is not typed is where the pointer
/// is.
class NextNode {
public:
    enum class Number { X, Y, Length, Angle };
    static constexpr std::array numbers{Number::X, Number::Y, Number::Length, Number::Angle};

    /// Takes a number: canvas units, or radians clockwise from the right for the angle.
    void type(Number number, double value);
    void forget(Number number) { m_typed[std::size_t(number)].reset(); }
    void clear() { m_typed = {}; }

    std::optional<double> typed(Number number) const { return m_typed[std::size_t(number)]; }
    bool isAnyTyped() const;
    /// Whether length or angle is typed.
    bool isWayTyped() const { return typed(Number::Length) || typed(Number::Angle); }
    /// Whether a pointer is needed to say where the node is; `isFirst`: there is no node before it.
    bool needsPointer(bool isFirst) const;

    /// Where the node is, canvas units. `pointed` is where the pointer is, or where it would be, and `from` is the node
    /// before. As with Shift, an angle leaves the node as far from there as the pointer is.
    Point place(Point pointed, std::optional<Point> from) const;

private:
    std::array<std::optional<double>, numbers.size()> m_typed;
};

} // namespace suffuse
