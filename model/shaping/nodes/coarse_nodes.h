// The nodes of a stroke that a view shows.
#pragma once

#include "model/painting/stroke_places.h"
#include "model/shaping/curves/chains.h"

#include <vector>

namespace suffuse {

/// Some nodes of a stroke, in order. Two neighbours among them lie at least `gap` apart along their chain (canvas
/// units), and at most three times that where there are nodes between. The ends of chains are always among them, and so
/// are corners that lie at least a third of the gap apart. A smaller gap gives the same nodes and more. Nodes are
/// chosen by their number in the chain rather than by lengths, so that a small change of shape leaves most of them.
std::vector<int> coarseNodes(const Stroke &stroke, double gap);

/// Whether `coarseNodes` leaves out at least half of the nodes within `way` of a place, along its chain.
bool isCrowded(const Stroke &stroke, const CurvePlace &place, double gap, double way);

/// What a stroke becomes where nodes of which not all are shown are deleted.
struct BendsRemoved {
    Stroke stroke;            ///< as many segments, with their values; only curves differ
    std::vector<int> deleted; ///< the nodes of it that are still to be deleted one by one
};

/// A node that is shown for several (`coarseNodes`) stands for the curve up to the shown ones beside it. Where it is
/// deleted, this part takes the curve of one cubic with the tangents at its ends; its segments keep their values and
/// their shares of the way. Of the end of a chain all of the part goes. Nodes of which all between the shown ones are
/// to be deleted, and runs of nodes that follow each other, are left to be deleted one by one.
BendsRemoved withoutBends(const Stroke &stroke, const std::vector<int> &nodes, double gap);

/// The place of a node on its stroke's curve.
CurvePlace placeOfNode(const Stroke &stroke, int node);

} // namespace suffuse
