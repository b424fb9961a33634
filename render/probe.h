// Computes what lies at a point of a painting, number by number.
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"

#include <array>
#include <vector>

namespace suffuse {

/// The part of one segment in a stroke's density at the point.
struct ProbeShare {
    int segment = 0;    ///< index of the segment
    bool lifts = false; ///< whether it takes so much paint away
    bool fades = false; ///< whether it makes the paint paler
    double density = 0; ///< φ_k
    double share = 0;   ///< φ_k/φ⁺, where φ⁺ is the sum over the segments that lay paint; 0 if it fades
};

/// A stroke at the point, and the colour of the canvas after it.
struct ProbeStroke {
    StrokeId id = 0;
    QString name;
    double density = 0;             ///< φ (14): what is left of φ⁺ where paint is taken away
    double lifted = 0;              ///< φ⁻, the density that is taken away
    double faded = 0;               ///< φ_f: e^−φ_f of the opacity is left
    double granulation = 1;         ///< ω̄ (15)
    double modulated = 0;           ///< φ′ = γφ (16)
    double densityFunction = 0;     ///< F (17-19)
    std::array<double, 4> colour{}; ///< C̄ (20): R, Y, B, opacity
    double opacity = 0;             ///< w (21)
    std::vector<ProbeShare> shares; ///< of the segments with φ_k > 0, in their order
    double fillDensity = 0;         ///< φ_fill
    double fillShare = 0;           ///< φ_fill/φ⁺
    /// The colour after the stroke: of the canvas or, in a group that blends, of the group's picture over white.
    std::array<double, 3> rybAfter{};
    std::array<double, 3> rgbAfter{};
    /// How much of the final colour the stroke is. It lets 1 − w of what lies below through or, with pigment mixing, 1
    /// − w(1 − β); a group lets 1 − its coverage through.
    double colourShare = 0;
};

struct Probe {
    double paper = 1;                  ///< η, all octaves
    std::array<double, 3> rybBefore{}; ///< background over white
    std::array<double, 3> rgbBefore{};
    std::vector<ProbeStroke> strokes; ///< from bottom to top; those whose reach contains the point, or that colour it
    std::array<double, 3> rybAfter{}; ///< the final colour
    std::array<double, 3> rgbAfter{};
    double canvasShare = 1; ///< how much of it is the bare canvas; 1 with the strokes' shares
};

/// The painting without the strokes that do not reach the point, which probing would integrate all the same. Where a
/// group acts also where it has no stroke, is clipped or is a mask, all stay.
Painting reaching(const Painting &painting, Microseconds time, Point point);

/// Probes the point itself (px → 0: without coverage and supersampling), in canvas units, at document time T. Hidden
/// strokes are left out. It fails if an image paper cannot be decoded.
Result<Probe> probe(const Painting &painting, Microseconds time, double x, double y);

} // namespace suffuse
