// How many Gauss-Legendre nodes each segment of a flat scene has, and how far they reach. They are chosen before the
// picture is drawn, so that it is a smooth function of the scene's numbers.
#pragma once

#include "render/gradient/outline_rule.h"
#include "render/threads/parallel.h"

namespace suffuse::gradient {

/// A node at c(p): its place and c′(p) are linear in the control points.
struct RuleNode {
    double point[4], slope[4]; ///< the cubic Bernstein polynomials at p, and their derivatives
    double weight;             ///< of the quadrature over [0, 1]
};

struct SegmentRule {
    std::uint32_t first = 0, end = 0; ///< its nodes
    double radius = 0;                ///< R, where they are cut off, in spreads
    double cut = 0;                   ///< e^(−R²)
    double gain = 1;                  ///< makes up for the cut
};

struct NodeRules {
    std::vector<SegmentRule> segments;
    std::vector<RuleNode> nodes;
    OutlineRules outlines;
};

/// Chooses nodes as the renderer does (docs/solver.md, "Nodes"), but for segments that it would merge or clip.
NodeRules chooseNodes(const FlatScene &scene, const Precision &precision, const Threads &threads);

} // namespace suffuse::gradient
