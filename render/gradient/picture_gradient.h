// The exact gradient of a painting's picture.
#pragma once

#include "render/gradient/flat_painting.h"
#include "render/gradient/scene_gradient.h"

#include <optional>

namespace suffuse::gradient {

/// Derivatives of a loss by the numbers of a segment.
struct SegmentSlopes {
    Point bezier[4];                   ///< by the control points, canvas units
    double density = 0, diffusion = 0; ///< by φˢ and D
    double colour[3] = {};             ///< by R, Y, B
    double opacity = 0, granulation = 0;
};

/// Derivatives of a loss by the numbers of a fill.
struct FillSlopes {
    double density = 0, diffusion = 0; ///< by ρ and D
    double colour[3] = {};             ///< by R, Y, B
    double opacity = 0, granulation = 0;
};

/// Derivatives of a loss by the numbers of a stroke.
struct StrokeGradient {
    std::vector<SegmentSlopes> segments; ///< all of them, in their order
    std::optional<FillSlopes> fill;      ///< if it has one
    double xi[3] = {};
};

/// Derivatives of a loss by the numbers of a painting.
struct PictureGradient {
    std::vector<StrokeGradient> strokes; ///< of all strokes, from bottom to top; 0 where one is not seen
};

/// A picture whose derivatives can be taken: a pure function of painting, time and view, with the same bits for any
/// number of threads.
class DifferentiablePicture {
public:
    /// Draws it. Fails where `flatten` does.
    static Result<DifferentiablePicture> draw(PaintingPtr painting, Microseconds time, const View &view,
                                              const Threads &threads = {}, const Precision &precision = {});

    /// sRGB-encoded R, G, B of each pixel, row by row.
    std::span<const float> picture() const { return m_gradient->picture(); }
    /// Returns the derivatives of a loss, from ∂L/∂(R, G, B) of each pixel.
    PictureGradient backward(std::span<const float> lossByRgb);

private:
    PaintingPtr m_painting;
    Microseconds m_time = 0;
    FlatPainting m_flat;
    std::unique_ptr<SceneGradient<float>> m_gradient;
};

} // namespace suffuse::gradient
