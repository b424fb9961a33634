// The chains of a stroke, and its nodes: where segments begin and end.
#pragma once

#include "model/painting/stroke.h"

#include <vector>

namespace suffuse {

/// The segments first … last of a stroke, each of which begins where the one before it ends.
struct Chain {
    int first = 0;
    int last = 0;
    friend bool operator==(const Chain &, const Chain &) = default;
};
/// All chains of a stroke, in order.
std::vector<Chain> chainsOf(const Stroke &stroke);
/// How many chains lay no paint: erasures, as people count them.
int erasureCount(const Stroke &stroke);
/// The chain that a segment belongs to.
Chain chainAt(const Stroke &stroke, int segment);

/// The number of nodes of a stroke. In a stroke of n segments, node k < n is the start of segment k. The ends of the
/// chains follow: node n is that of the last chain; nodes n + 1, n + 2, … are those of the others in order. So a stroke
/// of one chain has the nodes 0 … n along its curve.
int nodeCount(const Stroke &stroke);

/// The segments that meet at a node: the one that ends there and the one that begins there; −1 where there is none.
struct NodeSides {
    int before = -1;
    int after = -1;
    friend bool operator==(const NodeSides &, const NodeSides &) = default;
};
/// The segments at a node; both are −1 where there is no such node.
NodeSides sidesOf(const Stroke &stroke, int node);
/// The node where a segment ends.
int endNode(const Stroke &stroke, int segment);
/// Whether the chain goes on at both sides of the node.
bool isInnerNode(const Stroke &stroke, int node);
/// Whether a chain begins or ends at the node.
bool isEndNode(const Stroke &stroke, int node);
/// Whether a chain ends where it begins. Both ends are then one node for people, the seam.
bool isClosed(const Stroke &stroke, const Chain &chain);
/// A node or, at the seam of a closed chain, both ends of it.
std::vector<int> nodesTogether(const Stroke &stroke, int node);
/// The start and the end of each chain that lays paint, in order.
std::vector<int> endNodesOf(const Stroke &stroke);

/// A stroke that consists of one chain of another one.
Stroke chainOnly(const Stroke &stroke, const Chain &chain);
/// Appends segments as a new chain.
void appendChain(Stroke &stroke, std::vector<Segment> segments);

} // namespace suffuse
