// Whose values the pieces of an outline have that was made of others: those of the segments where they came from.
#pragma once

#include "model/painting/stroke.h"

#include <unordered_map>
#include <vector>

namespace suffuse {

/// The segments that bound the fills of strokes, by their places.
class BoundValues {
public:
    /// Places are offsets from the origin of `to`, whose segments go before those of the others where both are as near.
    /// Strokes are there as long as this is.
    BoundValues(const Stroke &to, const std::vector<StrokePtr> &others);

    bool isEmpty() const { return m_curves.empty(); }
    struct Found {
        std::size_t number = 0; ///< of the values; equal ones have one number
        bool isThere = true;    ///< whether the curve is a part of a segment that has them
    };
    /// The values for a curve: those of the segment that is nearest to it all along.
    Found valuesAt(const Cubic &curve) const;
    /// The segment with these values, as one of the stroke `to`.
    const Segment &values(std::size_t number) const { return m_values[number]; }

private:
    struct Source {
        Cubic curve;
        std::size_t values = 0;
    };
    void add(const Stroke &stroke, const Stroke &to);
    void spread();
    std::int64_t cellOf(Point p) const;

    std::vector<Source> m_curves;
    std::vector<Segment> m_values;
    Rect m_box;
    double m_step = 1; ///< between samples
    double m_cell = 1; ///< the side of a cell
    std::int64_t m_columns = 1, m_rows = 1;
    struct Sample {
        Point at;
        std::uint32_t curve = 0;
    };
    std::unordered_map<std::int64_t, std::vector<Sample>> m_cells;
};

} // namespace suffuse
