// The outline of a fill as nodes (docs/solver.md, "Fill"): the density within it is a sum over places on it.
#pragma once

#include "render/gradient/flat_scene.h"

namespace suffuse::gradient {

/// A node on an outline. Its place and the slope of its height are linear in the control points of a segment, or in the
/// last one of it and the first one of the segment that begins the chain, where a straight line closes it.
struct OutlineNode {
    std::uint32_t segment = 0, closesTo = 0;
    bool closing = false;
    double point[4] = {}, slope[4] = {}; ///< of a line: only the first two
    double weight = 0;                   ///< of the quadrature
};

/// The nodes of a stroke's fill.
struct OutlineRule {
    std::uint32_t stroke = 0;
    std::uint32_t first = 0, end = 0; ///< its nodes, among those of all outlines
    double radius = 0;                ///< R, where they are cut off in y, in spreads
    double cut = 0;                   ///< e^(−R²)
    double gain = 1;                  ///< makes up for the cut
};

struct OutlineRules {
    std::vector<OutlineRule> fills;
    std::vector<OutlineNode> nodes;
};

OutlineRules chooseOutlines(const FlatScene &scene, double unseen);

/// Tells whether an outline seems to cross itself or goes round the same points twice, from places beside some hundred
/// of its nodes.
bool crossesItself(const FlatScene &scene, const OutlineRules &rules, const OutlineRule &rule);

/// A fill's node in pixels: its place, and dy.
struct OutlinePlace {
    double x, y, rise;
};

/// The sense in which a fill's outline goes round: what makes its density positive, 1 or −1.
double senseOf(const std::vector<OutlinePlace> &places);

} // namespace suffuse::gradient
