// How much of each pixel lies within closed paths, exactly but for curves that become short lines.
#pragma once

#include "model/geometry/geometry.h"

#include <vector>

namespace suffuse {

/// A window of pixels into which paths are put one after the other.
class PathCoverage {
public:
    PathCoverage(int width, int top, int height);

    /// Adds a curve of a closed path, in pixels. What lies within is counted by the path's winding number.
    void add(const Cubic &curve);
    /// The columns [first, last) that the paths of now touch; empty if there are none.
    int first() const { return m_first; }
    int last() const { return m_last; }
    /// Takes a row's coverage in [0, 1], from first() to last(), and forgets it.
    void takeRow(int row, std::vector<float> &out);
    /// Begins anew; all rows were taken.
    void clear();

private:
    void addLine(Point a, Point b);

    int m_width, m_top, m_height;
    int m_first, m_last;
    std::vector<float> m_sums; ///< what each pixel has more than the one left of it
};

} // namespace suffuse
