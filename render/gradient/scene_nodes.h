// The nodes of a scene in pixels, and the way back from derivatives by them to those by the scene's numbers.
#pragma once

#include "render/gradient/node_rule.h"

namespace suffuse::gradient {

struct PixelNode {
    double x, y, weight; ///< pixels; the weight is negative where paint is taken away
};

/// What the nodes of a segment, or of a fill, have in common, in pixels, and where they are.
struct PixelSegment {
    std::uint32_t first = 0, end = 0; ///< its nodes
    std::uint32_t stroke = 0;
    bool lift = false, fade = false;
    bool outline = false; ///< whether it is a fill
    double inverse = 0;   ///< 1/s
    double reach = 0;     ///< R s
    double cut = 0;
    float left = 1e30f, top = 1e30f, right = -1e30f, bottom = -1e30f; ///< a box of its nodes' places
};

struct SceneNodes {
    std::vector<PixelNode> nodes;
    std::vector<float> x, y, strength;  ///< of each node, rounded, and the size of its weight: what is looked through
    std::vector<PixelSegment> segments; ///< of the scene, then its fills, then what is far inside of each fill
    std::size_t fillCount = 0;
    std::vector<std::uint32_t> fills; ///< of each stroke: the place of its fill among them; noFill
};
inline constexpr std::uint32_t noFill = 0xffffffff;

/// The place of what is far inside of a fill, where its density is ρ: a node whose spread has no end.
inline std::uint32_t insideOf(const SceneNodes &nodes, std::uint32_t fill)
{
    return std::uint32_t(fill + nodes.fillCount);
}

/// Derivatives by a node's weight, place and spread, in pixels.
struct NodeSum {
    double weight = 0, x = 0, y = 0, spread = 0;
};

/// Places the nodes. The vectors of `out` keep their memory.
void placeNodes(const FlatScene &scene, const NodeRules &rules, SceneNodes &out);

/// Adds up what nodes say of control points, φˢ, ρ and s. Other numbers of `out` are left.
void nodesToNumbers(const FlatScene &scene, const NodeRules &rules, const std::vector<NodeSum> &sums,
                    FlatGradient &out);

} // namespace suffuse::gradient
