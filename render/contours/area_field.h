// The density of a fill that spreads, with its slope, for whoever asks for many points near the outline.
#pragma once

#include "model/painting/stroke.h"
#include "render/contours/gauss_bins.h"

#include <array>
#include <map>
#include <vector>

namespace suffuse::contours {

/// φ_fill by Green's theorem: nodes along the boundary, each of which counts right of itself (docs/solver.md, "Fills").
/// What lies far left of a place is a polynomial of the height there.
class AreaField {
public:
    /// The stroke must have a fill that is there and spreads. Nodes count up to `reach` spreads.
    AreaField(const Stroke &stroke, Microseconds T, double reach);

    /// At a point relative to the stroke's origin.
    Sloped at(Point p) const;
    /// φ_fill far inside the area.
    double density() const { return m_density; }
    double narrowest() const { return m_narrowest; }
    /// Where the outline is so near that the density is neither 0 nor that far inside.
    bool isNear(const Rect &box) const;
    /// What the density changes in; empty if there is no area.
    Rect box() const { return m_box; }

private:
    struct Node {
        Point at;
        double weight;
    };
    static constexpr std::size_t terms = 18;
    using Polynomial = std::array<double, terms>; ///< of the height from the row's middle, in rows
    struct Bin {
        std::int64_t column = 0;
        std::uint32_t begin = 0, end = 0; ///< in m_near
        Polynomial left{};
    };

    void addArc(const Cubic &curve, int enters, int depth);
    void makeRows(double reach);

    double m_density = 0, m_narrowest = 0;
    double m_a = 1, m_b = 0, m_c = 1; ///< u = a·dx + b·dy, v = c·dy, in which the Gaussian is e^(−u² − v²)
    double m_width = 1, m_height = 1; ///< of a bin
    Rect m_box;
    std::vector<Node> m_nodes;
    std::vector<std::uint32_t> m_near;
    std::map<std::int64_t, std::vector<Bin>> m_rows;
};

} // namespace suffuse::contours
