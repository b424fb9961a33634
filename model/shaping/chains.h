// The chains of a stroke, and its nodes: where segments begin and end.
#pragma once

#include "model/painting/stroke.h"

#include <vector>

namespace suffuse {

/// Segments first … last of a stroke, each of which begins where the one before it ends.
struct Chain {
    int first = 0;
    int last = 0;
    friend bool operator==(const Chain &, const Chain &) = default;
};
/// All chains of a stroke, in order.
std::vector<Chain> chainsOf(const Stroke &stroke);
/// The chain that a segment belongs to.
Chain chainAt(const Stroke &stroke, int segment);

/// Nodes of a stroke of n segments: node k < n is the start of segment k; the ends of the chains follow: node n is that
/// of the last chain, nodes n + 1, n + 2, … are those of the others in order. So a stroke of one chain has the nodes 0
/// … n along its curve.
int nodeCount(const Stroke &stroke);

/// The segments that meet at a node: the one that ends there and the one that begins there; −1: none.
struct NodeSides {
    int before = -1;
    int after = -1;
    friend bool operator==(const NodeSides &, const NodeSides &) = default;
};
/// Both −1 where there is no such node.
NodeSides sidesOf(const Stroke &stroke, int node);
/// The node where a segment ends.
int endNode(const Stroke &stroke, int segment);
/// Whether a chain goes on at both sides of the node.
bool isInnerNode(const Stroke &stroke, int node);

/// The stroke of one chain alone.
Stroke chainOnly(const Stroke &stroke, const Chain &chain);
/// Appends segments as another chain.
void appendChain(Stroke &stroke, std::vector<Segment> segments);

} // namespace suffuse
