// The density of a run of nodes on a grid over all that they reach, and how far other nodes are from it.
#pragma once

#include "render/nodes/span_rule.h"

namespace suffuse {

/// In floats, relative to the first node: exact to about 1e-6 of the greatest density. The same bits from every SIMD
/// set.
class SpanField {
public:
    /// Samples `count` nodes on a grid so fine that no ripple of their sum falls between its points.
    void start(const SpanNode *nodes, int count, bool valuesVary);
    /// Greatest difference at a point of the grid of the density, or half of that of density times a value.
    float difference(const SpanNode *nodes, int count);

    static constexpr int side = 40;  // points along an axis at most
    static constexpr int batch = 16; // nodes at a time
    using Table = float[batch][side];
    using Plane = float[side][side];

private:
    static constexpr int sums = 6; // density, density times each value

    void fillTables(const SpanNode *nodes, int count);
    void scaleRows(const SpanNode *nodes, int count, int sum);

    double m_x, m_y, m_cos, m_sin; // frame: along the chord from the first node
    double m_left, m_top;          // first point
    float m_step;
    int m_columns, m_rows; // rounded up to 8 and 4
    int m_sums;
    alignas(64) Table m_column; // e^(−dx²)
    alignas(64) Table m_row;    // e^(−dy²)
    alignas(64) Table m_scaled; // times weight and value
    alignas(64) Plane m_field[sums];
};

} // namespace suffuse
