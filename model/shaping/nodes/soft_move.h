// Moves of a part of a stroke that the rest follows softly.
#pragma once

#include "model/painting/stroke_places.h"
#include "model/shaping/curves/chains.h"

#include <optional>
#include <vector>

namespace suffuse {

/// Moves places of a stroke, and takes along what lies within a reach of them along their chains. What lies u reaches
/// away from a place follows by a share (1 − u²)² of the move. Between two places with the shares a and b it is
/// 1 − (1 − a)(1 − b), which is smooth. The move goes on through the seam of a closed chain, and never from one chain
/// to another. Handles turn with the curve, so that smooth curves stay smooth. Values, times and kinds of nodes stay.
///
/// With `Ends::Stay` the ends of a chain stay where they are, unless they are moved themselves or lie nearer than a
/// quarter of the reach: towards an end that is nearer than the reach, the reach goes no farther than the end.
class SoftMove {
public:
    enum class Ends { Follow, Stay };

    /// Moves nodes. If the reach takes nothing along, this is `withNodeMoved`. The stroke must outlive the move.
    SoftMove(const Stroke &stroke, std::vector<int> nodes, double reach, Ends ends = Ends::Follow);
    /// Moves a place on the curve, which gets exactly where it is moved to. If its segment is too long for the reach,
    /// this is `withCurveDragged`.
    SoftMove(const Stroke &stroke, const CurvePlace &place, double reach, Ends ends = Ends::Follow);

    /// The stroke after a move in canvas units; the stroke itself if the result cannot be stored.
    Stroke by(Point move) const;
    /// The segments that follow, in order; none if the reach takes nothing along.
    const std::vector<int> &segments() const { return m_segments; }

private:
    /// By how much of the move each control point of a segment moves.
    struct Shares {
        double control[4] = {0, 0, 0, 0};
    };

    void spread(const Chain &chain, const std::vector<double> &ways, const std::vector<double> &places, double reach);
    bool takesOthersAlong() const;

    const Stroke &m_stroke;
    Ends m_ends;
    std::vector<int> m_nodes;          ///< the nodes that are moved
    std::optional<CurvePlace> m_place; ///< the place that is moved instead
    double m_placeShare = 1;           ///< by how much of the move the shares of its segment move the place
    std::vector<Shares> m_shares;
    std::vector<int> m_segments;
};

} // namespace suffuse
