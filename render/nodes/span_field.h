// This samples the density of a run of nodes on a grid over all that they reach, and compares that of other nodes with
// it.
#pragma once

#include "render/nodes/span_rule.h"

namespace suffuse {

/// The field is computed in floats, relative to the first node, exact to about 1e-6 of the greatest density. All SIMD
/// instruction sets give the same bits.
class SpanField {
public:
    /// Samples `count` nodes on a grid so fine that no ripple of their sum falls between its points.
    void start(const SpanNode *nodes, int count, const VaryingValues &varying);
    /// Returns the greatest difference of the density at a point of the grid, or half the difference of density times a
    /// value if that is greater.
    float difference(const SpanNode *nodes, int count);

    static constexpr int side = spans::Grid::side;
    static constexpr int batch = SpanRule::maxNodes; // nodes that are added at a time
    using Table = float[batch][side];
    using Plane = float[side][side];

private:
    static constexpr int sums = 6; // density, and density times each value that varies

    void fillTables(const SpanNode *nodes, int count);
    void scaleRows(const SpanNode *nodes, int count, int sum);

    double m_x, m_y, m_cos, m_sin; // the grid's axes, which lie along the chord from the first node
    double m_left, m_top;          // the grid's first point
    float m_step;
    int m_columns, m_rows; // rounded up to multiples of 8 and 4
    int m_sums;
    VaryingValues m_varying;
    alignas(64) Table m_column; // e^(−dx²)
    alignas(64) Table m_row;    // e^(−dy²)
    alignas(64) Table m_scaled; // m_row times weight and value
    alignas(64) Plane m_field[sums];
};

} // namespace suffuse
