// A painting as plain numbers: what a fit moves thousands of times without making a painting each time.
#pragma once

#include "model/painting/style.h"
#include "render/view.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace suffuse::gradient {

/// Holds the numbers of one segment, or the derivatives of a loss by each of them. A fit may walk through it as an
/// array of doubles.
struct SegmentNumbers {
    double x[4] = {}, y[4] = {}; ///< control points, canvas units
    double density = 0;          ///< φˢ, units
    double spread = 0;           ///< s = √(4Dt), units
    double colour[3] = {};       ///< R, Y, B, each in [0, 1]
    double opacity = 0;          ///< [0, 1]
    double granulation = 0;      ///< ω, [0, 1]; without paper it has no effect, and its derivative is 0
};

/// Holds the numbers of a fill, or the derivatives by them. The outline has no numbers of its own: derivatives by it
/// are part of those by the segments' control points. It is what the chains of the stroke enclose, each closed by a
/// straight line, without those that take paint away or make it paler. It must not cross itself.
struct FillNumbers {
    double density = 0;     ///< ρ
    double spread = 0;      ///< s, units
    double colour[3] = {};  ///< R, Y, B
    double opacity = 0;     ///< [0, 1]
    double granulation = 0; ///< ω
};

/// Says what a segment is, which no derivative changes.
struct SegmentMark {
    bool start = false; ///< whether it begins another chain
    bool lift = false;  ///< whether it takes paint away, or
    bool fade = false;  ///< makes paint paler; then its colour, opacity and ω have no effect

    bool takesPaint() const { return lift || fade; }
};

struct FlatStroke {
    std::uint32_t first = 0, count = 0; ///< its segments
    StyleKind kind = StyleKind::Uniform;
    double xi[3] = {0.5, 0.05, 0};
    double keep = 1; ///< 1 for alpha (22), 1 − β for pigment (23)
    /// Whether the colour, opacity and ω of the first segment hold for all of the stroke, or those of the fill if there
    /// is one. That is cheaper, and the derivatives by them stand there.
    bool oneColour = false;
    bool filled = false; ///< segments with φˢ = 0 are then nothing but its outline, and their derivative by φˢ is 0
    FillNumbers fill;
};

/// Strokes from bottom to top, and what they are looked at with.
struct FlatScene {
    std::vector<SegmentNumbers> segments;
    std::vector<SegmentMark> marks; ///< of each segment; none: each stroke is one chain, and all of it lays paint
    std::vector<FlatStroke> strokes;
    double background[3] = {0, 0, 0}; ///< R, Y, B of the opaque ground
    /// R, Y, B of the ground of each pixel, row by row, in place of `background`; null: it is the same everywhere.
    std::shared_ptr<const std::vector<float>> ground;
    View view;
    std::shared_ptr<const std::vector<float>> paper; ///< η of each pixel, row by row; null: 1
    bool byXi = true; ///< whether derivatives by ξ are wanted; else they are 0, and the others take less time
};

/// Holds the derivatives by all numbers of a scene, in its order.
struct FlatGradient {
    struct OfStroke {
        double xi[3] = {};
        FillNumbers fill;
    };
    std::vector<SegmentNumbers> segments;
    std::vector<OfStroke> strokes;
};

/// Says how exact a picture is. Errors of opacity up to `unseen` may be made by the number of nodes and by where they
/// are cut off; the renderer's own is 5e-4.
struct Precision {
    double unseen = 5e-4;
};

} // namespace suffuse::gradient
