// Where a stroke's paint is seen, looked at point by point: for the soft eraser.
#pragma once

#include "model/paint/seen_paint.h"

#include <optional>
#include <unordered_map>
#include <utility>

namespace suffuse {

/// Looks at a stroke's paint at the points of a grid, and on its curves where these are hairlines that a grid may miss.
/// Each point is looked at once. Paint counts as it is seen now or when it has dried, whichever is more.
class PaintSamples {
public:
    /// The stroke at time T, without what is painted later. `corner`: a point of the grid; `spacing`: of its points.
    PaintSamples(StrokePtr stroke, Microseconds T, Point corner, double spacing);

    /// By how much density is over that at which paint ends (`visibleCut`), or a quarter of it if that is more, within
    /// a circle: the upper quartile of the points at which paint is seen; 0: at none.
    double excessWithin(Point centre, double radius);
    /// From now on the density of a lifting segment, in the stroke's offsets, is taken away.
    void take(const Segment &lift);

    const StrokePtr &stroke() const { return m_stroke; }

private:
    struct PaintAt {
        const Style *style = nullptr; ///< of the segment with the largest share
        double density = 0;
        double opacity = 0; ///< of that segment's colour, of which less is left where it was made paler
        double taken = 0;   ///< density
    };
    /// A point on a hairline's curve, as seen from the stroke's origin.
    struct HairlinePoint {
        Point at;
        std::optional<PaintAt> sample;
    };
    using Cell = std::pair<int, int>;
    struct HashOfCell {
        std::size_t operator()(const Cell &cell) const
        {
            return std::size_t(cell.first) * 0x9e3779b97f4a7c15 + std::size_t(cell.second);
        }
    };

    void placeOnHairlines();
    PaintAt look(Point fromOrigin) const;
    PaintAt &sampleOf(const Cell &cell);
    Point pointOf(const Cell &cell) const;

    StrokePtr m_stroke;
    StrokePtr m_present;              ///< what of it is there at the moment: samples point into it
    std::vector<PaintSight> m_sights; ///< now, and when it has dried
    Microseconds m_time;
    Point m_corner; ///< as seen from the stroke's origin
    double m_spacing;
    std::unordered_map<Cell, PaintAt, HashOfCell> m_grid;
    std::vector<HairlinePoint> m_places;
    std::vector<DensityOfSegment> m_taken;
    bool m_isPlaced = false;
};

} // namespace suffuse
