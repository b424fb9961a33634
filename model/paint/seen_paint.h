// How much of a stroke is seen at a point, quickly, for hit tests, which ask thousands of times.
#pragma once

#include "model/paint/fill_density.h"
#include "model/paint/point_density.h"

#include <optional>

namespace suffuse {

/// A stroke is not seen at a point where its opacity w is less than this.
inline constexpr double visibleOpacity = 0.02;

/// What is seen of a stroke at a point.
struct SeenPaint {
    double density = 0; ///< φ (14)
    double opacity = 0; ///< w (21) on smooth paper, right to about a hundredth of it
    /// the segment with the largest share of the density that is laid or, where only the fill reaches the point, the
    /// nearest one that bounds it; -1 if nothing reaches the point
    int segment = -1;
    double left = 1; ///< e^−φ_f: the share of its opacity that is left where it was made paler
    /// C̄ (20), what all that lays paint there has together, a gradient where the point is; 0 where nothing does
    Colour colour;
};

/// Looks at a stroke at one time. Whoever asks for many points keeps it, since curves are divided when it is made. It
/// refers to the stroke.
class PaintSight {
public:
    PaintSight(const Stroke &stroke, Microseconds T);
    SeenPaint at(Point point) const;

private:
    struct Source {
        int segment;
        DensityOfSegment density;
    };
    const Stroke *m_stroke;
    std::vector<Source> m_sources; ///< the segments that are there
    std::optional<DensityOfFill> m_fill;
};

/// Computes it for one point with a few straight pieces for each curve, whose density has a closed form.
/// `render/probe.h` has the exact figures.
SeenPaint seenPaint(const Stroke &stroke, Microseconds T, Point point);

} // namespace suffuse
